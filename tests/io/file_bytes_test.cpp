#include <foldless/io/file_bytes.h>

#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <string>

namespace foldless {
namespace {

std::string failure(const std::filesystem::path& path) {
    return message_of<UnreadableFile>([&] { const FileBytes bytes(path); });
}

TEST(FileBytes, AreThoseOfTheFile) {
    const TemporaryFolder folder;
    const std::string content("a\0b\n", 4);
    EXPECT_EQ(FileBytes(folder.file("f", content)).bytes(), content);
}

TEST(FileBytes, RefuseWhatIsNoFileWithoutWaiting) {
    const TemporaryFolder folder;
    const auto pipe = folder.path() / "pipe.ply";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(failure(pipe), pipe.string() + ": is not a regular file");
    EXPECT_EQ(failure("/dev/zero"), "/dev/zero: is not a regular file");
    EXPECT_EQ(failure(folder.path()), folder.path().string() + ": is a folder");
}

TEST(FileBytes, RefuseMissingAndEmptyFiles) {
    const TemporaryFolder folder;
    EXPECT_EQ(failure(folder.path() / "a"), folder.path().string() + "/a: No such file or directory");
    EXPECT_EQ(failure(folder.file("b", "")), folder.path().string() + "/b: the file is empty");
    EXPECT_NE(failure(""), "no error");
}

TEST(FileBytes, RefuseALoopOfLinks) {
    const TemporaryFolder folder;
    std::filesystem::create_symlink(folder.path() / "a", folder.path() / "b");
    std::filesystem::create_symlink(folder.path() / "b", folder.path() / "a");
    EXPECT_NE(failure(folder.path() / "a"), "no error");
}

TEST(FileBytes, KeepALineEndInTheNameOutOfTheMessage) {
    EXPECT_EQ(failure("no\nsuch\x1b.ply"), "no?such?.ply: No such file or directory");
}

TEST(FileBytes, TakeNoMemoryForAnEmptyFileOfManyGigabytes) {
    const TemporaryFolder folder;
    for (const char* name : {"a.ply", "a.obj", "a.off", "a.stl"}) {
        const auto path = folder.file(name, "");
        std::filesystem::resize_file(path, std::uintmax_t{5} << 30);
        EXPECT_THROW(static_cast<void>(read_scan(path)), UnreadableFile) << name;
    }
}

} // namespace
} // namespace foldless
