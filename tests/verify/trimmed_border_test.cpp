// Scans over a base mesh that reaches further: the images of their borders must not meet, nor lie over the scan.

#include "made_meshes.h"
#include "violations.h"

#include <gtest/gtest.h>

namespace foldless {
namespace {

using namespace test;

BaseMesh free_square() {
    BaseMesh base = square({-1, 1});
    base.scan_vertex.assign(4, -1);
    return base;
}

/// Two scans as one, the second moved.
Scan both(Scan a, const Scan& b, const Vec3& by) {
    const auto offset = static_cast<std::int32_t>(a.positions.size());
    for (const Vec3& p : b.positions) {
        a.positions.emplace_back(p + by);
    }
    for (const Triangle& face : b.faces) {
        a.faces.push_back({face[0] + offset, face[1] + offset, face[2] + offset});
    }
    return a;
}

/// The number of `overlap` violations of two patches, each a grid over a square; the second is 0.25 higher.
std::size_t overlaps(const Scan& a, const Scan& b) {
    const VerifyResult result = verify(free_square(), both(a, b, {0, 0, 0.25}));
    EXPECT_EQ(result.level, Level::surface);
    EXPECT_EQ(count(result, Violation::topology) + count(result, Violation::overlap), result.violation_total());
    return count(result, Violation::overlap);
}

TEST(TrimmedBorder, IsCertifiedAtTheLevelOfTheSurface) {
    const VerifyResult result = verify(free_square(), grid(8, 0.3, 0.6, 0.5));
    EXPECT_THAT(result, IsCertified());
    EXPECT_EQ(result.level, Level::surface);
}

TEST(TrimmedBorder, PartsBesideEachOtherDoNotOverlap) {
    EXPECT_EQ(overlaps(grid(4, 0.1, 0.4, 0.5), grid(4, 0.45, 0.8, 0.5)), 0);
}

TEST(TrimmedBorder, PartsThatCrossOverlap) {
    EXPECT_GT(overlaps(grid(4, 0.1, 0.4, 0.5), grid(4, 0.35, 0.8, 0.5)), 0);
}

TEST(TrimmedBorder, APartThatLiesOverTheMiddleOfAnotherOverlaps) {
    EXPECT_EQ(overlaps(grid(4, 0.1, 0.8, 0.5), grid(4, 0.35, 0.45, 0.5)), 1); // once for its border
}

TEST(TrimmedBorder, PartsThatTouchInAPointOverlap) {
    EXPECT_GT(overlaps(grid(4, 0.125, 0.375, 0), grid(4, 0.375, 0.75, 0)), 0);
    EXPECT_EQ(overlaps(grid(4, 0.125, 0.375, 0), grid(4, 0.375 + 0x1p-30, 0.75, 0)), 0);
}

TEST(TrimmedBorder, PartsWhoseBordersRunOverEachOtherOverlap) {
    Scan right = grid(4, 0.125, 0.375, 0);
    for (Vec3& p : right.positions) {
        p.x() += 0.25;
    }
    EXPECT_GT(overlaps(grid(4, 0.125, 0.375, 0), right), 0);
}

} // namespace
} // namespace foldless
