#include <foldless/io/file_type.h>

#include "temporary_folder.h"

#include <gtest/gtest.h>

namespace foldless {
namespace {

TEST(FileType, IsThatOfTheExtensionWhateverItsCase) {
    EXPECT_EQ(file_type("a.ply"), FileType::ply);
    EXPECT_EQ(file_type("a.b.OBJ"), FileType::obj);
    EXPECT_EQ(file_type("-.Off"), FileType::off);
    EXPECT_EQ(file_type("/x.y/a.sTl"), FileType::stl);
    for (const char* name : {"a", "", "ply", ".ply", "a.plyx", "a.ply.gz", "a."}) {
        EXPECT_EQ(file_type(name), FileType::unknown) << name;
    }
}

TEST(LowerCaseExtension, KeepsItsDot) {
    EXPECT_EQ(lower_case_extension("a.b.PnG"), ".png");
    EXPECT_EQ(lower_case_extension("/x.y/a"), "");
}

TEST(FileType, UnknownOnesAreNotRead) {
    EXPECT_EQ(unreadable("a.xyz", "0 0 0"), "a.xyz: unknown file type; .ply, .obj, .off and .stl can be read");
}

TEST(FileType, CompressedFilesAreNamedAsSuchWhateverTheirExtension) {
    for (const char* name : {"a.ply.gz", "a.ply", "a.obj", "a.stl"}) {
        EXPECT_EQ(unreadable(name, "\x1f\x8b\x08 bytes"),
                  std::string(name) + ": compressed with gzip; decompress it first");
    }
}

} // namespace
} // namespace foldless
