#include "../soak.h"
#include "prismoid_oracle.h"
#include "random_triangles.h"

#include <foldless/predicates/pillar.h>
#include <foldless/predicates/sign_counts.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace foldless {
namespace {

using oracle::Rational;

/// Where the pillar meets the plane, as barycentric coordinates of the triangle: by the volumes of d with pairs of
/// corners.
struct Hit {
    Rational m;
    Rational l;
    std::array<Rational, 3> beta; ///< times m

    Hit(const DisplacedVertex& vertex, const ScanTriangle& q) {
        using oracle::vector;
        using oracle::operator-;
        const oracle::Vector v = vector(vertex.v);
        const oracle::Vector d = vector(vertex.d);
        m = oracle::seen(vertex.d, q);
        for (int k = 0; k < 3; ++k) {
            beta[k] = oracle::determinant(d, vector(q[(k + 1) % 3]) - v, vector(q[(k + 2) % 3]) - v);
        }
        // v = sum beta_k q_k / m - t d, so l = (v - q0).n = -t m.
        const oracle::Vector n = oracle::cross(vector(q[1]) - vector(q[0]), vector(q[2]) - vector(q[0]));
        l = oracle::dot(v - vector(q[0]), n);
    }

    [[nodiscard]] Sign pierces() const {
        const Rational least = std::min({beta[0], beta[1], beta[2]});
        if (m <= 0 || least < 0) {
            return Sign::negative;
        }
        return least == 0 ? Sign::zero : Sign::positive;
    }
    [[nodiscard]] Rational t() const { return -l / m; }
};

struct Case {
    DisplacedVertex vertex;
    ScanTriangle triangle;
};

/// Of all that the predicates say of it; with filters and without.
void expect_right(const Case& c) {
    const Hit hit(c.vertex, c.triangle);
    for (const bool filters : {true, false}) {
        set_filters_enabled(filters);
        ASSERT_EQ(pierces(c.vertex, c.triangle), hit.pierces()) << (filters ? "with" : "without") << " filters";
        set_filters_enabled(true);
    }
    if (hit.m <= 0) {
        return;
    }
    const Range bounds = displacement_at_plane(c.vertex, c.triangle);
    const double infinity = std::numeric_limits<double>::infinity();
    ASSERT_LE(bounds.lo, bounds.hi);
    ASSERT_TRUE(bounds.lo == -infinity || Rational(bounds.lo) <= hit.t());
    ASSERT_TRUE(bounds.hi == infinity || Rational(bounds.hi) >= hit.t());
    const double t = hit.t().get_d();
    if (!std::isfinite(t) || (t != 0 && std::abs(t) < 1e-300)) {
        return;
    }
    // Ends at and a few ulps around the displacement.
    const std::array<double, 4> ends{t, std::nextafter(t, -infinity), std::nextafter(t, infinity), t + 1};
    for (const double lo : ends) {
        for (const double hi : ends) {
            if (lo > hi) {
                continue;
            }
            const bool expected = Rational(lo) <= hit.t() && hit.t() <= Rational(hi);
            set_filters_enabled(lo != hi);
            ASSERT_EQ(meets_plane_within(c.vertex, c.triangle, {lo, hi}), expected);
            set_filters_enabled(true);
        }
    }
}

TEST(Pillar, PiercesRandomTrianglesAsRationalArithmeticSays) {
    RandomTriangles random(1);
    int pierced = 0;
    const int rounds = soak(200000);
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(round);
        const Case c{{random.vector(0.2), random.vector()}, {random.vector(), random.vector(), random.vector()}};
        expect_right(c);
        if (testing::Test::HasFatalFailure()) {
            return;
        }
        pierced += pierces(c.vertex, c.triangle) == Sign::positive ? 1 : 0;
    }
    EXPECT_GT(pierced, rounds / 100);
}

