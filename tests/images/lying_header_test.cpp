#include <foldless/images/read_image.h>

#include "images.h"
#include "raw_png.h"
#include "sample_exr.h"
#include "sample_jpeg.h"

#include <foldless/io/byte_order.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/resource.h>

namespace foldless {
namespace {

using testing::HasSubstr;

/// The most memory that the process ever had, in KiB.
long peak_memory() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

// The address sanitizer marks what is reserved but not yet used: an eighth of the 4 GiB of the largest image.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define FOLDLESS_RESERVED_MEMORY_IS_MARKED
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define FOLDLESS_RESERVED_MEMORY_IS_MARKED
#endif
#ifdef FOLDLESS_RESERVED_MEMORY_IS_MARKED
constexpr long little_memory = (64 + 512) << 10; // KiB
#else
constexpr long little_memory = 64 << 10; // KiB; each lie claims gigabytes
#endif

std::string number_bytes(std::initializer_list<std::int32_t> numbers) {
    std::string bytes;
    for (const std::int32_t value : numbers) {
        append_little_endian(bytes, value);
    }
    return bytes;
}

/// A file with a header and `size` bytes behind it that mean nothing.
std::string exr_of(const std::string& attributes, unsigned flags = 0, std::size_t size = 1000) {
    return exr_start(flags) + attributes + std::string(1 + size, '\0');
}

TEST(LyingHeader, OfPngTakesNoMemory) {
    const long before = peak_memory();
    const auto claimed = [](std::uint32_t width, std::uint32_t height, int bits) {
        return unreadable_image_text("a.png", bytes_of({width, height, bits, 6, {}, false, ""}));
    };
    EXPECT_EQ(claimed(16384, 16384, 16),
              "a.png: not a readable PNG file: the header claims 2147483648 bytes of pixels, "
              "more than a file of 68 bytes can hold");
    EXPECT_EQ(claimed(65537, 1, 8), "a.png: not a readable PNG file: 65537 x 1 pixels; a side may have 65536 at most");
    EXPECT_THAT(claimed(65536, 65536, 8), HasSubstr("an image may have 1073741824 values at most"));
    EXPECT_NE(claimed(0x7fffffff, 0x7fffffff, 16), "no error");
    EXPECT_NE(claimed(0, 1, 16), "no error");
    EXPECT_LT(peak_memory() - before, little_memory);
}

TEST(LyingHeader, OfPngChunksTakesNoMemory) {
    const long before = peak_memory();
    for (const char* kind : {"tEXt", "zTXt", "iCCP", "teSt", "PLTE", "IDAT"}) {
        std::string lie = png_chunk(kind, "");
        lie.replace(0, 4, "\x7f\xff\xff\xff");
        EXPECT_EQ(unreadable_image_text("a.png", bytes_of({1, 1, 8, 0, {1}, false, lie})),
                  "a.png: not a readable PNG file: the file ends too early");
    }
    EXPECT_LT(peak_memory() - before, little_memory);
}

TEST(LyingHeader, OfPngTakesMemoryAsRowsArrive) {
    const long before = peak_memory();
    const std::string padding = png_chunk("teSt", std::string(2 << 20, 'x')); // room for what the header claims
    for (const bool interlaced : {false, true}) {
        EXPECT_NE(unreadable_image_text("a.png", bytes_of({16384, 16384, 8, 6, {}, interlaced, padding})), "no error");
    }
    EXPECT_LT(peak_memory() - before, little_memory);
}

TEST(LyingHeader, OfJpegTakesNoMemory) {
    const long before = peak_memory();
    for (const bool progressive : {false, true}) {
        std::string bytes = jpeg_bytes(slope(16, 16, {"R", "G", "B"}), {progressive, false});
        const std::size_t frame = bytes.find(progressive ? "\xff\xc2" : "\xff\xc0");
        bytes.replace(frame + 5, 4, "\x40\x00\x40\x00", 4); // height and width
        EXPECT_THAT(unreadable_image_text("a.jpg", bytes), HasSubstr("the header claims 268435456 bytes of pixels"));
        bytes.replace(frame + 5, 4, "\xff\xdc\xff\xdc", 4);
        EXPECT_THAT(unreadable_image_text("a.jpg", bytes), HasSubstr("an image may have 1073741824 values at most"));
    }
    EXPECT_LT(peak_memory() - before, little_memory);
}

TEST(LyingHeader, OfExrTakesNoMemory) {
    const long before = peak_memory();
    const auto claimed = [](int width, int height, char compression) {
        return unreadable_image_text("a.exr", exr_of(required_exr_attributes(width, height, compression)));
    };
    constexpr char none = 0;
    constexpr char zip = 3;
    constexpr char dwab = 9;
    EXPECT_THAT(claimed(16384, 16384, none), HasSubstr("the header claims 1073741824 bytes of pixels"));
    EXPECT_THAT(claimed(16384, 16384, zip), HasSubstr("the header claims 1073741824 bytes of pixels"));
    EXPECT_THAT(claimed(1, 60000, zip), HasSubstr("more tiles or blocks of lines than the file can hold"));
    EXPECT_THAT(claimed(16384, 16384, dwab), HasSubstr("the header claims"));
    EXPECT_THAT(claimed(65537, 1, zip), HasSubstr("a side may have 65536 at most"));
    EXPECT_NE(claimed(0x7fffffff, 0x7fffffff, zip), "no error");
    EXPECT_NE(claimed(0, 1, zip), "no error");
    EXPECT_NE(claimed(1, -5, zip), "no error");
    EXPECT_THAT(claimed(8, 8, 77), HasSubstr("a.exr: not a readable OpenEXR file: "));
    EXPECT_LT(peak_memory() - before, little_memory);
}

TEST(LyingHeader, OfExrTilesTakesNoMemory) {
    const long before = peak_memory();
    const auto claimed = [](int size, std::int32_t tile_width, std::int32_t tile_height, char mode) {
        const std::string tiles = number_bytes({tile_width, tile_height}) + mode;
        return unreadable_image_text(
            "a.exr", exr_of(required_exr_attributes(size, size, 3) + exr_attribute("tiles", "tiledesc", tiles), 0x200));
    };
    constexpr char ripmap = 2;
    EXPECT_THAT(claimed(400, 1, 1, ripmap), HasSubstr("more tiles or blocks of lines than the file can hold"));
    EXPECT_THAT(claimed(8, 30000, 30000, 0), HasSubstr("its tiles or blocks of lines are larger than the image"));
    EXPECT_NE(claimed(8, 1, 0x7fffffff, 0), "no error");
    EXPECT_NE(claimed(8, -1, -1, 0), "no error");
    EXPECT_NE(claimed(8, 0, 0, 0), "no error");
    EXPECT_NE(claimed(8, 8, 8, 7), "no error");
    EXPECT_LT(peak_memory() - before, little_memory);
}

TEST(LyingHeader, OfExrAttributesTakesNoMemory) {
    const long before = peak_memory();
    const std::string required = required_exr_attributes(8, 8, 3);
    std::string endless = exr_attribute("a", "string", "");
    endless.replace(endless.size() - 4, 4, "\xff\xff\xff\x7f");
    EXPECT_EQ(unreadable_image_text("a.exr", exr_of(required + endless)),
              "a.exr: not a readable OpenEXR file: an attribute of its header is longer than the file");
    endless.back() = '\xff';
    EXPECT_THAT(unreadable_image_text("a.exr", exr_of(required + endless)), HasSubstr("longer than the file"));
    EXPECT_EQ(unreadable_image_text("a.exr", exr_start() + std::string(300, 'a')),
              "a.exr: not a readable OpenEXR file: its header does not end");
    const std::string lies[] = {
        exr_attribute("preview", "preview", number_bytes({30000, 30000})),
        exr_attribute("v", "stringvector", number_bytes({0x7ffffff0})),
        exr_attribute("m", "idmanifest", number_bytes({0x7ffffff0, 0})),
        exr_attribute("s", "deepImageState", ""),
        exr_attribute("k", "keycode", ""),
    };
    for (const std::string& lie : lies) {
        EXPECT_NE(unreadable_image_text("a.exr", exr_of(required + lie)), "no error");
    }
    EXPECT_LT(peak_memory() - before, little_memory);
}

} // namespace
} // namespace foldless
