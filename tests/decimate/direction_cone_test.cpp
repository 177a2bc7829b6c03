#include "random_triangles.h"

#include <foldless/decimate/direction_cone.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace foldless {
namespace {

ScanNormal normal_along(const Vec3& n) {
    const Vec3 a = n.unitOrthogonal();
    return ScanNormal({Vec3::Zero(), a, n.cross(a)}).normalised();
}

TEST(DirectionCone, SeesOnlyWhatEveryDirectionSees) {
    RandomTriangles random(1);
    int seen = 0;
    int missed = 0;
    for (int round = 0; round < 20000; ++round) {
        std::vector<Vec3> directions;
        for (int n = 0; n < 5; ++n) {
            directions.push_back((Vec3(0, 0, 1) + random.vector(round % 2 == 0 ? 0.3 : 2)) * random.number(0.5, 2));
        }
        const ScanNormal normal = normal_along(random.vector().normalized());
        const bool all = std::all_of(directions.begin(), directions.end(),
                                     [&](const Vec3& d) { return normal.seen_along(d) == Sign::positive; });
        const bool cone = DirectionCone(directions).sees(normal);
        ASSERT_TRUE(!cone || all) << round;
        seen += cone ? 1 : 0;
        missed += all && !cone ? 1 : 0;
    }
    EXPECT_GT(seen, 3000);
    EXPECT_LT(missed, seen);
}

TEST(DirectionCone, SeesNothingIfItIsEmptyOrTooWide) {
    const ScanNormal up = normal_along(Vec3::UnitZ());
    EXPECT_TRUE(DirectionCone(std::vector<Vec3>{Vec3(0, 0, 1)}).sees(up));
    EXPECT_FALSE(DirectionCone(std::vector<Vec3>{}).sees(up));
    EXPECT_FALSE(DirectionCone(std::vector<Vec3>{Vec3(1, 0, 0.1), Vec3(-1, 0, -0.1)}).sees(up));
    EXPECT_FALSE(DirectionCone(std::vector<Vec3>{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(-1, -1, 0.1)}).sees(up));
}

} // namespace
} // namespace foldless
