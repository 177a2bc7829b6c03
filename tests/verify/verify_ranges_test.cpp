// Base meshes without ranges.

#include "made_meshes.h"
#include "violations.h"

#include <gtest/gtest.h>

namespace foldless {
namespace {

using namespace test;

BaseMesh without_ranges(BaseMesh base) {
    base.ranges.clear();
    return base;
}

TEST(VerifyWithoutRanges, FindsTheRangesThatTheScanNeeds) {
    for (const int level : {0, 1, 3}) {
        const VerifyResult turned = verify(without_ranges(octahedron()), turned_sphere(level));
        EXPECT_THAT(turned, IsCertified());
        EXPECT_TRUE(turned.ranges_computed);
        EXPECT_THAT(verify(without_ranges(octahedron()), aligned_sphere(level)), IsCertified());
    }
    EXPECT_FALSE(verify(octahedron(), turned_sphere(1)).ranges_computed);
}

TEST(VerifyWithoutRanges, FindsKeptVerticesByTheirCoordinates) {
    BaseMesh base = without_ranges(square());
    base.scan_vertex.clear();
    EXPECT_THAT(verify(base, pyramid({0.4, 0.7, 0.3})), IsCertified());
    EXPECT_EQ(verify(base, Scan{base.positions, base.faces}).frozen_faces, 2);
}

TEST(VerifyWithoutRanges, RefusesWhatNoRangeCanServe) {
    EXPECT_THAT(verify(without_ranges(square()), pyramid({0.4, 1.7, 0.3})), Has(Violation::no_preimage));
    BaseMesh base = without_ranges(octahedron());
    base.directions[0] = -base.directions[0];
    EXPECT_THAT(verify(base, turned_sphere(2)), Has(Violation::jacobian));
}

} // namespace
} // namespace foldless
