#include <foldless/images/write_exr.h>

#include "images.h"

#include <foldless/images/read_exr.h>

#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

namespace foldless {
namespace {

using Limits = std::numeric_limits<float>;

std::string written(const Image& image, const Metadata& metadata) {
    const TemporaryFolder folder;
    stage_exr(folder.path() / "a.exr", image, metadata).commit();
    return bytes_of(folder.path() / "a.exr");
}

TEST(WriteExr, GivesEveryBitBack) {
    const std::vector<float> odd{0,
                                 -0.0F,
                                 Limits::denorm_min(),
                                 -Limits::min() / 2,
                                 Limits::max(),
                                 Limits::infinity(),
                                 -Limits::infinity(),
                                 Limits::quiet_NaN(),
                                 -Limits::quiet_NaN(),
                                 std::bit_cast<float>(0x7f800001U)}; // a signalling NaN
    const Image image{5, 2, {"Y"}, odd};
    const Image read = image_of("a.exr", written(image, {})).image;
    EXPECT_EQ(read.width, 5);
    EXPECT_EQ(read.height, 2);
    EXPECT_EQ(bits_of(read.values), bits_of(odd));
}

TEST(WriteExr, GivesAnyImageBack) {
    std::mt19937 random(3);
    const std::vector<std::string> names{"R", "G", "B", "A", "X", "Z"};
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 300}, {300, 1}, {65, 517}}) {
        for (std::size_t count = 1; count <= names.size(); ++count) {
            Image image = slope(width, height, {names.begin(), names.begin() + static_cast<std::ptrdiff_t>(count)});
            for (float& value : image.values) {
                value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
            }
            const Image read = image_of("a.exr", written(image, {})).image;
            ASSERT_EQ(read.channels, image.channels);
            ASSERT_EQ(bits_of(read.values), bits_of(image.values)) << width << " " << height << " " << count;
        }
    }
}

TEST(WriteExr, KeepsMetadataAsAttributes) {
    const Metadata metadata{{"foldless:scale", 0.1},
                            {"foldless:base", "Z\u00fcrich\nb"},
                            {"empty", ""},
                            {"owner", "nobody"},
                            {std::string(255, 'n'), 1e300}};
    const TemporaryFolder folder;
    const auto path = folder.path() / "a.exr";
    stage_exr(path, slope(3, 3, {"Y"}), metadata).commit();
    EXPECT_EQ(read_exr(path).metadata, metadata);
    const Imf::InputFile file(path.c_str());
    EXPECT_EQ(file.header().typedAttribute<Imf::DoubleAttribute>("foldless:scale").value(), 0.1);
    EXPECT_EQ(file.header().typedAttribute<Imf::StringAttribute>("owner").value(), "nobody");
    EXPECT_EQ(file.header().compression(), Imf::ZIP_COMPRESSION);
}

TEST(WriteExr, DependsNeitherOnThreadsNorOnTheName) {
    const Image image = slope(200, 500, {"R", "G", "B"});
    const std::string alone = written(image, {{"a", 1.0}});
    Imf::setGlobalThreadCount(4);
    EXPECT_EQ(written(image, {{"a", 1.0}}), alone);
    Imf::setGlobalThreadCount(0);
}

TEST(WriteExr, RefusesWhatTheFormatCannotHold) {
    const TemporaryFolder folder;
    const auto path = folder.file("a.exr", "old");
    const auto refused = [&](const Image& image, const Metadata& metadata) {
        return message_of<std::invalid_argument>([&] { static_cast<void>(stage_exr(path, image, metadata)); });
    };
    const Image image = slope(2, 2, {"Y"});
    for (const std::string& name :
         {std::string(), std::string(256, 'a'), std::string("a\0b", 3), std::string("channels"), std::string("type")}) {
        EXPECT_NE(refused(image, {{name, 1.0}}), "no error") << name;
    }
    EXPECT_NE(refused(slope(2, 2, {""}), {}), "no error");
    EXPECT_NE(refused({2, 2, {"Y"}, {1}}, {}), "no error");
    EXPECT_EQ(bytes_of(path), "old");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.exr"});
}

TEST(StageExr, AppearsWithTheCommitOnly) {
    const TemporaryFolder folder;
    const auto path = folder.file("a.exr", "old");
    {
        const AtomicFile file = stage_exr(path, slope(2, 2, {"Y"}), {});
        EXPECT_EQ(bytes_of(path), "old");
    }
    EXPECT_EQ(bytes_of(path), "old");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.exr"});
    EXPECT_THROW(static_cast<void>(stage_exr(folder.path() / "x" / "a.exr", slope(2, 2, {"Y"}), {})), UnwritableFile);
}

} // namespace
} // namespace foldless
