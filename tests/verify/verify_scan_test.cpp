// Real scans.

#include "violations.h"

#include <foldless/io/read_mesh.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace foldless {
namespace {

using namespace test;

TEST(VerifyScan, IsRepresentedByItself) {
    const std::filesystem::path path = std::filesystem::path(FOLDLESS_SCANS) / "bunny.ply";
    if (!std::filesystem::exists(path)) {
        GTEST_SKIP() << path << " is absent";
    }
    const Scan scan = read_scan(path).scan;
    BaseMesh base;
    base.positions = scan.positions;
    base.directions.assign(scan.positions.size(), {0, 0, 1});
    base.faces = scan.faces;
    base.ranges.assign(scan.faces.size(), {0, 0});
    for (std::size_t v = 0; v < scan.positions.size(); ++v) {
        base.scan_vertex.push_back(static_cast<std::int32_t>(v));
    }
    const VerifyResult result = verify(base, scan);
    EXPECT_THAT(result, IsCertified());
    EXPECT_EQ(result.frozen_faces, scan.faces.size());
    EXPECT_EQ(result.max_displacement, 0.0);

    base.ranges[1000] = {-1, 1}; // moves, along no direction
    base.directions.assign(scan.positions.size(), {0, 0, 0});
    EXPECT_THAT(verify(base, scan), Has(Violation::jacobian));
}

} // namespace
} // namespace foldless
