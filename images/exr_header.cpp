#include <foldless/images/exr_header.h>

#include <foldless/images/exr_attributes.h>
#include <foldless/images/image_size.h>
#include <foldless/io/byte_order.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfTileDescription.h>
#include <OpenEXR/ImfVersion.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace foldless {

namespace {

constexpr std::size_t start_size = 8; // the magic number, and the version with its flags

/// A chunk is a block of scan lines or a tile: at least an offset of 8 bytes in the table, and 8 bytes before its
/// pixels.
constexpr double least_chunk_size = 16;

/// Bytes of decoded chunks side by side that a file of any size may need.
constexpr double free_band_size = 64 << 20;

/// What a compression joins in a chunk, and how many bytes of pixels a byte of the file can stand for.
struct Packing {
    int lines = 1;
    double most_expansion = 1;
};

// deflate copies 258 bytes by two bits at best.
constexpr double deflate_expansion = 1032;

Packing packing_of(Imf::Compression compression) {
    switch (compression) {
    case Imf::NO_COMPRESSION: return {1, 1};
    case Imf::RLE_COMPRESSION: return {1, 64}; // runs of 128 in two bytes
    case Imf::ZIPS_COMPRESSION: return {1, deflate_expansion};
    case Imf::ZIP_COMPRESSION: return {16, deflate_expansion};
    case Imf::PIZ_COMPRESSION: return {32, 410};                           // 256 words of two bytes in ten bits
    case Imf::PXR24_COMPRESSION: return {16, 4.0 / 3 * deflate_expansion}; // four bytes become three first
    case Imf::B44_COMPRESSION:
    case Imf::B44A_COMPRESSION: return {32, 32.0 / 3};               // 16 halves in three bytes
    case Imf::DWAA_COMPRESSION: return {32, 64 * deflate_expansion}; // 64 pixels become one word first
    case Imf::DWAB_COMPRESSION: return {256, 64 * deflate_expansion};
    default: throw RefusedExr("its compression is unknown");
    }
}

/// The place behind a name that ends with a null.
std::size_t end_of_name(std::string_view bytes, std::size_t at) {
    const std::size_t end = bytes.find('\0', at);
    if (end == std::string_view::npos || end - at > longest_exr_name) {
        throw RefusedExr("its header does not end");
    }
    return end + 1;
}

/// OpenEXR takes the memory that an attribute claims before it looks for the bytes.
void require_attributes_within(std::string_view bytes) {
    std::size_t at = start_size;
    while (at < bytes.size() && bytes[at] != '\0') {
        at = end_of_name(bytes, end_of_name(bytes, at)); // its name and its type
        if (bytes.size() - at < sizeof(std::int32_t)) {
            throw RefusedExr("its header does not end");
        }
        const auto size = load<std::int32_t>(bytes.data() + at, std::endian::little);
        at += sizeof size;
        if (size < 0 || static_cast<std::size_t>(size) > bytes.size() - at) {
            throw RefusedExr("an attribute of its header is longer than the file");
        }
        at += static_cast<std::size_t>(size);
    }
    if (at >= bytes.size()) {
        throw RefusedExr("its header does not end");
    }
}

int version_of(std::string_view bytes) {
    if (bytes.size() < start_size || !Imf::isImfMagic(bytes.data())) {
        throw RefusedExr("it does not start like one");
    }
    const auto version = load<std::int32_t>(bytes.data() + sizeof(std::int32_t), std::endian::little);
    if (Imf::getVersion(version) != Imf::EXR_VERSION || !Imf::supportsFlags(Imf::getFlags(version))) {
        throw RefusedExr("its version is unknown");
    }
    if (Imf::isMultiPart(version) || Imf::isNonImage(version)) {
        throw RefusedExr("it has several parts or is deep");
    }
    return version;
}

/// Numbers of a header as doubles: products of what is claimed cannot overflow.
struct Claims {
    double width = 0;
    double height = 0;
    double channels = 0;
    double pixel_size = 0;  ///< bytes, decoded but not converted
    double chunk_width = 0; ///< pixels
    double chunk_height = 0;

