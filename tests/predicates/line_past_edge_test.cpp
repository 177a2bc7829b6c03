#include "exact_vector.h"
#include "random_triangles.h"

#include "../soak.h"

#include <foldless/predicates/line_past_edge.h>
#include <foldless/predicates/sign_counts.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace foldless {
namespace {

using Rational = mpq_class;
using exact::Vector;

/// sum w_i u_i / sum w_i.
Vector interpolated(const std::array<Vec3, 3>& u, const Vec3& weights) {
    Vector sum = Rational(weights[0]) * Vector(u[0]);
    sum = sum + Rational(weights[1]) * Vector(u[1]);
    sum = sum + Rational(weights[2]) * Vector(u[2]);
    const Rational all = Rational(weights[0]) + Rational(weights[1]) + Rational(weights[2]);
    return Rational(1 / all) * sum;
}

/// det(a - x, b - x, d) of the line through the exact point.
Rational oracle_side(const BaseTriangle& triangle, const Vec3& weights, const Vec3& a, const Vec3& b) {
    const Vector x = interpolated(triangle.v, weights);
    const Vector d = interpolated(triangle.d, weights);
    return exact::dot(exact::cross(Vector(a) - x, Vector(b) - x), d);
}

Sign sign_of_rational(const Rational& number) {
    return sgn(number) > 0 ? Sign::positive : sgn(number) < 0 ? Sign::negative : Sign::zero;
}

struct Case {
    BaseTriangle triangle;
    Vec3 weights;
    Vec3 a, b;
};

/// With filters and without: the sign, that of the value, and the opposite for the edge the other way round.
void expect_right(const Case& c) {
    const Sign expected = sign_of_rational(oracle_side(c.triangle, c.weights, c.a, c.b));
    const SampleLine line(c.triangle, c.weights);
    for (const bool filters : {true, false}) {
        set_filters_enabled(filters);
        const SampleLine::Side there = line.side(c.a, c.b);
        const SampleLine::Side back = line.side(c.b, c.a);
        set_filters_enabled(true);
        ASSERT_EQ(there.sign, expected) << (filters ? "with" : "without") << " filters";
        ASSERT_EQ(back.sign, -expected);
        ASSERT_EQ(there.value > 0, expected == Sign::positive);
        ASSERT_EQ(there.value < 0, expected == Sign::negative);
        ASSERT_EQ(back.value, -there.value);
    }
}

/// Weights of a lattice of up to 2^20 by 2^20, some of them of samples outside the triangle.
Vec3 random_weights(RandomTriangles& random) {
    const double columns = std::floor(std::exp2(random.number(0, 20)));
    const double rows = std::floor(std::exp2(random.number(0, 20)));
    const double i = std::floor(random.number(-0.2, 1.2) * columns);
    const double j = std::floor(random.number(-0.2, 1.2) * rows);
    return {columns * rows - i * rows - j * columns, i * rows, j * columns};
}

Vec3 at_weights(const std::array<Vec3, 3>& u, const Vec3& weights) {
    return (weights[0] * u[0] + weights[1] * u[1] + weights[2] * u[2]) / weights.sum();
}

TEST(LinePastEdge, HasTheSignOfExactArithmetic) {
    RandomTriangles random(1);
    for (int round = 0; round < soak(200000); ++round) {
        SCOPED_TRACE(round);
        const BaseTriangle triangle = round % 2 == 0 ? random.wild() : random.tame();
        expect_right({triangle, random_weights(random), random.vector(), random.vector()});
        if (testing::Test::HasFatalFailure()) {
            return;
        }
    }
}

// The line meets the edge but for the rounding of a and b, or of a few units in the last place more.
TEST(LinePastEdge, IsRightNextToATie) {
    RandomTriangles random(2);
    for (int round = 0; round < soak(200000); ++round) {
        SCOPED_TRACE(round);
        Case c{round % 2 == 0 ? random.wild() : random.tame(), random_weights(random), {}, {}};
        const Vec3 x = at_weights(c.triangle.v, c.weights);
        const Vec3 d = at_weights(c.triangle.d, c.weights);
        const Vec3 met = x + random.number(-1, 1) * d;
        const Vec3 along = random.vector();
        c.a = met - random.number(-0.5, 1) * along;
        c.b = met + random.number(0, 1) * along;
        for (int step = 0; step < round % 4; ++step) {
            c.a[step % 3] = std::nextafter(c.a[step % 3], 2.0);
        }
        expect_right(c);
        if (testing::Test::HasFatalFailure()) {
            return;
        }
    }
}

// Multiples of powers of two, few enough for every product to be exact: the edge is met, not nearly.
TEST(LinePastEdge, IsZeroOnATieAndNotBeside) {
    RandomTriangles random(3);
    for (int round = 0; round < soak(100000); ++round) {
        SCOPED_TRACE(round);
        Case c{{{random.dyadic(8), random.dyadic(8), random.dyadic(8)},
                {random.dyadic(8), random.dyadic(8), random.dyadic(8)}},
               {16 - 5 - 3, 5, 3},
               {},
               {}};
        const Vec3 x = at_weights(c.triangle.v, c.weights);
        const Vec3 d = at_weights(c.triangle.d, c.weights);
        const Vec3 met = x + 0.25 * std::round(random.number(-8, 8)) * d;
        const Vec3 along = random.dyadic(8);
        c.a = met - 2 * along;
        c.b = met + 0.5 * along;
        ASSERT_EQ(SampleLine(c.triangle, c.weights).side(c.a, c.b).sign, Sign::zero);
        expect_right(c);
        c.b[round % 3] = std::nextafter(c.b[round % 3], round % 2 == 0 ? 4.0 : -4.0);
        expect_right(c);
        if (testing::Test::HasFatalFailure()) {
            return;
        }
    }
}

// Coordinates that rounding takes for those of the triangle's corner, or for nothing beside it.
TEST(LinePastEdge, IsRightAtEveryMagnitude) {
    RandomTriangles random(4);
    for (int round = 0; round < soak(100000); ++round) {
        SCOPED_TRACE(round);
        Case c{random.tame(), random_weights(random), random.vector(), random.vector()};
        const double length = std::exp2(std::round(random.number(-140, 140)));
        const double direction = std::exp2(std::round(random.number(-140, 140)));
        if (round % 2 == 0) {
            c.a = c.triangle.v[0];
        }
        for (int k = 0; k < 3; ++k) {
            c.triangle.v[k] *= length;
            c.triangle.d[k] *= direction;
        }
        c.a *= length;
        c.b *= length;
        expect_right(c);
        if (testing::Test::HasFatalFailure()) {
            return;
        }
    }
}

TEST(LinePastEdge, IsZeroForAnEdgeWithoutLengthAndALineWithoutDirection) {
    RandomTriangles random(5);
    const Case c{random.tame(), {1, 2, 4}, random.vector(), random.vector()};
    expect_right({c.triangle, c.weights, c.a, c.a});
    expect_right({{c.triangle.v, {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}}, c.weights, c.a, c.b});
    expect_right({{c.triangle.v, {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(0, 0, 1)}}, {1, 2, 1}, c.a, c.b});
}

/// Of the point where the line meets the plane of the triangle, by Cramer's rule on two edges of it.
std::array<Rational, 3> oracle_coordinates(const Vector& x, const Vector& d, const ScanTriangle& q) {
    const Vector e1 = Vector(q[1]) - Vector(q[0]);
    const Vector e2 = Vector(q[2]) - Vector(q[0]);
    const Vector from = x - Vector(q[0]);
    const Rational all = exact::dot(exact::cross(e2, e1), d);
    const Rational u = exact::dot(exact::cross(e2, from), d) / all;
    const Rational v = exact::dot(exact::cross(from, e1), d) / all;
    return {1 - u - v, u, v};
}

TEST(LinePastEdge, GivesBarycentricCoordinatesOfATriangle) {
    RandomTriangles random(6);
    int tested = 0;
    for (int round = 0; round < soak(100000); ++round) {
        const BaseTriangle triangle = random.tame();
        const Vec3 weights = random_weights(random);
        const SampleLine line(triangle, weights);
        const ScanTriangle q{random.vector(), random.vector(), random.vector()};
        const Vec3 sides(line.side(q[1], q[2]).value, line.side(q[2], q[0]).value, line.side(q[0], q[1]).value);
        const double facing = line.direction().dot((q[1] - q[0]).cross(q[2] - q[0]));
        EXPECT_NEAR(sides.sum(), facing, 1e-13) << round;
        constexpr double well_conditioned = 0.1;
        if (std::abs(facing) < well_conditioned) {
            continue;
        }
        const auto expected =
            oracle_coordinates(interpolated(triangle.v, weights), interpolated(triangle.d, weights), q);
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(sides[k] / sides.sum(), expected[k].get_d(), 1e-12) << round;
        }
        ++tested;
    }
    EXPECT_GT(tested, soak(100000) / 10);
}

