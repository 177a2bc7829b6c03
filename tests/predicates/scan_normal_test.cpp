#include "exact_vector.h"
#include "random_triangles.h"

#include <foldless/predicates/scan_normal.h>

#include <gtest/gtest.h>

#include <cmath>

namespace foldless {
namespace {

using exact::Vector;

Vector exact_normal(const ScanTriangle& q) {
    return exact::cross(Vector(q[1]) - Vector(q[0]), Vector(q[2]) - Vector(q[0]));
}

Sign sign_of(const mpq_class& value) {
    return sgn(value) > 0 ? Sign::positive : sgn(value) < 0 ? Sign::negative : Sign::zero;
}

void expect_right(Sign answer, const mpq_class& truth) {
    if (answer != Sign::undecided) {
        EXPECT_EQ(answer, sign_of(truth));
    }
}

const ScanTriangle upright{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};

TEST(ScanNormal, IsTheCrossProductOfTheEdges) {
    EXPECT_EQ(ScanNormal(upright).value(), Vec3(0, 0, 1));
    EXPECT_EQ(ScanNormal(upright).seen_along({5, 5, 1}), Sign::positive);
    EXPECT_EQ(ScanNormal(upright).seen_along({5, 5, -1}), Sign::negative);
}

TEST(ScanNormal, BoundsItsError) {
    RandomTriangles random(1);
    for (int round = 0; round < 3000; ++round) {
        const Vec3 far = random.vector(std::ldexp(1.0, round % 30));
        const ScanTriangle q{far + random.vector(), far + random.vector(), far + random.vector()};
        const Vec3 d = random.vector();
        const ScanNormal normal(q);
        const mpq_class off = mpq_class(d.dot(normal.value())) - exact::dot(Vector(d), exact_normal(q));
        EXPECT_LE(abs(off), mpq_class(normal.error(d))) << "round " << round;
    }
}

TEST(ScanNormal, OfUnitLengthBoundsItsErrorToo) {
    RandomTriangles random(5);
    for (int round = 0; round < 3000; ++round) {
        const Vec3 far = random.vector(std::ldexp(1.0, round % 30));
        const ScanTriangle q{far + random.vector(), far + random.vector(), far + random.vector()};
        const Vec3 d = random.vector();
        const double length = ScanNormal(q).value().norm();
        const ScanNormal unit = ScanNormal(q).normalised();
        EXPECT_NEAR(unit.value().norm(), 1, 1e-15);
        const mpq_class off =
            mpq_class(d.dot(unit.value())) - exact::dot(Vector(d), exact_normal(q)) / mpq_class(length);
        EXPECT_LE(abs(off), mpq_class(unit.error(d))) << "round " << round;
    }
}

TEST(ScanNormal, OfATriangleWithoutAreaIsUndecided) {
    const ScanNormal unit = ScanNormal({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)}).normalised();
    EXPECT_EQ(unit.seen_along({0, 0, 1}), Sign::undecided);
    EXPECT_EQ(unit.seen_along({1, 2, 3}), Sign::undecided);
}

// Directions in the plane of the triangle but for their rounding.
TEST(ScanNormal, IsNeverWrongAboutDirectionsNearlyInThePlane) {
    RandomTriangles random(2);
    int undecided = 0;
    constexpr int rounds = 5000;
    for (int round = 0; round < rounds; ++round) {
        const ScanTriangle q{random.vector(), random.vector(), random.vector()};
        const Vec3 d = random.number(-1, 1) * (q[1] - q[0]) + random.number(-1, 1) * (q[2] - q[0]);
        const mpq_class truth = exact::dot(Vector(d), exact_normal(q));
        expect_right(ScanNormal(q).seen_along(d), truth);
        undecided += ScanNormal(q).seen_along(d) == Sign::undecided ? 1 : 0;
        EXPECT_EQ(seen_along(d, q), sign_of(truth));
    }
    EXPECT_GT(undecided, 0) << "the directions are not near enough to the plane to be a test";
}

TEST(SeenAlong, DecidesWhatIntervalsCanDecide) {
    EXPECT_EQ(seen_along({1, 1, 0}, upright), Sign::zero);
    EXPECT_EQ(seen_along({1, 1, 0x1p-1000}, upright), Sign::positive);
    EXPECT_EQ(seen_along({1, 1, -0x1p-1000}, upright), Sign::negative);
    EXPECT_EQ(ScanNormal(upright).seen_along({1, 1, 0x1p-1000}), Sign::undecided);
}

TEST(SeenAlong, IsZeroForATriangleWithoutArea) {
    const ScanTriangle line{Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 2, 2)};
    EXPECT_EQ(seen_along({0, 0, 1}, line), Sign::zero);
}

