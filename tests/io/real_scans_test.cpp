#include <foldless/io/defects.h>

#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace foldless {
namespace {

// What the sources of the scans say of them, or other programs measured.
struct KnownScan {
    const char* name;
    std::size_t vertices;
    std::size_t faces;
    std::size_t boundary_loops;
    std::size_t boundary_edges;
    std::size_t components;
    long long euler_characteristic;
};

const KnownScan known_scans[] = {
    {"bunny.ply", 35947, 69451, 5, 223, 1, 2 - 5},
    {"horse.ply", 48485, 96966, 0, 0, 1, 2},
    {"igea.ply", 134345, 268686, 0, 0, 1, 2},
    {"rocker_arm.ply", 40177, 80354, 0, 0, 1, 0},
    {"face_open.ply", 25905, 51712, 1, 96, 1, 1},
    {"shark_103cc.ply", 25057, 49702, 0, 0, 103, 206},
    {"cheese_g133.ply", 8629, 17786, 0, 0, 1, 2 - 2 * 133},
};

TEST(RealScans, HaveTheTopologyThatIsKnownOfThem) {
    int found = 0;
    for (const KnownScan& known : known_scans) {
        const std::filesystem::path path = std::filesystem::path(FOLDLESS_SCANS) / known.name;
        if (!std::filesystem::exists(path)) {
            continue;
        }
        ++found;
        const ReadScan read = read_scan(path);
        EXPECT_EQ(read.scan.positions.size(), known.vertices) << known.name;
        EXPECT_EQ(read.scan.faces.size(), known.faces) << known.name;
        EXPECT_TRUE(read.scan.float32) << known.name;
        const auto [defects, topology] = inspect(read.scan);
        EXPECT_EQ(defects.text(), "") << known.name;
        EXPECT_EQ(topology.boundary_loops, known.boundary_loops) << known.name;
        EXPECT_EQ(topology.boundary_edges, known.boundary_edges) << known.name;
        EXPECT_EQ(topology.components, known.components) << known.name;
        EXPECT_EQ(topology.euler_characteristic, known.euler_characteristic) << known.name;
    }
    if (found == 0) {
        GTEST_SKIP() << "no scans in " FOLDLESS_SCANS;
    }
}

TEST(RealScans, AreAllReadOrRefusedInOneLine) {
    const std::filesystem::path folder = FOLDLESS_SCANS;
    if (!std::filesystem::is_directory(folder)) {
        GTEST_SKIP() << "no folder " FOLDLESS_SCANS;
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        try {
            const ReadScan read = read_scan(entry.path());
            EXPECT_EQ(inspect(read.scan).defects.index_out_of_range, 0U) << entry.path();
        } catch (const std::runtime_error& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << entry.path();
        }
    }
}

} // namespace
} // namespace foldless
