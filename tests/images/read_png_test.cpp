#include <foldless/images/read_png.h>

#include "images.h"
#include "raw_png.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace foldless {
namespace {

using Names = std::vector<std::string>;

std::vector<std::uint32_t> drawn_samples(std::size_t count, int bits) {
    std::mt19937 random(7);
    std::vector<std::uint32_t> samples;
    for (std::size_t i = 0; i < count; ++i) {
        samples.push_back(static_cast<std::uint32_t>(random()) >> (32 - bits));
    }
    return samples;
}

std::vector<float> scaled(const std::vector<std::uint32_t>& samples, int bits) {
    std::vector<float> values;
    for (const std::uint32_t sample : samples) {
        values.push_back(static_cast<float>(sample) / static_cast<float>((1U << bits) - 1));
    }
    return values;
}

struct Kind {
    int colour_type;
    int bits;
    Names channels;
};

const Kind kinds[] = {
    {0, 1, {"Y"}},
    {0, 2, {"Y"}},
    {0, 4, {"Y"}},
    {0, 8, {"Y"}},
    {0, 16, {"Y"}},
    {4, 8, {"Y", "A"}},
    {4, 16, {"Y", "A"}},
    {2, 8, {"R", "G", "B"}},
    {2, 16, {"R", "G", "B"}},
    {6, 8, {"R", "G", "B", "A"}},
    {6, 16, {"R", "G", "B", "A"}},
};

TEST(ReadPng, ScalesEveryColourTypeAndDepth) {
    for (const Kind& kind : kinds) {
        const auto samples = drawn_samples(13 * 11 * kind.channels.size(), kind.bits);
        const ReadImage read = read_png(bytes_of({13, 11, kind.bits, kind.colour_type, samples, false, ""}), "a");
        EXPECT_EQ(read.image.channels, kind.channels);
        EXPECT_EQ(read.image.values, scaled(samples, kind.bits)) << kind.colour_type << " " << kind.bits;
    }
}

TEST(ReadPng, PutsInterlacedPixelsInTheirPlaces) {
    for (const Kind& kind : kinds) {
        for (const std::uint32_t width : {1U, 2U, 4U, 5U, 8U, 9U, 17U}) {
            for (const std::uint32_t height : {1U, 2U, 3U, 5U, 8U, 17U}) {
                const auto samples = drawn_samples(width * height * kind.channels.size(), kind.bits);
                const RawPng png{width, height, kind.bits, kind.colour_type, samples, true, ""};
                ASSERT_EQ(read_png(bytes_of(png), "a").image.values, scaled(samples, kind.bits))
                    << kind.colour_type << " " << kind.bits << " " << width << " " << height;
            }
        }
    }
}

TEST(ReadPng, ExpandsPalettesAndTheirAlpha) {
    const std::string palette = png_chunk("PLTE", std::string("\0\0\0\xff\0\0\0\xff\0\x33\x66\x99", 12));
    const std::vector<float> colours{0, 0, 0, 1, 0, 0, 0, 1, 0, 0.2F, 0.4F, 0.6F};
    for (const bool interlaced : {false, true}) {
        for (const int bits : {2, 4, 8}) {
            const Image opaque = read_png(bytes_of({4, 1, bits, 3, {0, 1, 2, 3}, interlaced, palette}), "a").image;
            EXPECT_EQ(opaque.channels, (Names{"R", "G", "B"}));
            EXPECT_EQ(opaque.values, colours);
        }
    }
    const std::string alpha = png_chunk("tRNS", std::string("\xff\x33", 2));
    const Image image = read_png(bytes_of({2, 2, 2, 3, {3, 1, 0, 2}, false, palette + alpha}), "a").image;
    EXPECT_EQ(image.channels, (Names{"R", "G", "B", "A"}));
    EXPECT_EQ(image.values, (std::vector<float>{0.2F, 0.4F, 0.6F, 1, 1, 0, 0, 0.2F, 0, 0, 0, 1, 0, 1, 0, 1}));
}

TEST(ReadPng, MakesAlphaOfATransparentColour) {
    const std::string grey = png_chunk("tRNS", std::string("\0\2", 2));
    const Image two_bits = read_png(bytes_of({4, 1, 2, 0, {0, 1, 2, 3}, false, grey}), "a").image;
    EXPECT_EQ(two_bits.channels, (Names{"Y", "A"}));
    EXPECT_EQ(two_bits.values, (std::vector<float>{0, 1, 1.0F / 3, 1, 2.0F / 3, 0, 1, 1}));
    const std::string colour = png_chunk("tRNS", std::string("\0\1\0\2\0\3", 6));
    const Image eight_bits = read_png(bytes_of({2, 1, 8, 2, {1, 2, 3, 1, 2, 4}, false, colour}), "a").image;
    EXPECT_EQ(eight_bits.channels, (Names{"R", "G", "B", "A"}));
    EXPECT_EQ(eight_bits.values[3], 0);
    EXPECT_EQ(eight_bits.values[7], 1);
}

TEST(ReadPng, ReadsTextsAsUtf8AndTheFirstOfEachKey) {
    const std::string chunks = png_chunk("tEXt", std::string("scale\0"
                                                             "0.25",
                                                             10)) +
                               png_chunk("tEXt", std::string("scale\0"
                                                             "0.5",
                                                             9)) +
                               png_chunk("tEXt", std::string("place\0Z\xfcrich", 12)) +
                               png_chunk("iTXt", std::string("sum\0\0\0\0\0\xe2\x88\x91", 11));
    const Metadata metadata = read_png(bytes_of({1, 1, 8, 0, {9}, false, chunks}), "a").metadata;
    EXPECT_EQ(metadata, (Metadata{{"scale", "0.25"}, {"place", "Z\u00fcrich"}, {"sum", "\u2211"}}));
    EXPECT_EQ(number(metadata, "scale"), 0.25);
}

TEST(ReadPng, IgnoresWhatItSaysOfGamma) {
    const std::string chunks = png_chunk("gAMA", std::string("\0\0\xb1\x8f", 4));
    EXPECT_EQ(read_png(bytes_of({1, 1, 8, 0, {51}, false, chunks}), "a").image.values, std::vector<float>{0.2F});
}

TEST(ReadPng, NamesTheFileAndTheReason) {
    EXPECT_EQ(unreadable_image_text("a.png", "no PNG at all"),
              "a.png: not a readable PNG file: it does not start like one");
    EXPECT_EQ(unreadable_image_text("a.png", ""), "a.png: the file is empty");
    EXPECT_EQ(message_of<UnreadableFile>([] { static_cast<void>(read_png("\x89PNG\r\n\x1a\n", "b\n.glb")); }),
              "b?.glb: not a readable PNG file: the file ends too early");
    std::string bytes = bytes_of({2, 2, 8, 0, {1, 2, 3, 4}, false, ""});
    bytes[bytes.find("IDAT") + 12] ^= 1;
    EXPECT_THAT(unreadable_image_text("a.png", bytes), testing::HasSubstr("a.png: not a readable PNG file: IDAT: "));
}

} // namespace
} // namespace foldless
