#include <foldless/io/atomic_file.h>

#include <foldless/io/write_mesh.h>

#include "file_size_limit.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace foldless {
namespace {

using Names = std::vector<std::string>;

std::string failure(const std::filesystem::path& path) {
    return message_of<UnwritableFile>([&] { write_text(path, "new"); });
}

TEST(AtomicFile, AppearsWholeAtTheEnd) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "a";
    AtomicFile file(path);
    std::string expected;
    for (int i = 0; i < 100000; ++i) {
        file.write("0123456789abcdef\n");
        expected += "0123456789abcdef\n";
    }
    const std::string large(std::size_t{3} << 20, 'x');
    file.write(large);
    file.write("");
    EXPECT_FALSE(std::filesystem::exists(path));
    file.commit();
    EXPECT_EQ(bytes_of(path), expected + large);
    EXPECT_EQ(folder.names(), Names{"a"});
}

TEST(AtomicFile, LeavesNothingWithoutCommit) {
    const TemporaryFolder folder;
    const auto path = folder.file("a", "old");
    {
        AtomicFile file(path);
        file.write("new");
        EXPECT_EQ(folder.names().size(), 2U);
        file.finish();
        EXPECT_EQ(bytes_of(file.temporary_path()), "new");
    }
    EXPECT_EQ(folder.names(), Names{"a"});
    EXPECT_EQ(bytes_of(path), "old");
}

TEST(AtomicFile, CanBeMoved) {
    const TemporaryFolder folder;
    std::optional<AtomicFile> moved;
    {
        AtomicFile file(folder.path() / "a");
        file.write("new");
        moved.emplace(std::move(file));
    }
    EXPECT_EQ(folder.names().size(), 1U) << "the one that was moved from removes nothing";
    moved->commit();
    EXPECT_EQ(bytes_of(folder.path() / "a"), "new");
}

TEST(AtomicFile, HasThePermissionsThatTheUserGivesToNewFiles) {
    const TemporaryFolder folder;
    const mode_t before = ::umask(027);
    write_text(folder.path() / "a", "new");
    ::umask(before);
    struct stat status {};
    ASSERT_EQ(::stat((folder.path() / "a").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST(AtomicFile, ReplacesTheFileBehindALink) {
    const TemporaryFolder folder;
    const auto path = folder.file("a", "old");
    std::filesystem::create_symlink("a", folder.path() / "link");
    write_text(folder.path() / "link", "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link"));
    EXPECT_EQ(bytes_of(path), "new");
}

TEST(AtomicFile, RefusesTargetsThatAreNoFiles) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path() / "d");
    const auto pipe = folder.path() / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(failure(folder.path() / "d"), (folder.path() / "d").string() + ": cannot be written: is a folder");
    EXPECT_EQ(failure(pipe), pipe.string() + ": cannot be written: is not a regular file");
    EXPECT_EQ(failure("/dev/full"), "/dev/full: cannot be written: is not a regular file");
    EXPECT_EQ(failure(folder.path() / "x" / "a"),
              (folder.path() / "x" / "a").string() + ": cannot be written: No such file or directory");
    EXPECT_NE(failure(folder.file("f", "") / "a"), "no error") << "a file in the place of the folder";
    EXPECT_NE(failure(""), "no error");
    EXPECT_NE(failure(folder.path().string() + "/"), "no error");
    EXPECT_EQ(folder.names(), (Names{"d", "f", "pipe"}));
}

TEST(AtomicFile, RefusesWhatTheUserMayNotWrite) {
    if (::geteuid() == 0) {
        GTEST_SKIP() << "the superuser may write everything";
    }
    const TemporaryFolder folder;
    const auto path = folder.file("a", "old");
    ::chmod(path.c_str(), 0400);
    EXPECT_EQ(failure(path), path.string() + ": cannot be written: Permission denied");
    ::chmod(folder.path().c_str(), 0500);
    EXPECT_EQ(failure(folder.path() / "b"), (folder.path() / "b").string() + ": cannot be written: Permission denied");
    ::chmod(folder.path().c_str(), 0700);
    EXPECT_EQ(bytes_of(path), "old");
}

