#include "meshes.h"

#include <foldless/io/defects.h>
#include <foldless/io/read_mesh.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace foldless::test {
namespace {

/// False if the file cannot be read, or is refused before its faces are judged.
bool repairs(const std::filesystem::path& path) {
    Scan scan;
    try {
        scan = read_scan(path).scan;
    } catch (const std::runtime_error&) {
        return false;
    }
    if (!inspect(scan).defects.any()) {
        return false;
    }
    try {
        const RepairResult result = repair(scan);
        EXPECT_TRUE(result.counts.any()) << path;
        EXPECT_EQ(inspect(result.scan).defects.text(), "") << path;
        EXPECT_EQ(repair(result.scan).counts.text(), "") << path;
        return true;
    } catch (const RefusedMesh& refusal) {
        EXPECT_EQ(std::string(refusal.what()).find("no face"), 0U) << path << ": " << refusal.what();
        return false;
    }
}

TEST(RepairOfFilesOfOthers, LeavesNoDefect) {
    const std::filesystem::path folder = std::filesystem::path(FOLDLESS_SCANS).parent_path() / "corpus";
    if (!std::filesystem::is_directory(folder)) {
        GTEST_SKIP() << "no folder " << folder;
    }
    int repaired_files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        repaired_files += repairs(entry.path()) ? 1 : 0;
    }
    EXPECT_GT(repaired_files, 0);
}

} // namespace
} // namespace foldless::test
