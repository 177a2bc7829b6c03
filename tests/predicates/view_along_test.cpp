#include "exact_vector.h"
#include "random_triangles.h"

#include <foldless/predicates/view_along.h>

#include <gtest/gtest.h>

#include <cmath>

namespace foldless {
namespace {

using exact::Vector;

TEST(ViewAlong, IsPositiveCounterClockwiseFromEverySide) {
    for (int k = 0; k < 3; ++k) {
        const Vec3 right = Vec3::Unit((k + 1) % 3);
        const Vec3 up = Vec3::Unit((k + 2) % 3);
        const ViewAlong front(Vec3::Unit(k));
        EXPECT_EQ(turn(front.see(right), front.see(up)), Sign::positive);
        EXPECT_EQ(turn(front.see(up), front.see(right)), Sign::negative);
        const ViewAlong back(-Vec3::Unit(k));
        EXPECT_EQ(turn(back.see(right), back.see(up)), Sign::negative);
    }
}

TEST(ViewAlong, DoesNotSeeDepth) {
    const Vec3 d(0.25, -0.5, 2);
    const ViewAlong view(d);
    EXPECT_EQ(turn(view.see(Vec3(1, 0, 0) + 3 * d), view.see(Vec3(1, 0.001, 0) - 7 * d)), Sign::positive);
    EXPECT_EQ(turn(view.see(Vec3(1, 0, 0)), view.see(Vec3(1, 0, 0) + d)), Sign::undecided);
}

TEST(ViewAlong, AlongNothingIsUndecided) {
    const ViewAlong view(Vec3::Zero());
    EXPECT_EQ(turn(view.see(Vec3::UnitX()), view.see(Vec3::UnitY())), Sign::undecided);
}

// Differences of positions far from the origin; every other one is nearly coplanar with the first and the direction.
TEST(ViewAlong, AgreesWithRationalArithmetic) {
    RandomTriangles random(1);
    int decided = 0;
    constexpr int rounds = 20000;
    for (int round = 0; round < rounds; ++round) {
        const Vec3 d = random.vector(std::ldexp(1.0, round % 60 - 30));
        const Vec3 from = random.vector(std::ldexp(1.0, round % 20));
        const Vec3 a = from + random.vector();
        const Vec3 plane = from + random.number(-1, 1) * (a - from) + random.number(-1, 1) * d;
        const Vec3 b = round % 2 == 0 ? Vec3(from + random.vector()) : plane;
        const ViewAlong view(d);
        const Sign sign = turn(view.see(a - from), view.see(b - from));
        const mpq_class truth = exact::dot(exact::cross(Vector(a) - Vector(from), Vector(b) - Vector(from)), Vector(d));
        if (sign != Sign::undecided) {
            EXPECT_EQ(sign == Sign::positive, sgn(truth) > 0) << "round " << round;
            EXPECT_NE(sgn(truth), 0) << "round " << round;
            ++decided;
        }
    }
    EXPECT_GT(decided, rounds / 2 - rounds / 100);
}

} // namespace
} // namespace foldless