TEST(AtomicFile, RefusesNamesThatTheSystemDoesNotHave) {
    const TemporaryFolder folder;
    EXPECT_NE(failure(folder.path() / std::string(300, 'a')), "no error");
    EXPECT_NE(failure(folder.path() / std::string(5000, 'a')), "no error");
    EXPECT_TRUE(folder.names().empty());
    write_text(folder.path() / std::string(255, 'a'), "new");
    EXPECT_EQ(folder.names(), Names{std::string(255, 'a')}) << "the longest name there is";
}

TEST(AtomicFile, LeavesTheOldFileWhenThereIsNoMoreRoom) {
    const TemporaryFolder folder;
    const auto path = folder.file("a", "old");
    for (const rlim_t limit : {0, 1, 4096, (1 << 20) + 4095}) {
        const std::string text((std::size_t{1} << 20) + 4096, 'x');
        const FileSizeLimit full(limit);
        const std::string message = message_of<UnwritableFile>([&] { write_text(path, text); });
        EXPECT_EQ(message, path.string() + ": cannot be written: File too large") << limit;
        EXPECT_EQ(bytes_of(path), "old");
        EXPECT_EQ(folder.names(), Names{"a"});
    }
}

TEST(AtomicFile, RefusesMoreFilesAtOnceThanASignalHandlerCanRemove) {
    const TemporaryFolder folder;
    std::vector<AtomicFile> files;
    const auto fill = [&] {
        for (int i = 0; i < 1000; ++i) {
            files.emplace_back(folder.path() / std::to_string(i));
        }
    };
    EXPECT_THROW(fill(), UnwritableFile);
    EXPECT_GE(files.size(), 16U);
    EXPECT_EQ(folder.names().size(), files.size());
    files.clear();
    EXPECT_TRUE(folder.names().empty());
    EXPECT_EQ(failure(folder.path() / "a"), "no error");
}

TEST(CommitAll, NamesEachFile) {
    const TemporaryFolder folder;
    std::vector<AtomicFile> files;
    for (const char* name : {"a", "b"}) {
        files.emplace_back(folder.file(name, "old")).write(name);
    }
    commit_all(files);
    EXPECT_EQ(bytes_of(folder.path() / "a"), "a");
    EXPECT_EQ(bytes_of(folder.path() / "b"), "b");
    EXPECT_EQ(folder.names(), (Names{"a", "b"}));
}

TEST(CommitAll, NamesNoneWhereOneDoesNotFitOnTheDisk) {
    const TemporaryFolder folder;
    {
        std::vector<AtomicFile> files;
        files.emplace_back(folder.file("a", "old")).write("new");
        files.emplace_back(folder.file("b", "old")).write(std::string(5000, 'x'));
        const FileSizeLimit full(4096);
        EXPECT_THROW(commit_all(files), UnwritableFile);
    }
    EXPECT_EQ(bytes_of(folder.path() / "a"), "old");
    EXPECT_EQ(bytes_of(folder.path() / "b"), "old");
    EXPECT_EQ(folder.names(), (Names{"a", "b"}));
}

TEST(RemoveTemporaryFiles, RemovesThoseThatAreOpenAndNoOthers) {
    const TemporaryFolder folder;
    write_text(folder.path() / "done", "kept");
    AtomicFile open(folder.path() / "open");
    AtomicFile finished(folder.path() / "finished");
    finished.finish();
    EXPECT_EQ(folder.names().size(), 3U);
    remove_temporary_files();
    EXPECT_EQ(folder.names(), Names{"done"});
    EXPECT_THROW(open.commit(), UnwritableFile);
}

extern "C" void remove_and_end(int signal) {
    remove_temporary_files();
    ::_exit(128 + signal);
}

TEST(RemoveTemporaryFiles, ServesASignalHandler) {
    const TemporaryFolder folder;
    const auto path = folder.file("a", "old");
    EXPECT_EXIT(
        {
            std::signal(SIGTERM, remove_and_end);
            AtomicFile file(path);
            file.write("new");
            std::raise(SIGTERM);
        },
        testing::ExitedWithCode(128 + SIGTERM), "");
    EXPECT_EQ(folder.names(), Names{"a"});
    EXPECT_EQ(bytes_of(path), "old");
}

} // namespace
} // namespace foldless
