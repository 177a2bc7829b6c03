#include "exact_vector.h"
#include "random_triangles.h"

#include <foldless/predicates/jacobian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace foldless {
namespace {

using exact::Vector;

const double infinity = std::numeric_limits<double>::infinity();

/// J_i(t), exactly.
mpq_class jacobian_at(const BaseTriangle& triangle, int i, const mpq_class& t) {
    const Vector a0 = exact::corner(triangle, 0, t);
    const Vector e1 = exact::corner(triangle, 1, t) - a0;
    const Vector e2 = exact::corner(triangle, 2, t) - a0;
    return exact::dot(exact::cross(e1, e2), Vector(triangle.d[i]));
}

/// Whether J > 0 on the whole prismoid: each J_i is a quadratic, positive at both ends and at its lowest point between.
bool positive_on(const BaseTriangle& triangle, Range range) {
    const mpq_class lo(range.lo);
    const mpq_class hi(range.hi);
    for (int i = 0; i < 3; ++i) {
        const mpq_class j0 = jacobian_at(triangle, i, 0);
        const mpq_class j1 = jacobian_at(triangle, i, 1);
        const mpq_class j2 = jacobian_at(triangle, i, -1);
        const mpq_class c2 = (j1 + j2) / 2 - j0;
        const mpq_class c1 = (j1 - j2) / 2;
        if (jacobian_at(triangle, i, lo) <= 0 || jacobian_at(triangle, i, hi) <= 0) {
            return false;
        }
        const mpq_class lowest = c2 > 0 ? mpq_class(-c1 / (2 * c2)) : lo;
        if (lowest > lo && lowest < hi && jacobian_at(triangle, i, lowest) <= 0) {
            return false;
        }
    }
    return true;
}

/// A right prism over the unit triangle, whose corners meet in a point above the centroid at t = 1.
BaseTriangle pyramid() {
    const Vec3 top(0.25, 0.25, 1);
    BaseTriangle triangle{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {}};
    for (int i = 0; i < 3; ++i) {
        triangle.d[i] = top - triangle.v[i];
    }
    return triangle;
}

TEST(JacobianOn, IsPositiveOnARightPrism) {
    const BaseTriangle prism{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                             {Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1)}};
    EXPECT_EQ(jacobian_on(prism, {-1e6, 1e6}), Sign::positive);
    EXPECT_EQ(jacobian_on(prism, {0, 0}), Sign::positive);
}

TEST(JacobianOn, IsNegativeUpToThePointWhereTheCornersMeet) {
    EXPECT_EQ(jacobian_on(pyramid(), {0, 1}), Sign::negative);
    EXPECT_EQ(jacobian_on(pyramid(), {0, 1 - 0x1p-20}), Sign::positive);
    EXPECT_EQ(jacobian_on(pyramid(), {0, 2}), Sign::negative); // positive at both ends, zero between
    EXPECT_EQ(jacobian_on(pyramid(), {1.5, 2}), Sign::positive);
}

TEST(JacobianOn, IsNegativeWithADirectionInThePlaneOrBelow) {
    BaseTriangle triangle = pyramid();
    triangle.d[1] = Vec3(1, 0, 0);
    EXPECT_EQ(jacobian_on(triangle, {0, 0}), Sign::negative);
    triangle.d[1] = Vec3(0, 0, -1);
    EXPECT_EQ(jacobian_on(triangle, {0, 0}), Sign::negative);
}

TEST(JacobianOn, IsNegativeOnNoRangeAtAll) {
    EXPECT_EQ(jacobian_on(pyramid(), {0.5, 0.25}), Sign::negative);
    EXPECT_EQ(jacobian_on(pyramid(), {0, infinity}), Sign::negative);
    EXPECT_EQ(jacobian_on(pyramid(), {-infinity, 0}), Sign::negative);
    EXPECT_EQ(jacobian_on(pyramid(), {std::nan(""), 0}), Sign::negative);
}

TEST(JacobianOn, AgreesWithRationalArithmetic) {
    RandomTriangles random(1);
    int positive = 0;
    constexpr int rounds = 20000;
    for (int round = 0; round < rounds; ++round) {
        const BaseTriangle triangle = round % 3 == 0 ? random.wild() : random.tame();
        const double lo = random.number(-2, 1);
        const Range range{lo, lo + random.number(0, 2)};
        const Sign sign = jacobian_on(triangle, range);
        positive += sign == Sign::positive ? 1 : 0;
        ASSERT_EQ(sign, positive_on(triangle, range) ? Sign::positive : Sign::negative) << "round " << round;
    }
    EXPECT_GT(positive, rounds / 10);
}

