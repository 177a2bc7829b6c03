#include <foldless/images/read_exr.h>

#include <foldless/images/exr_attributes.h>
#include <foldless/images/exr_header.h>
#include <foldless/images/rows.h>
#include <foldless/images/unreadable_image.h>
#include <foldless/io/file_bytes.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <new>
#include <optional>
#include <string>
#include <utility>

namespace foldless {

namespace {

/// Lines read at once: as many as the largest chunk has, so that no chunk is decoded twice.
constexpr int block_height = 256;

std::vector<std::string> channel_names(const Imf::ChannelList& channels) {
    std::vector<std::string> names;
    for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
        if (std::string_view(channel.name()).find('.') == std::string_view::npos) {
            names.emplace_back(channel.name());
        }
    }
    if (names.empty()) {
        throw RefusedExr("it has no channel outside layers");
    }
    // The file has them by name, A and B before G and R.
    constexpr std::string_view first = "RGBYA";
    const auto rank = [first](const std::string& name) {
        return name.size() == 1 ? std::min(first.find(name), first.size()) : first.size();
    };
    std::ranges::stable_sort(names, {}, rank);
    return names;
}

std::optional<std::variant<double, std::string>> value_of(const Imf::Attribute& attribute) {
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute)) {
        return text->value();
    }
    if (const auto* real = dynamic_cast<const Imf::DoubleAttribute*>(&attribute)) {
        return real->value();
    }
    if (const auto* real = dynamic_cast<const Imf::FloatAttribute*>(&attribute)) {
        return double(real->value());
    }
    if (const auto* integer = dynamic_cast<const Imf::IntAttribute*>(&attribute)) {
        return double(integer->value());
    }
    return std::nullopt;
}

Metadata metadata_of(const Imf::Header& header) {
    Metadata metadata;
    for (auto entry = header.begin(); entry != header.end(); ++entry) {
        if (is_reserved_attribute(entry.name())) {
            continue;
        }
        if (auto value = value_of(entry.attribute())) {
            metadata.emplace(entry.name(), std::move(*value));
        }
    }
    return metadata;
}

Imf::FrameBuffer frame_buffer_of(const Image& image, float* values, const Imath::Box2i& window) {
    const std::size_t pixel_size = image.channels.size() * sizeof(float);
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < image.channels.size(); ++c) {
        buffer.insert(image.channels[c],
                      Imf::Slice::Make(Imf::FLOAT, values + c, window, pixel_size, pixel_size * image.width));
    }
    return buffer;
}

void read_values(std::string_view bytes, const Imath::Box2i& window, Image& image) {
    ExrStream stream(bytes);
    constexpr int no_threads_of_its_own = 0;
    Imf::InputFile input(stream, no_threads_of_its_own);
    Rows rows(image);
    input.setFrameBuffer(frame_buffer_of(image, rows.reach(0), window));
    for (int y = 0; y < image.height; y += block_height) {
        const int last = std::min(y + block_height, image.height) - 1;
        rows.reach(last);
        input.readPixels(window.min.y + y, window.min.y + last);
    }
}

ReadImage read(std::string_view bytes) {
    const Imf::Header header = read_exr_header(bytes);
    const Imath::Box2i& window = header.dataWindow();
    ReadImage result{
        {window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, channel_names(header.channels()), {}},
        metadata_of(header)};
    read_values(bytes, window, result.image);
    return result;
}

} // namespace

ReadImage read_exr(const std::filesystem::path& path) {
    const FileBytes file(path);
    try {
        return read(file.bytes());
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw unreadable_image(path.string(), "OpenEXR", error.what());
    }
}

} // namespace foldless
