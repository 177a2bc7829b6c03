#include "exact_vector.h"
#include "random_triangles.h"

#include <foldless/predicates/coarse_normal.h>

#include <gtest/gtest.h>

#include <cmath>

namespace foldless {
namespace {

using exact::Vector;

const ScanTriangle upright{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};

mpq_class exact_product(const Vec3& d, const ScanTriangle& q) {
    return exact::dot(Vector(d), exact::cross(Vector(q[1]) - Vector(q[0]), Vector(q[2]) - Vector(q[0])));
}

TEST(CoarseNormal, TakesSixBytes) {
    EXPECT_EQ(sizeof(CoarseNormal), 6);
}

TEST(CoarseNormal, TellsFromWhichSideATriangleIsSeen) {
    const CoarseNormal normal{ScanNormal(upright)};
    EXPECT_EQ(normal.value().seen_along({5, 5, 1}), Sign::positive);
    EXPECT_EQ(normal.value().seen_along({5, 5, -1}), Sign::negative);
    EXPECT_EQ(normal.value().seen_along({5, 5, 1e-5}), Sign::undecided); // closer than it tells
}

TEST(CoarseNormal, DecidesNoSignOfATriangleWithoutArea) {
    for (const ScanTriangle& q : {ScanTriangle{Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 2, 2)},
                                  ScanTriangle{Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3(1, 2, 3)},
                                  ScanTriangle{Vec3(0, 0, 0), Vec3(1e-200, 0, 0), Vec3(0, 1e-200, 0)},
                                  ScanTriangle{Vec3(0, 0, 0), Vec3(1e300, 0, 0), Vec3(0, 1e300, 0)}}) {
        EXPECT_EQ(CoarseNormal(ScanNormal(q)).value().seen_along({1, 2, 3}), Sign::undecided);
    }
    EXPECT_EQ(CoarseNormal().value().seen_along({1, 2, 3}), Sign::undecided);
}

// Directions that nearly lie in the triangle, on both sides of where the coarse normal stops to tell.
TEST(CoarseNormal, NeverTellsTheWrongSide) {
    RandomTriangles random(1);
    int decided = 0;
    constexpr int rounds = 20000;
    for (int round = 0; round < rounds; ++round) {
        const Vec3 far = random.vector(std::ldexp(1.0, round % 30));
        const ScanTriangle q{far + random.vector(), far + random.vector(), far + random.vector()};
        const Vec3 in_plane = random.number(-1, 1) * (q[1] - q[0]) + random.number(-1, 1) * (q[2] - q[0]);
        const Vec3 d = in_plane + std::ldexp(1.0, -(round % 40)) * random.vector();
        const Sign answer = CoarseNormal(ScanNormal(q)).value().seen_along(d);
        const Sign wrong = sgn(exact_product(d, q)) > 0 ? Sign::negative : Sign::positive;
        EXPECT_NE(answer, wrong) << "round " << round;
        decided += answer == Sign::undecided ? 0 : 1;
    }
    EXPECT_GT(decided, rounds / 4);
    EXPECT_LT(decided, rounds / 4 * 3);
}

} // namespace
} // namespace foldless