// Ranges that end within a few ulps of a root of some J_i.
TEST(JacobianOn, IsNeverWrongBesideARoot) {
    RandomTriangles random(2);
    int near = 0;
    for (int round = 0; round < 3000; ++round) {
        const BaseTriangle triangle = random.tame();
        const Range range = fold_free_range(triangle);
        if (!std::isfinite(range.hi) || !(range.hi > 0)) {
            continue;
        }
        double hi = range.hi;
        for (int step = 0; step < 8; ++step) {
            hi = std::nextafter(hi, 0);
        }
        for (int step = 0; step < 16; ++step) {
            ++near;
            ASSERT_EQ(jacobian_on(triangle, {0, hi}), positive_on(triangle, {0, hi}) ? Sign::positive : Sign::negative)
                << "round " << round;
            hi = std::nextafter(hi, infinity);
        }
    }
    EXPECT_GT(near, 1000);
}

// Every J_i of the pyramid touches zero at t = 1 without changing its sign; a little more or less lifts or sinks it.
TEST(JacobianOn, IsNeverWrongAboutATouchBetweenTheEnds) {
    EXPECT_EQ(jacobian_on(pyramid(), {0.5, 1.5}), Sign::negative);
    RandomTriangles random(4);
    int positive = 0;
    for (int round = 0; round < 2000; ++round) {
        BaseTriangle triangle = pyramid();
        for (Vec3& d : triangle.d) {
            d += random.vector(std::ldexp(1.0, -10 - round % 45));
        }
        const bool truth = positive_on(triangle, {0, 2});
        positive += truth ? 1 : 0;
        EXPECT_EQ(jacobian_on(triangle, {0, 2}), truth ? Sign::positive : Sign::negative) << "round " << round;
    }
    EXPECT_GT(positive, 100);
}

// Intervals overflow or underflow there; exact numbers do not.
TEST(JacobianOn, IsRightAtEveryMagnitude) {
    for (const int exponent : {-1000, -500, -300, 0, 300, 500, 1000}) {
        BaseTriangle triangle = pyramid();
        for (int i = 0; i < 3; ++i) {
            triangle.v[i] *= std::ldexp(1.0, exponent);
            triangle.d[i] *= std::ldexp(1.0, exponent);
        }
        EXPECT_EQ(jacobian_on(triangle, {0, 1}), Sign::negative) << exponent;
        EXPECT_EQ(jacobian_on(triangle, {0, 1 - 0x1p-52}), Sign::positive) << exponent;
    }
}

// Some products overflow, and others, of the opposite sign, do not.
TEST(JacobianOn, IsRightWhereProductsOverflow) {
    RandomTriangles random(5);
    for (int round = 0; round < 5000; ++round) {
        BaseTriangle triangle = random.wild();
        for (int i = 0; i < 3; ++i) {
            triangle.v[i] *= 0x1p341;
            triangle.d[i] *= 0x1p342;
        }
        const Range range{0, round % 2 == 0 ? 0 : 0.125};
        ASSERT_EQ(jacobian_on(triangle, range), positive_on(triangle, range) ? Sign::positive : Sign::negative)
            << "round " << round;
    }
}

TEST(FoldFreeRange, EndsWhereTheCornersMeet) {
    const Range range = fold_free_range(pyramid());
    EXPECT_NEAR(range.hi, 1, 1e-7); // a double root
    EXPECT_EQ(range.lo, -infinity);
}

TEST(FoldFreeRange, IsUnboundedOnARightPrism) {
    const BaseTriangle prism{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                             {Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1)}};
    EXPECT_EQ(fold_free_range(prism).lo, -infinity);
    EXPECT_EQ(fold_free_range(prism).hi, infinity);
}

TEST(FoldFreeRange, IsEmptyWhereTheTriangleFoldsAtOnce) {
    BaseTriangle triangle = pyramid();
    triangle.d[2] = Vec3(1, 1, 0);
    const Range range = fold_free_range(triangle);
    EXPECT_GT(range.lo, range.hi);
}

TEST(FoldFreeRange, IsTheLargestOnWhichJIsPositive) {
    RandomTriangles random(3);
    for (int round = 0; round < 3000; ++round) {
        const BaseTriangle triangle = random.tame();
        const Range range = fold_free_range(triangle);
        if (range.lo > range.hi) {
            EXPECT_FALSE(positive_on(triangle, {0, 0}));
            continue;
        }
        constexpr double far = 1e3; // for the ends that are infinite
        const Range inner{std::max(range.lo, -far) * (1 - 1e-6), std::min(range.hi, far) * (1 - 1e-6)};
        EXPECT_TRUE(positive_on(triangle, inner)) << "round " << round;
        if (range.hi < far) {
            EXPECT_FALSE(positive_on(triangle, {0, range.hi * (1 + 1e-6)})) << "round " << round;
        }
        if (range.lo > -far) {
            EXPECT_FALSE(positive_on(triangle, {range.lo * (1 + 1e-6), 0})) << "round " << round;
        }
    }
}

} // namespace
} // namespace foldless