TEST(Pillar, TouchesEdgesAndCornersExactlyAndMissesThemByOneUlp) {
    RandomTriangles random(2);
    int zeros = 0;
    const int rounds = soak(200000);
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(round);
        ScanTriangle q{random.dyadic(6), random.dyadic(6), random.dyadic(6)};
        const double lambda = round % 3 == 0 ? 0 : random.dyadic(4)[0];
        const Vec3 on_edge = q[0] + lambda * (q[1] - q[0]);
        const Vec3 d = random.dyadic(5);
        Case c{{on_edge - random.dyadic(3)[0] * d, d}, q};
        const SignCounts before = sign_counts();
        expect_right(c);
        if (pierces(c.vertex, c.triangle) == Sign::zero) {
            ++zeros;
            EXPECT_GT(sign_counts().exact, before.exact);
        }
        double& x = round % 2 == 0 ? c.vertex.v[round % 3] : c.triangle[round % 3][round / 2 % 3];
        for (const double beyond : {-8.0, 8.0}) {
            const double kept = x;
            x = std::nextafter(x, beyond);
            expect_right(c);
            x = kept;
        }
        if (testing::Test::HasFatalFailure()) {
            return;
        }
    }
    EXPECT_GT(zeros, rounds / 20);
}

TEST(Pillar, DoesNotPierceATriangleSeenFromBehindFromTheSideOrWithoutArea) {
    const ScanTriangle q{Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(0, 1, 1)};
    const Vec3 v(0.25, 0.25, 0);
    EXPECT_EQ(pierces({v, {0, 0, 1}}, q), Sign::positive);
    EXPECT_EQ(pierces({v, {0, 0, -1}}, q), Sign::negative);
    EXPECT_EQ(pierces({v, {1, 0, 0}}, q), Sign::negative);
    EXPECT_EQ(pierces({Vec3(0.25, 0.25, 1), {1, 0, 0}}, q), Sign::negative);
    EXPECT_EQ(pierces({v, {0, 0, 0}}, q), Sign::negative);
    EXPECT_EQ(pierces({v, {0, 0, 1}}, {q[0], q[1], q[1]}), Sign::negative);
    EXPECT_EQ(pierces({v, {0, 0, 1}}, {q[0], q[2], q[1]}), Sign::negative);
}

TEST(Pillar, MeetsThePlaneAtBothEndsOfTheRange) {
    const ScanTriangle q{Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(0, 1, 1)};
    const DisplacedVertex vertex{Vec3(7, 7, 0), {0, 0, 2}};
    EXPECT_TRUE(meets_plane_within(vertex, q, {0.5, 0.5}));
    EXPECT_TRUE(meets_plane_within(vertex, q, {0, 0.5}));
    EXPECT_TRUE(meets_plane_within(vertex, q, {0.5, 1}));
    EXPECT_FALSE(meets_plane_within(vertex, q, {0, std::nextafter(0.5, 0)}));
    EXPECT_FALSE(meets_plane_within(vertex, q, {std::nextafter(0.5, 1), 1}));
}

// Products of three lengths leave the range of doubles on both sides.
TEST(Pillar, IsRightAtEveryMagnitude) {
    RandomTriangles random(3);
    const int rounds = soak(20000);
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(round);
        const int length = static_cast<int>(random.number(-500, 500));
        const int direction = static_cast<int>(random.number(-500, 500));
        Case c{{random.dyadic(8) * 0.25, random.dyadic(8)}, {random.dyadic(8), random.dyadic(8), random.dyadic(8)}};
        if (round % 2 == 0) { // through an edge
            c.vertex.v = 0.5 * (c.triangle[0] + c.triangle[1]) - 0.25 * c.vertex.d;
        }
        const Sign expected = Hit(c.vertex, c.triangle).pierces();
        c.vertex.v *= std::ldexp(1.0, length);
        c.vertex.d *= std::ldexp(1.0, direction);
        for (Vec3& corner : c.triangle) {
            corner *= std::ldexp(1.0, length);
        }
        ASSERT_EQ(Hit(c.vertex, c.triangle).pierces(), expected);
        expect_right(c);
        if (testing::Test::HasFatalFailure()) {
            return;
        }
    }
}

// At |d||e||e'| around 1e308 some products overflow, and others, of the opposite sign, do not.
TEST(Pillar, IsRightWhereProductsOverflow) {
    RandomTriangles random(4);
    const int rounds = soak(100000);
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(round);
        const double length = 0x1p341;
        const Case c{{length * random.vector(0.2), 4 * length * random.vector()},
                     {length * random.vector(), length * random.vector(), length * random.vector()}};
        expect_right(c);
        if (testing::Test::HasFatalFailure()) {
            return;
        }
    }
}

} // namespace
} // namespace foldless
