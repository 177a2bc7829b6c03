#include "sample_exr.h"

#include "temporary_folder.h"

#include <foldless/io/byte_order.h>

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfTiledOutputFile.h>

#include <vector>

namespace foldless {

namespace {

std::string sample_bytes(unsigned sample, Imf::PixelType type) {
    std::string bytes;
    switch (type) {
    case Imf::HALF: append_little_endian(bytes, half(float(sample)).bits()); break;
    case Imf::FLOAT: append_little_endian(bytes, float(sample)); break;
    default: append_little_endian(bytes, sample);
    }
    return bytes;
}

/// Every channel by itself.
class Planes {
public:
    Planes(const Imf::Header& header, bool flat) {
        const Imath::Box2i& window = header.dataWindow();
        for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
            const auto& [type, x_step, y_step, linear] = channel.channel();
            std::string& plane = planes_.emplace_back();
            for (int y = 0; y <= window.max.y - window.min.y; y += y_step) {
                for (int x = 0; x <= window.max.x - window.min.x; x += x_step) {
                    plane += sample_bytes(flat ? 0 : sample_at(x, y, static_cast<int>(planes_.size()) - 1), type);
                }
            }
        }
        auto plane = planes_.begin();
        for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel, ++plane) {
            const auto& [type, x_step, y_step, linear] = channel.channel();
            buffer_.insert(channel.name(), Imf::Slice::Make(type, plane->data(), window, 0, 0, x_step, y_step));
        }
    }

    [[nodiscard]] const Imf::FrameBuffer& buffer() const { return buffer_; }

private:
    std::vector<std::string> planes_;
    Imf::FrameBuffer buffer_;
};

void write_tiles(const std::string& path, const Imf::Header& header, const Planes& planes) {
    Imf::TiledOutputFile file(path.c_str(), header, 0);
    file.setFrameBuffer(planes.buffer());
    file.writeTiles(0, file.numXTiles(0) - 1, 0, file.numYTiles(0) - 1, 0);
    // Smaller levels hold anything.
    for (int level = 1; file.levelMode() == Imf::MIPMAP_LEVELS && level < file.numLevels(); ++level) {
        file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
    }
}

std::string written(const Imf::Header& header, const Planes& planes) {
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "a.exr").string();
    if (header.hasTileDescription()) {
        write_tiles(path, header, planes);
    } else {
        Imf::OutputFile file(path.c_str(), header, 0);
        file.setFrameBuffer(planes.buffer());
        file.writePixels(header.dataWindow().max.y - header.dataWindow().min.y + 1);
    }
    return bytes_of(path);
}

} // namespace

unsigned sample_at(int x, int y, int channel) {
    return static_cast<unsigned>(7 * x + 5 * y + 100 * channel) % 2048; // which half holds exactly
}

std::string exr_bytes(const Imf::Header& header) {
    return written(header, Planes(header, false));
}

std::string flat_exr_bytes(const Imf::Header& header) {
    return written(header, Planes(header, true));
}

Imf::Header exr_header(const Imath::Box2i& window, std::string_view channels, Imf::PixelType type) {
    Imf::Header header(window, window);
    for (const char channel : channels) {
        header.channels().insert(std::string(1, channel), Imf::Channel(type));
    }
    return header;
}

std::string exr_start(unsigned flags) {
    std::string bytes = "\x76\x2f\x31\x01";
    append_little_endian(bytes, 2 | flags);
    return bytes;
}

std::string exr_attribute(const std::string& name, const std::string& type, const std::string& value) {
    std::string bytes = name + '\0' + type + '\0';
    append_little_endian(bytes, static_cast<int>(value.size()));
    return bytes + value;
}

std::string required_exr_attributes(int width, int height, char compression) {
    std::string window(8, '\0');
    append_little_endian(window, width - 1);
    append_little_endian(window, height - 1);
    std::string one;
    append_little_endian(one, 1.0F);
    const std::string channel = std::string("Y\0\2\0\0\0\0\0\0\0\1\0\0\0\1\0\0\0\0", 19);
    return exr_attribute("channels", "chlist", channel) +
           exr_attribute("compression", "compression", std::string(1, compression)) +
           exr_attribute("dataWindow", "box2i", window) + exr_attribute("displayWindow", "box2i", window) +
           exr_attribute("lineOrder", "lineOrder", std::string(1, '\0')) +
           exr_attribute("pixelAspectRatio", "float", one) +
           exr_attribute("screenWindowCenter", "v2f", std::string(8, '\0')) +
           exr_attribute("screenWindowWidth", "float", one);
}

} // namespace foldless