    [[nodiscard]] double chunks() const { return std::ceil(width / chunk_width) * std::ceil(height / chunk_height); }
    [[nodiscard]] double size() const { return width * height * pixel_size; }
    /// All chunks side by side, as float32.
    [[nodiscard]] double band_size() const { return std::max(width, chunk_width) * chunk_height * channels * 4; }
};

Claims claims_of(const Imf::Header& header, bool tiled) {
    const Imath::Box2i& window = header.dataWindow();
    Claims claims;
    claims.width = double(window.max.x) - window.min.x + 1;
    claims.height = double(window.max.y) - window.min.y + 1;
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
        ++claims.channels;
        claims.pixel_size += channel.channel().type == Imf::HALF ? 2 : 4;
    }
    claims.chunk_width = tiled ? header.tileDescription().xSize : claims.width;
    claims.chunk_height = tiled ? header.tileDescription().ySize : packing_of(header.compression()).lines;
    return claims;
}

void require_credible(const Claims& claims, Imf::Compression compression, std::size_t file_size) {
    const ImageSize size{static_cast<std::uint64_t>(claims.width), static_cast<std::uint64_t>(claims.height),
                         static_cast<std::size_t>(claims.channels)};
    if (const std::string reason = refused_size_text(size); !reason.empty()) {
        throw RefusedExr(reason);
    }
    const double most_expansion = packing_of(compression).most_expansion;
    if (const std::string reason = refused_expansion_text(claims.size(), file_size, most_expansion); !reason.empty()) {
        throw RefusedExr(reason);
    }
    if (claims.chunks() * least_chunk_size > static_cast<double>(file_size)) {
        throw RefusedExr("the header claims more tiles or blocks of lines than the file can hold");
    }
    if (claims.band_size() > std::max(free_band_size, 4 * claims.width * claims.height * claims.channels)) {
        throw RefusedExr("its tiles or blocks of lines are larger than the image");
    }
}

void require_full_resolution(const Imf::ChannelList& channels) {
    for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
        if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1) {
            throw RefusedExr("it has subsampled channels");
        }
    }
}

/// Each chunk lies within the file and is not empty: OpenEXR takes an empty one, and hands out what was in its memory.
/// Of tiles the largest level comes first.
void require_chunks(std::string_view bytes, std::size_t table, std::size_t count, bool tiled) {
    const std::size_t place_size = tiled ? 16 : 4; // where it belongs in the image
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t entry = table + i * sizeof(std::uint64_t);
        if (entry + sizeof(std::uint64_t) > bytes.size()) {
            throw RefusedExr("the file ends too early");
        }
        const auto offset = load<std::uint64_t>(bytes.data() + entry, std::endian::little);
        const std::uint64_t start = offset + place_size + sizeof(std::int32_t);
        if (offset == 0 || offset > bytes.size() || start > bytes.size()) {
            throw RefusedExr("it lacks pixels");
        }
        const auto size = load<std::int32_t>(bytes.data() + start - sizeof(std::int32_t), std::endian::little);
        if (size <= 0 || static_cast<std::uint64_t>(size) > bytes.size() - start) {
            throw RefusedExr("it lacks pixels");
        }
    }
}

} // namespace

bool ExrStream::read(char bytes[], int count) {
    if (count < 0 || position_ > bytes_.size() || static_cast<std::size_t>(count) > bytes_.size() - position_) {
        throw std::out_of_range("the file ends too early");
    }
    std::memcpy(bytes, bytes_.data() + position_, static_cast<std::size_t>(count));
    position_ += static_cast<std::size_t>(count);
    return position_ < bytes_.size();
}

Imf::Header read_exr_header(std::string_view bytes) {
    int version = version_of(bytes);
    require_attributes_within(bytes);
    ExrStream stream(bytes);
    stream.seekg(start_size);
    Imf::Header header;
    header.readFrom(stream, version);
    header.sanityCheck(Imf::isTiled(version));
    require_full_resolution(header.channels());
    const Claims claims = claims_of(header, Imf::isTiled(version));
    require_credible(claims, header.compression(), bytes.size());
    require_chunks(bytes, stream.tellg(), static_cast<std::size_t>(claims.chunks()), Imf::isTiled(version));
    return header;
}

} // namespace foldless
