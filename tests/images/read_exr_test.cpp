#include <foldless/images/read_exr.h>

#include "images.h"
#include "sample_exr.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfTileDescription.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foldless {
namespace {

using Names = std::vector<std::string>;
using testing::HasSubstr;

const Imath::Box2i window({-7, 1000}, {63, 1289}); // 71 x 290

/// `order` names the channels in the order of the file, which is that of sample_at(), by their place in the image.
void expect_samples(const Image& image, const std::vector<int>& order) {
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            for (std::size_t c = 0; c < order.size(); ++c) {
                const float value = image.values[(y * image.width + x) * order.size() + c];
                ASSERT_EQ(value, static_cast<float>(sample_at(x, y, order[c]))) << x << " " << y << " " << c;
            }
        }
    }
}

TEST(ReadExr, ReadsEveryPixelTypeAndLosslessCompressionInAnyWindow) {
    for (const auto compression : {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION,
                                   Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION}) {
        for (const auto type : {Imf::HALF, Imf::FLOAT, Imf::UINT}) {
            for (const bool tiled : {false, true}) {
                Imf::Header header = exr_header(window, "RGBA", type);
                header.compression() = compression;
                if (tiled) {
                    header.setTileDescription(Imf::TileDescription(32, 16, Imf::MIPMAP_LEVELS));
                }
                SCOPED_TRACE(testing::Message() << compression << " " << type << " " << tiled);
                const Image image = image_of("a.exr", exr_bytes(header)).image;
                EXPECT_EQ(image.width, 71);
                EXPECT_EQ(image.height, 290);
                EXPECT_EQ(image.channels, (Names{"R", "G", "B", "A"}));
                expect_samples(image, {3, 2, 1, 0});
            }
        }
    }
}

TEST(ReadExr, ReadsLossyCompression) {
    for (const auto compression : {Imf::PXR24_COMPRESSION, Imf::B44_COMPRESSION, Imf::B44A_COMPRESSION,
                                   Imf::DWAA_COMPRESSION, Imf::DWAB_COMPRESSION}) {
        Imf::Header header = exr_header(window, "Y", Imf::HALF);
        header.compression() = compression;
        const Image image = image_of("a.exr", exr_bytes(header)).image;
        for (int y = 0; y < image.height; ++y) {
            const auto expected = static_cast<float>(sample_at(0, y, 0));
            ASSERT_NEAR(image.values[y * 71], expected, 0.1 * expected + 100) << compression << " " << y;
        }
    }
}

TEST(ReadExr, ReadsImagesThatAreNearlyEmptyAndHighlyCompressed) {
    for (const auto compression :
         {Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION,
          Imf::PXR24_COMPRESSION, Imf::B44A_COMPRESSION, Imf::DWAA_COMPRESSION, Imf::DWAB_COMPRESSION}) {
        for (const auto type : {Imf::HALF, Imf::FLOAT}) {
            Imf::Header header(2048, 2048);
            header.channels().insert("layer.Y", Imf::Channel(type));
            header.channels().insert("Y", Imf::Channel(type));
            header.compression() = compression;
            EXPECT_EQ(image_of("a.exr", flat_exr_bytes(header)).image.values.size(), 2048U * 2048U)
                << compression << " " << type;
        }
    }
}

TEST(ReadExr, LeavesLayersOutAndSortsTheOthers) {
    Imf::Header header(5, 3);
    for (const char* name : {"A", "B", "G", "R", "Z", "diffuse.R", "depth"}) {
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    }
    const Image image = image_of("a.exr", exr_bytes(header)).image;
    EXPECT_EQ(image.channels, (Names{"R", "G", "B", "A", "Z", "depth"}));
    expect_samples(image, {3, 2, 1, 0, 4, 5});
}

TEST(ReadExr, ReadsNumbersAndStringsOfTheHeader) {
    Imf::Header header = exr_header(window, "Y", Imf::FLOAT);
    header.insert("f", Imf::FloatAttribute(0.5F));
    header.insert("i", Imf::IntAttribute(-3));
    Imf::addComments(header, "said");
    Imf::addWhiteLuminance(header, 2);
    Imf::addAdoptedNeutral(header, {1, 2});
    EXPECT_EQ(image_of("a.exr", exr_bytes(header)).metadata,
              (Metadata{{"f", 0.5}, {"i", -3.0}, {"comments", "said"}, {"whiteLuminance", 2.0}}));
}

TEST(ReadExr, NamesWhatItDoesNotRead) {
    const std::string start = "a.exr: not a readable OpenEXR file: ";
    EXPECT_EQ(unreadable_image_text("a.exr", "no EXR"), start + "it does not start like one");
    EXPECT_EQ(unreadable_image_text("a.exr", ""), "a.exr: the file is empty");
    EXPECT_EQ(unreadable_image_text("a.exr", exr_start(0x1000)), start + "it has several parts or is deep");
    EXPECT_EQ(unreadable_image_text("a.exr", exr_start(0x800)), start + "it has several parts or is deep");
    EXPECT_EQ(unreadable_image_text("a.exr", exr_start(0x10000)), start + "its version is unknown");
    EXPECT_EQ(unreadable_image_text("a.exr", exr_start()), start + "its header does not end");

    Imf::Header header(4, 4);
    header.channels().insert("BY", Imf::Channel(Imf::HALF, 2, 2));
    EXPECT_EQ(unreadable_image_text("a.exr", exr_bytes(header)), start + "it has subsampled channels");
    header.channels() = Imf::ChannelList();
    header.channels().insert("layer.Y", Imf::Channel(Imf::HALF));
    EXPECT_EQ(unreadable_image_text("a.exr", exr_bytes(header)), start + "it has no channel outside layers");
}

TEST(ReadExr, NeedsEveryPixel) {
    const std::string start = "a.exr: not a readable OpenEXR file: ";
    for (const bool tiled : {false, true}) {
        Imf::Header header = exr_header(window, "Y", Imf::FLOAT);
        if (tiled) {
            header.setTileDescription(Imf::TileDescription(32, 16));
        }
        const std::string bytes = exr_bytes(header);
        EXPECT_EQ(unreadable_image_text("a.exr", bytes.substr(0, bytes.size() - 1)), start + "it lacks pixels");
    }
    // What a program leaves that is killed while it writes: a table with zeros.
    const std::string begun = exr_start() + required_exr_attributes(8, 8, 3) + std::string(1000, '\0');
    EXPECT_EQ(unreadable_image_text("a.exr", begun), start + "it lacks pixels");
    const std::string no_table = exr_start() + required_exr_attributes(1, 12, 0) + '\0';
    EXPECT_EQ(unreadable_image_text("a.exr", no_table), start + "the file ends too early");
}

TEST(ReadExr, NeedsNoSmallerLevels) {
    Imf::Header header = exr_header(window, "Y", Imf::FLOAT);
    header.setTileDescription(Imf::TileDescription(32, 16, Imf::MIPMAP_LEVELS));
    const std::string bytes = exr_bytes(header);
    EXPECT_EQ(image_of("a.exr", bytes.substr(0, bytes.size() - 1)).image.values, image_of("a.exr", bytes).image.values);
}

} // namespace
} // namespace foldless