TEST(SeenAlong, IsRightAtEveryMagnitude) {
    for (const int size : {-1070, -500, 0, 500, 1000}) {
        for (const int length : {-1070, -500, 0, 500, 1000}) {
            const double s = std::ldexp(1.0, size);
            const ScanTriangle q{Vec3(0, 0, 0), Vec3(s, 0, 0), Vec3(0, s, 0)};
            const double up = std::ldexp(1.0, length);
            EXPECT_EQ(seen_along({7 * up, 5 * up, up}, q), Sign::positive) << size << " " << length;
            EXPECT_EQ(seen_along({7 * up, 5 * up, -up}, q), Sign::negative) << size << " " << length;
            EXPECT_EQ(seen_along({7 * up, 5 * up, 0}, q), Sign::zero) << size << " " << length;
        }
    }
}

TEST(SeenAlong, IsUndecidedForWhatIsNotFinite) {
    EXPECT_EQ(seen_along({0, 0, std::nan("")}, upright), Sign::undecided);
    EXPECT_EQ(seen_along({0, 0, 1}, {Vec3(0, 0, 0), Vec3(HUGE_VAL, 0, 0), Vec3(0, 1, 0)}), Sign::undecided);
}

/// m(alpha), exactly.
mpq_class m_of(const std::array<Vec3, 3>& d, const std::array<mpq_class, 3>& alpha, const ScanTriangle& q) {
    mpq_class m = 0;
    for (int i = 0; i < 3; ++i) {
        m += alpha[i] * exact::dot(Vector(d[i]), exact_normal(q));
    }
    return m;
}

TEST(NormalCondition, IsTheSignOfTheInterpolatedDirection) {
    const ScanNormal normal(upright);
    const std::array<Vec3, 3> directions{Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, -3)};
    EXPECT_EQ(normal_condition(directions, {1, 0, 0}, 0, normal), Sign::positive);
    EXPECT_EQ(normal_condition(directions, {0, 0, 1}, 0, normal), Sign::negative);
    EXPECT_EQ(normal_condition(directions, {0.5, 0.3, 0.2}, 0, normal), Sign::positive);
    EXPECT_EQ(normal_condition(directions, {0.5, 0.2, 0.3}, 0, normal), Sign::negative);
    EXPECT_EQ(normal_condition(directions, {0.5, 0.3, 0.2}, 0.1, normal), Sign::undecided);
}

// Right for every alpha within the error: the extremes of a linear function are at the corners of the box.
TEST(NormalCondition, HoldsForEveryAlphaWithinItsError) {
    RandomTriangles random(3);
    int decided = 0;
    for (int round = 0; round < 3000; ++round) {
        const ScanTriangle q{random.vector(), random.vector(), random.vector()};
        const std::array<Vec3, 3> d{random.vector(), random.vector(), random.vector()};
        const Vec3 alpha = random.barycentric();
        const double error = round % 2 == 0 ? 0.0 : random.number(0, 0.2);
        const Sign sign = normal_condition(d, alpha, error, ScanNormal(q));
        if (sign == Sign::undecided) {
            continue;
        }
        ++decided;
        for (int corner = 0; corner < 8; ++corner) {
            std::array<mpq_class, 3> moved;
            for (int i = 0; i < 3; ++i) {
                moved[i] = mpq_class(alpha[i]) + ((corner >> i) % 2 == 0 ? 1 : -1) * mpq_class(error);
            }
            EXPECT_EQ(sign, sign_of(m_of(d, moved, q))) << "round " << round;
        }
    }
    EXPECT_GT(decided, 1500);
}

} // namespace
} // namespace foldless
