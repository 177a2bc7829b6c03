#include <foldless/images/read_image.h>

#include "images.h"
#include "raw_png.h"
#include "sample_exr.h"
#include "sample_jpeg.h"

#include <foldless/images/write_png.h>

#include <OpenEXR/ImfTileDescription.h>

#include <gtest/gtest.h>

#include <random>

namespace foldless {
namespace {

struct Sample {
    const char* name;
    std::string bytes;
};

std::string exr_sample(Imf::Compression compression, Imf::PixelType type, bool tiled) {
    Imf::Header header = exr_header({{-3, 2}, {20, 40}}, "RGB", type);
    header.compression() = compression;
    if (tiled) {
        header.setTileDescription(Imf::TileDescription(8, 16));
    }
    return exr_bytes(header);
}

std::string palette_png(bool interlaced) {
    const std::string chunks =
        png_chunk("PLTE", "abcdefghi") + png_chunk("tRNS", "ab") + png_chunk("tEXt", std::string("key\0text", 8));
    return bytes_of({5, 3, 2, 3, {0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2}, interlaced, chunks});
}

const std::vector<Sample>& samples() {
    static const std::vector<Sample> samples{
        {"a.exr", exr_sample(Imf::ZIP_COMPRESSION, Imf::FLOAT, false)},
        {"b.exr", exr_sample(Imf::RLE_COMPRESSION, Imf::UINT, false)},
        {"c.exr", exr_sample(Imf::PIZ_COMPRESSION, Imf::HALF, true)},
        {"d.exr", exr_sample(Imf::NO_COMPRESSION, Imf::HALF, true)},
        {"e.exr", exr_sample(Imf::PXR24_COMPRESSION, Imf::FLOAT, false)},
        {"f.exr", exr_sample(Imf::B44A_COMPRESSION, Imf::HALF, false)},
        {"g.exr", exr_sample(Imf::DWAA_COMPRESSION, Imf::HALF, false)},
        {"a.png", png_bytes(slope(9, 5, {"R", "G", "B"}), {16, PngColour::srgb}, {{"key", "\u2211"}})},
        {"b.png", palette_png(false)},
        {"c.png", palette_png(true)},
        {"a.jpg", jpeg_bytes(slope(19, 17, {"R", "G", "B"}), {false, false})},
        {"b.jpg", jpeg_bytes(slope(19, 17, {"Y"}), {true, false})},
    };
    return samples;
}

/// Whether the bytes are read. They must be refused in one line otherwise.
bool is_read(const std::filesystem::path& path) {
    try {
        require_sound(read_image(path).image);
        return true;
    } catch (const UnreadableFile& error) {
        EXPECT_EQ(std::string(error.what()).find_first_of("\n\r"), std::string::npos) << error.what();
        return false;
    }
}

TEST(DamagedImage, SamplesAreWholeBeforeTheyAreDamaged) {
    const TemporaryFolder folder;
    for (const auto& [name, bytes] : samples()) {
        EXPECT_TRUE(is_read(folder.file(name, bytes))) << name;
    }
}

TEST(DamagedImage, CutAnywhereIsRefused) {
    const TemporaryFolder folder;
    for (const auto& [name, bytes] : samples()) {
        const std::size_t step = 1 + bytes.size() / 500;
        for (std::size_t size = 0; size < bytes.size(); size += step) {
            EXPECT_FALSE(is_read(folder.file(name, bytes.substr(0, size)))) << name << " " << size;
        }
        EXPECT_FALSE(is_read(folder.file(name, bytes.substr(0, bytes.size() - 1)))) << name;
    }
}

TEST(DamagedImage, IsReadOrRefusedInOneLine) {
    constexpr int rounds = 500;
    std::mt19937 random(20231101);
    const TemporaryFolder folder;
    for (const auto& [name, bytes] : samples()) {
        for (int round = 0; round < rounds; ++round) {
            SCOPED_TRACE(testing::Message() << name << " in round " << round);
            std::string damaged = bytes;
            // Half of the damage goes to the header.
            const std::size_t end = round % 2 == 0 ? damaged.size() : std::min<std::size_t>(damaged.size(), 400);
            for (std::size_t changes = 1 + random() % 3; changes > 0; --changes) {
                damaged[random() % end] ^= static_cast<char>(round % 3 == 0 ? 1U << random() % 8 : random() % 256);
            }
            static_cast<void>(is_read(folder.file(name, damaged)));
        }
    }
}

TEST(DamagedImage, UnderAnotherNameIsRefused) {
    const TemporaryFolder folder;
    for (const auto& [name, bytes] : samples()) {
        for (const std::string other : {".exr", ".png", ".jpg"}) {
            EXPECT_EQ(is_read(folder.file("x" + other, bytes)), std::string_view(name).ends_with(other)) << name;
        }
    }
}

} // namespace
} // namespace foldless
