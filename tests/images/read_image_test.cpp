#include <foldless/images/read_image.h>

#include "images.h"
#include "sample_jpeg.h"

#include <foldless/images/write_exr.h>
#include <foldless/images/write_png.h>

#include <gtest/gtest.h>

namespace foldless {
namespace {

TEST(ReadImage, GoesByTheExtensionWhateverItsCase) {
    const TemporaryFolder folder;
    const Image image = slope(3, 2, {"Y"});
    for (const char* name : {"a.exr", "a.EXR"}) {
        stage_exr(folder.path() / name, image, {}).commit();
        EXPECT_EQ(read_image(folder.path() / name).image.values, image.values);
    }
    for (const char* name : {"a.png", "a.b.Png"}) {
        stage_png(folder.path() / name, image, {}, {}).commit();
        EXPECT_EQ(read_image(folder.path() / name).image.values, image.values);
    }
    for (const char* name : {"a.jpg", "a.JPEG"}) {
        EXPECT_EQ(image_of(name, jpeg_bytes(image, {})).image.width, 3);
    }
}

TEST(ReadImage, UnknownOnesAreNotRead) {
    for (const std::string& name : {std::string("a.tif"), std::string("png"), std::string(".png"), std::string("a.")}) {
        EXPECT_EQ(unreadable_image_text(name, "bytes"),
                  name + ": unknown file type; .exr, .png, .jpg and .jpeg can be read");
    }
}

TEST(ReadImage, TellsOfMissingFilesAndFolders) {
    const TemporaryFolder folder;
    for (const char* name : {"a.exr", "a.png", "a.jpg"}) {
        const std::string path = (folder.path() / name).string();
        const auto message = [&] { return message_of<UnreadableFile>([&] { static_cast<void>(read_image(path)); }); };
        EXPECT_EQ(message(), path + ": No such file or directory");
        std::filesystem::create_directory(path);
        EXPECT_EQ(message(), path + ": is a folder");
    }
}

} // namespace
} // namespace foldless