TEST(LinePastEdge, StandsAtTheInterpolatedPoint) {
    RandomTriangles random(7);
    for (int round = 0; round < soak(20000); ++round) {
        const BaseTriangle triangle = random.wild();
        const Vec3 weights = random_weights(random);
        const SampleLine line(triangle, weights);
        const Vector x = interpolated(triangle.v, weights);
        const Vector d = interpolated(triangle.d, weights);
        EXPECT_LT((line.point() - Vec3(x.x.get_d(), x.y.get_d(), x.z.get_d())).norm(), 1e-14) << round;
        EXPECT_LT((line.direction() - Vec3(d.x.get_d(), d.y.get_d(), d.z.get_d())).norm(), 1e-14) << round;
    }
}

// For both faces of an edge of the scan: a line is on one side of it, or on it for both.
TEST(LinePastEdge, IsDecidedOnceForBothFacesOfAnEdge) {
    const BaseTriangle triangle{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                                {Vec3(0, 0, 1), Vec3(0.125, 0, 1), Vec3(0, 0, 1)}};
    const Vec3 a(0.1, 0.3, 1);
    const Vec3 b(0.7, 0.2, 2);
    for (int i = 0; i <= 64; ++i) {
        for (int j = 0; i + j <= 64; ++j) {
            const SampleLine line(triangle, Vec3(64 - i - j, i, j));
            EXPECT_EQ(line.side(a, b).sign, -line.side(b, a).sign);
        }
    }
}

} // namespace
} // namespace foldless
