#include "exact_vector.h"
#include "random_triangles.h"

#include <foldless/predicates/wall.h>

#include <gtest/gtest.h>

#include <cmath>

namespace foldless {
namespace {

using exact::Vector;

/// Corners of the wall opposite corner k.
struct Ends {
    int i;
    int j;
};
Ends ends(int opposite) {
    return {(opposite + 1) % 3, (opposite + 2) % 3};
}

/// e.((a_j - a_i)(t) x d(lambda)), exactly.
mpq_class outwards(const BaseTriangle& triangle, int opposite, const Vec3& e, double lambda, double t) {
    const auto [i, j] = ends(opposite);
    const Vector along = exact::corner(triangle, j, t) - exact::corner(triangle, i, t);
    const mpq_class l(lambda);
    const Vector d = (1 - l) * Vector(triangle.d[i]) + l * Vector(triangle.d[j]);
    return exact::dot(Vector(e), exact::cross(along, d));
}

const BaseTriangle prism{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1)}};

TEST(Wall, IsPassedOneWayOutwardsAndInwards) {
    const Wall front(prism, 2); // over the edge from (0, 0) to (1, 0)
    EXPECT_TRUE(front.is_passed_one_way({0, -1, 0}, {-1, 1}));
    EXPECT_TRUE(front.is_passed_one_way({0.5, 1, 3}, {-1, 1}));
    EXPECT_FALSE(front.is_passed_one_way({1, 0, 0}, {-1, 1}));
}

// The value is linear in lambda and in t, so its extremes are at the four corners of the wall.
TEST(Wall, IsPassedOneWayOnlyIfTheSignIsOneOverTheWholeWall) {
    RandomTriangles random(1);
    int decided = 0;
    constexpr int rounds = 5000;
    for (int round = 0; round < rounds; ++round) {
        const BaseTriangle triangle = round % 2 == 0 ? random.wild() : random.tame();
        const int k = round % 3;
        const Vec3 e = random.vector(1e-3);
        const Range range{random.number(-1, 0), random.number(0, 1)};
        const bool one_way = Wall(triangle, k).is_passed_one_way(e, range);
        bool all_positive = true;
        bool all_negative = true;
        for (const double lambda : {0.0, 1.0}) {
            for (const double t : {range.lo, range.hi}) {
                const int corner = sgn(outwards(triangle, k, e, lambda, t));
                all_positive = all_positive && corner > 0;
                all_negative = all_negative && corner < 0;
            }
        }
        EXPECT_TRUE(!one_way || all_positive || all_negative) << "round " << round;
        decided += one_way ? 1 : 0;
    }
    EXPECT_GT(decided, rounds / 4);
}

TEST(Wall, IsNotPassedOneWayWhereProductsUnderflow) {
    BaseTriangle tiny = prism;
    for (int k = 0; k < 3; ++k) {
        tiny.v[k] *= 1e-200;
        tiny.d[k] *= 1e-200;
    }
    EXPECT_FALSE(Wall(tiny, 2).is_passed_one_way({0, -1e-200, 0}, {-1, 1}));
}

// Over the first edge the normal turns with t by delta x d, which no double holds.
TEST(Wall, IsNotPassedOneWayWhereATurnThatUnderflowsIsFollowedFar) {
    const BaseTriangle turning{{Vec3(0, 0, 0), Vec3(1e-85, 0, 0), Vec3(0, 1, 0)},
                               {Vec3(0, 0, 1e-60), Vec3(1e-300, 0, 1e-60), Vec3(0, 0, 1e-60)}};
    const Vec3 e(0, -1, 0);
    EXPECT_GT(outwards(turning, 2, e, 0, 0), 0);
    EXPECT_LT(outwards(turning, 2, e, 0, -1e300), 0);
    EXPECT_FALSE(Wall(turning, 2).is_passed_one_way(e, {-1e300, 0}));
    EXPECT_TRUE(Wall(turning, 2).is_passed_one_way(e, {-1, 0}));
}

// The same with a line that is so short that its product with w2 underflows.
TEST(Wall, IsNotPassedOneWayWhereAShortLineUnderflowsAndIsFollowedFar) {
    const BaseTriangle turning{{Vec3(0, 0, 0), Vec3(1e-7, 0, 0), Vec3(0, 1, 0)},
                               {Vec3(0, 0, 1e-60), Vec3(1e-100, 0, 1e-60), Vec3(0, 0, 1e-60)}};
    const Vec3 e(0, -1e-165, 0);
    EXPECT_GT(outwards(turning, 2, e, 0, 0), 0);
    EXPECT_LT(outwards(turning, 2, e, 0, -1e100), 0);
    EXPECT_FALSE(Wall(turning, 2).is_passed_one_way(e, {-1e100, 0}));
    EXPECT_TRUE(Wall(turning, 2).is_passed_one_way(e, {-1, 0}));
}

} // namespace
} // namespace foldless
