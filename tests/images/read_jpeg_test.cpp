#include <foldless/images/read_jpeg.h>

#include "images.h"
#include "sample_jpeg.h"

#include <gtest/gtest.h>

namespace foldless {
namespace {

using Names = std::vector<std::string>;

constexpr SampleJpeg baseline{};
constexpr SampleJpeg progressive{true, false};

TEST(ReadJpeg, ReadsGreyAndColour) {
    for (const Names& channels : {Names{"Y"}, Names{"R", "G", "B"}}) {
        for (const SampleJpeg& kind : {baseline, progressive}) {
            const Image image = slope(41, 29, channels);
            const ReadImage read = read_jpeg(jpeg_bytes(image, kind), "a");
            EXPECT_EQ(read.image.width, 41);
            EXPECT_EQ(read.image.height, 29);
            EXPECT_EQ(read.image.channels, channels);
            EXPECT_TRUE(read.metadata.empty());
            for (std::size_t i = 0; i < image.values.size(); ++i) {
                ASSERT_NEAR(read.image.values[i], image.values[i], 4.0 / 255) << i;
            }
        }
    }
}

TEST(ReadJpeg, ReadsImagesThatAreNearlyEmptyAndHighlyCompressed) {
    const Image image{4096, 2048, {"R", "G", "B"}, std::vector<float>(std::size_t{4096} * 2048 * 3)};
    EXPECT_EQ(read_jpeg(jpeg_bytes(image, baseline), "a").image.values, image.values);
    EXPECT_EQ(read_jpeg(jpeg_bytes(image, progressive), "a").image.values, image.values);
}

TEST(ReadJpeg, NamesTheFileAndTheReason) {
    const std::string start = "a.jpg: not a readable JPEG file: ";
    EXPECT_EQ(unreadable_image_text("a.jpg", ""), "a.jpg: the file is empty");
    EXPECT_EQ(unreadable_image_text("a.jpg", "no JPEG"), start + "Not a JPEG file: starts with 0x6e 0x6f");
    EXPECT_EQ(unreadable_image_text("a.jpg", jpeg_bytes(slope(8, 8, {"a", "b", "c", "d"}), {false, true})),
              start + "it has inks instead of colours");
    const std::string bytes = jpeg_bytes(slope(8, 8, {"Y"}), baseline);
    EXPECT_EQ(unreadable_image_text("a.jpg", bytes.substr(0, bytes.size() - 2)), start + "Premature end of JPEG file");
}

/// The scan of a progressive file that stands last, as often as wanted.
std::string with_scans_repeated(const std::string& bytes, int times) {
    const std::size_t scan = bytes.rfind("\xff\xda");
    const std::size_t end = bytes.size() - 2;
    std::string result = bytes.substr(0, scan);
    for (int i = 0; i < times; ++i) {
        result += bytes.substr(scan, end - scan);
    }
    return result + bytes.substr(end);
}

TEST(ReadJpeg, RefusesScansWithoutEnd) {
    const std::string bytes = jpeg_bytes(slope(16, 16, {"Y"}), progressive);
    EXPECT_NE(unreadable_image_text("a.jpg", with_scans_repeated(bytes, 1000)), "no error");
}

} // namespace
} // namespace foldless
