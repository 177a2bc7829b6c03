#include <foldless/images/write_png.h>

#include "images.h"

#include <foldless/images/read_png.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <stdexcept>

namespace foldless {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

constexpr PngFormat eight{8, PngColour::unspecified};
constexpr PngFormat sixteen{16, PngColour::unspecified};

/// What a reader that shares no code with the writer finds.
std::string plainly_read(std::string_view bytes) {
    const TemporaryFolder folder;
    const std::string command =
        std::string(FOLDLESS_PYTHON " " FOLDLESS_PLAIN_PNG " ") + folder.file("a.png", bytes).string();
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
    std::string output;
    std::array<char, 4096> part{};
    for (std::size_t size = 1; size > 0; output.append(part.data(), size)) {
        size = std::fread(part.data(), 1, part.size(), pipe.get());
    }
    return output;
}

TEST(WritePng, RoundsToTheNearestAndCutsWhatIsOutside) {
    const Image image{9, 1, {"Y"}, {0, 1, 0.5F, 0.2F, -1, 2, nan, infinity, -infinity}};
    EXPECT_EQ(plainly_read(png_bytes(image, sixteen, {})),
              "IHDR IDAT IEND\n9 1 16 0\n0 65535 32768 13107 0 65535 0 65535 0\n");
    EXPECT_EQ(plainly_read(png_bytes(image, eight, {})), "IHDR IDAT IEND\n9 1 8 0\n0 255 128 51 0 255 0 255 0\n");
}

TEST(WritePng, GivesEveryValueOfSixteenBitsBack) {
    const Image image = slope(256, 256, {"Y"});
    const Image read = read_png(png_bytes(image, sixteen, {}), "a").image;
    EXPECT_EQ(read.width, 256);
    EXPECT_EQ(read.height, 256);
    EXPECT_EQ(read.values, image.values);
}

TEST(WritePng, IsOffByHalfAStepAtMost) {
    const Image image = slope(1000, 7, {"R", "G", "B"});
    for (const PngFormat& format : {eight, sixteen}) {
        const Image read = read_png(png_bytes(image, format, {}), "a").image;
        const double half = 0.5 / (format.bits == 8 ? 255 : 65535);
        for (std::size_t i = 0; i < image.values.size(); ++i) {
            ASSERT_NEAR(read.values[i], image.values[i], half + 1e-7);
        }
    }
}

TEST(WritePng, TakesItsColourTypeFromTheNumberOfChannels) {
    const std::vector<std::string> names{"a", "b", "c", "d"};
    const char* headers[] = {"2 1 8 0", "2 1 8 4", "2 1 8 2", "2 1 8 6"};
    const char* values[] = {"0 255", "0 85 170 255", "0 51 102 153 204 255", "0 36 73 109 146 182 219 255"};
    for (std::size_t count = 1; count <= names.size(); ++count) {
        const Image image = slope(2, 1, {names.begin(), names.begin() + static_cast<std::ptrdiff_t>(count)});
        EXPECT_EQ(plainly_read(png_bytes(image, eight, {})),
                  std::string("IHDR IDAT IEND\n") + headers[count - 1] + "\n" + values[count - 1] + "\n");
    }
}

TEST(WritePng, SaysHowValuesAreToBeSeen) {
    const Image image = slope(2, 1, {"R", "G", "B"});
    const auto chunks = [&](PngColour colour) {
        const std::string text = plainly_read(png_bytes(image, {8, colour}, {}));
        return text.substr(0, text.find('\n'));
    };
    EXPECT_EQ(chunks(PngColour::unspecified), "IHDR IDAT IEND");
    EXPECT_EQ(chunks(PngColour::srgb), "IHDR sRGB IDAT IEND");
    EXPECT_EQ(chunks(PngColour::linear), "IHDR gAMA IDAT IEND");
    EXPECT_THAT(png_bytes(image, {8, PngColour::linear}, {}), testing::HasSubstr(std::string("gAMA\0\1\x86\xa0", 8)));
}

TEST(WritePng, KeepsMetadata) {
    const Metadata metadata{{"scale", 0.1},
                            {"third", 1.0 / 3},
                            {"least", 4.9406564584124654e-324},
                            {"name", "a b\nc"},
                            {"empty", ""},
                            {"far", std::string(5000, 'x')},
                            {"place", "Z\u00fcrich \u2208"},
                            {"none", double{nan}}};
    const std::string bytes = png_bytes(slope(2, 2, {"Y"}), sixteen, metadata);
    const Metadata read = read_png(bytes, "a").metadata;
    EXPECT_EQ(read.size(), metadata.size());
    for (const char* key : {"scale", "third", "least"}) {
        EXPECT_EQ(number(read, key), number(metadata, key)) << key;
    }
    for (const char* key : {"name", "empty", "far", "place"}) {
        EXPECT_EQ(read.at(key), metadata.at(key)) << key;
    }
    EXPECT_TRUE(std::isnan(number(read, "none").value()));
    EXPECT_THAT(plainly_read(bytes), testing::HasSubstr("place=Z\\xfcrich \\u2208\nscale=0.1\n"));
}

TEST(WritePng, RefusesWhatTheFormatCannotHold) {
    const Image grey = slope(2, 2, {"Y"});
    const auto refused = [](const Image& image, const PngFormat& format, const Metadata& metadata) {
        return message_of<std::invalid_argument>([&] { static_cast<void>(png_bytes(image, format, metadata)); });
    };
    EXPECT_NE(refused(grey, {12, PngColour::unspecified}, {}), "no error");
    EXPECT_NE(refused(slope(2, 2, {"a", "b", "c", "d", "e"}), eight, {}), "no error");
    EXPECT_NE(refused(grey, eight, {{"a", std::string("b\0c", 3)}}), "no error");
    for (const std::string& key : {std::string(), std::string(" a"), std::string("a "), std::string("a  b"),
                                   std::string("a\nb"), std::string("\xfc"), std::string(80, 'a')}) {
        EXPECT_NE(refused(grey, eight, {{key, 1.0}}), "no error") << key;
    }
    EXPECT_EQ(refused(grey, eight, {{std::string(79, 'a'), 1.0}, {"a b:c", 1.0}}), "no error");
    Image broken = grey;
    broken.values.pop_back();
    EXPECT_NE(refused(broken, eight, {}), "no error");
}

TEST(StagePng, AppearsWithTheCommitAndHasTheBytesOfPngBytes) {
    const TemporaryFolder folder;
    const auto path = folder.file("a.png", "old");
    const Image image = slope(300, 200, {"R", "G", "B"});
    AtomicFile file = stage_png(path, image, sixteen, {{"a", 1.5}});
    EXPECT_EQ(bytes_of(path), "old");
    file.commit();
    EXPECT_EQ(bytes_of(path), png_bytes(image, sixteen, {{"a", 1.5}}));
}

TEST(StagePng, LeavesTheOldFileWhereItCannotBeWritten) {
    const TemporaryFolder folder;
    const Image image = slope(3, 2, {"Y"});
    EXPECT_THROW(static_cast<void>(stage_png(folder.path() / "x" / "a.png", image, eight, {})), UnwritableFile);
    const auto path = folder.file("a.png", "old");
    EXPECT_THROW(static_cast<void>(stage_png(path, image, {1, PngColour::srgb}, {})), std::invalid_argument);
    EXPECT_EQ(bytes_of(path), "old");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.png"});
}

} // namespace
} // namespace foldless
