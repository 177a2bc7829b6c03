#include <foldless/images/write_exr.h>

#include <foldless/images/exr_attributes.h>
#include <foldless/io/printable.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace foldless {

namespace {

/// OpenEXR goes back to the table of its chunks when these are written, which an AtomicFile cannot.
class MemoryStream final : public Imf::OStream {
public:
    MemoryStream() : OStream("") {}

    void write(const char bytes[], int count) override {
        const auto size = static_cast<std::size_t>(count);
        bytes_.resize(std::max(bytes_.size(), position_ + size));
        std::copy_n(bytes, size, bytes_.begin() + static_cast<std::ptrdiff_t>(position_));
        position_ += size;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

    [[nodiscard]] std::string_view bytes() const { return bytes_; }

private:
    std::string bytes_;
    std::size_t position_ = 0;
};

void require_name(std::string_view name) {
    if (name.empty() || name.size() > longest_exr_name || name.find('\0') != std::string_view::npos) {
        throw std::invalid_argument(in_quotes(name) + " is no name for a channel or an entry of an OpenEXR file");
    }
}

void insert(Imf::Header& header, const std::string& name, const std::variant<double, std::string>& value) {
    require_name(name);
    if (is_reserved_attribute(name)) {
        throw std::invalid_argument(in_quotes(name) + " means something else to OpenEXR");
    }
    if (const double* real = std::get_if<double>(&value)) {
        header.insert(name, Imf::DoubleAttribute(*real));
    } else {
        header.insert(name, Imf::StringAttribute(std::get<std::string>(value)));
    }
}

Imf::Header header_of(const Image& image, const Metadata& metadata) {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const std::string& channel : image.channels) {
        require_name(channel);
        header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    }
    for (const auto& [name, value] : metadata) {
        insert(header, name, value);
    }
    return header;
}

Imf::FrameBuffer frame_buffer_of(const Image& image, const Imf::Header& header) {
    const std::size_t pixel_size = image.channels.size() * sizeof(float);
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < image.channels.size(); ++c) {
        buffer.insert(image.channels[c], Imf::Slice::Make(Imf::FLOAT, image.values.data() + c, header.dataWindow(),
                                                          pixel_size, pixel_size * image.width));
    }
    return buffer;
}

} // namespace

AtomicFile stage_exr(const std::filesystem::path& path, const Image& image, const Metadata& metadata) {
    require_sound(image);
    const Imf::Header header = header_of(image, metadata);
    AtomicFile file(path); // before the work, which is lost when there is no such folder
    MemoryStream stream;
    {
        constexpr int no_threads_of_its_own = 0;
        Imf::OutputFile output(stream, header, no_threads_of_its_own);
        output.setFrameBuffer(frame_buffer_of(image, header));
        output.writePixels(image.height);
    } // writes the table of the chunks, into bytes that exist
    file.write(stream.bytes());
    return file;
}

} // namespace foldless
