#include "../soak.h"
#include "prismoid_samples.h"

#include <foldless/predicates/prismoid_point.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace foldless {
namespace {

const double infinity = std::numeric_limits<double>::infinity();

/// The place of q as the predicate has it, found to agree with the oracle, with and without filters.
std::optional<PrismoidPoint> checked_place(const Prismoid& prismoid, const Vec3& q) {
    const std::vector<oracle::Place> expected = oracle::places(prismoid.triangle, prismoid.range, q);
    EXPECT_LE(expected.size(), 1U) << "against lemma L3";
    const PointFinder finder(prismoid.triangle, prismoid.range);
    const auto agrees = [&](const std::optional<PrismoidPoint>& place) {
        EXPECT_EQ(place.has_value(), !expected.empty());
        if (place && !expected.empty()) {
            EXPECT_EQ(place->walls, expected[0].walls);
            EXPECT_TRUE(is_root(place->t, expected[0].t));
        }
    };
    {
        const WithoutFilters exactly;
        agrees(finder.find(q));
    }
    std::optional<PrismoidPoint> place = finder.find(q);
    agrees(place);
    return place;
}

void expect_normal_condition(const Prismoid& prismoid, const Vec3& q, const PrismoidPoint& place,
                             const ScanTriangle& scan) {
    const oracle::Root t = oracle::places(prismoid.triangle, prismoid.range, q)[0].t;
    const Sign expected = as_sign(oracle::normal_condition(prismoid.triangle, q, t, scan));
    EXPECT_EQ(normal_condition_at(prismoid.triangle, q, place.t, scan), expected);
    const WithoutFilters exactly;
    EXPECT_EQ(normal_condition_at(prismoid.triangle, q, place.t, scan), expected);
}

TEST(PointFinder, FindsRandomPointsWhereRationalArithmeticDoes) {
    Samples random(1);
    int found = 0;
    const int rounds = soak(100000);
    Prismoid prismoid;
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(round);
        if (round % 16 == 0) {
            prismoid = random.prismoid(round % 32 == 0 ? Sample::random : Sample::random_prism);
        }
        Vec3 alpha = random.barycentric();
        if (round % 2 == 0) {
            alpha += 0.5 * random.vector();
            alpha /= alpha.sum();
        }
        const Vec3 q = displaced(prismoid.triangle, alpha, random.number(-1, 1));
        const std::optional<PrismoidPoint> place = checked_place(prismoid, q);
        if (place) {
            ++found;
            expect_normal_condition(prismoid, q, *place, {q, random.vector(), random.vector()});
            const RoundedPlace rounded = rounded_place(prismoid.triangle, q, place->t);
            EXPECT_LT((displaced(prismoid.triangle, rounded.alpha, rounded.t) - q).norm(), 1e-12);
        }
        if (testing::Test::HasFailure()) {
            return;
        }
    }
    EXPECT_GT(found, rounds / 8);
}

// With few digits, points lie exactly on walls, pillars and ends of ranges; then again one ulp beside them.
TEST(PointFinder, FindsPointsOnAndOneUlpBesideWallsPillarsAndEndsOfTheRange) {
    Samples random(2);
    int on_wall = 0;
    int on_pillar = 0;
    int at_end = 0;
    const int rounds = soak(60000);
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(round);
        Prismoid prismoid = random.prismoid(static_cast<Sample>(1 + round % (samples - 1)));
        const Vec3 alpha = random.coarse_barycentric();
        const double t = round % 3 == 0   ? prismoid.range.lo
                         : round % 3 == 1 ? prismoid.range.hi
                                          : random.fraction(8, -1, 1);
        Vec3 q = displaced(prismoid.triangle, alpha, t);
        const SignCounts before = sign_counts();
        std::optional<PrismoidPoint> place = checked_place(prismoid, q);
        if (place && place->walls != 0) {
            EXPECT_GT(sign_counts().exact, before.exact);
            on_wall += 1;
            on_pillar += place->walls == walls_at_corner(0) || place->walls == walls_at_corner(1) ||
                         place->walls == walls_at_corner(2);
        }
        if (place) {
            at_end += within(place->t, prismoid.range) == Sign::zero ? 1 : 0;
            // m = 0 for the plane that holds the direction there.
            const Vec3 d = alpha[0] * prismoid.triangle.d[0] + alpha[1] * prismoid.triangle.d[1] +
                           alpha[2] * prismoid.triangle.d[2];
            expect_normal_condition(prismoid, q, *place, {q, q + d, q + random.dyadic(3)});
        }
        q[round % 3] = std::nextafter(q[round % 3], round % 2 == 0 ? infinity : -infinity);
        place = checked_place(prismoid, q);
        if (place) {
            expect_normal_condition(prismoid, q, *place, {q, random.dyadic(3), random.dyadic(3)});
        }
        // The range ends at the double nearest to a displacement that is none, and beside it.
        if (place) {
            const double end = place->t.approximate();
            for (const double hi : {end, std::nextafter(end, infinity), std::nextafter(end, -infinity)}) {
                checked_place({prismoid.triangle, {std::min(hi, prismoid.range.lo), hi}}, q);
                checked_place({prismoid.triangle, {hi, std::max(hi, prismoid.range.hi)}}, q);
            }
        }
        if (testing::Test::HasFailure()) {
            return;
        }
    }
    EXPECT_GT(on_wall, rounds / 8);
    EXPECT_GT(on_pillar, rounds / 40);
    EXPECT_GT(at_end, rounds / 8);
}

// All three roots at the top of the pyramid, or two of them elsewhere: J = 0 there, outside the range.
TEST(PointFinder, KeepsToTheRangeBesideDoubleAndTripleRoots) {
    const BaseTriangle pyramid{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                               {Vec3(0.25, 0.25, 1), Vec3(-0.75, 0.25, 1), Vec3(0.25, -0.75, 1)}};
    for (const double below : {0x1p-2, 0x1p-20, 0x1p-52}) {
        const Prismoid prismoid{pyramid, {0, 1 - below}};
        ASSERT_TRUE(oracle::jacobian_is_positive(pyramid, prismoid.range));
        EXPECT_FALSE(checked_place(prismoid, Vec3(0.25, 0.25, 1)));
        EXPECT_TRUE(checked_place(prismoid, Vec3(0.25, 0.25, 1 - below)));
        EXPECT_FALSE(checked_place(prismoid, Vec3(0.25, 0.25, 1 - below / 2)));
        EXPECT_TRUE(checked_place(prismoid, Vec3(0.25, 0.25, 0.5)));
        EXPECT_FALSE(checked_place(prismoid, Vec3(0.5, 0.5, 0.5)));
    }
    // A point whose cubic has a double root within the range, outside the triangle, where J changes its sign.
    Samples random(3);
    int doubles = 0;
    const int rounds = soak(20000);
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(round);
        const Prismoid prismoid = random.prismoid(Sample::dyadic);
        const double t = random.fraction(8, -1, 1);
        // Exact in doubles: few digits. J is linear in alpha, and zero far outside the triangle.
        const Vec3 e1 = prismoid.triangle.corner(1, t) - prismoid.triangle.corner(0, t);
        const Vec3 e2 = prismoid.triangle.corner(2, t) - prismoid.triangle.corner(0, t);
        Vec3 alpha(random.fraction(4, -4, 4), 0, 0);
        for (double beta = -8; beta <= 8; beta += 0.125) {
            alpha = Vec3(alpha[0], beta, 1 - alpha[0] - beta);
            const Vec3 d = alpha[0] * prismoid.triangle.d[0] + alpha[1] * prismoid.triangle.d[1] +
                           alpha[2] * prismoid.triangle.d[2];
            if (e1.cross(e2).dot(d) == 0) {
                break;
            }
        }
        const Vec3 q = displaced(prismoid.triangle, alpha, t);
        checked_place(prismoid, q);
        const oracle::Polynomial cubic = oracle::cubic(prismoid.triangle, q);
        doubles += oracle::common_divisor(cubic, oracle::derivative(cubic)).size() > 1 ? 1 : 0;
        if (testing::Test::HasFailure()) {
            return;
        }
    }
    EXPECT_GT(doubles, rounds / 40);
}

TEST(PointFinder, FindsInARangeOfOnePoint) {
    const BaseTriangle prism{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                             {Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1)}};
    const Prismoid flat{prism, {0, 0}};
    EXPECT_TRUE(checked_place(flat, Vec3(0.25, 0.25, 0)));
    EXPECT_TRUE(checked_place(flat, Vec3(0, 0, 0)));
    EXPECT_FALSE(checked_place(flat, Vec3(0.25, 0.25, 0x1p-1074)));
    EXPECT_FALSE(checked_place(flat, Vec3(0.25, -0x1p-1074, 0)));
}

// Powers of two change no sign, but leave every range of the filters.
TEST(PointFinder, AnswersTheSameAtEveryMagnitude) {
    Samples random(4);
    const int rounds = soak(20000);
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(round);
        const Prismoid prismoid = random.prismoid(static_cast<Sample>(round % samples));
        Vec3 alpha = random.coarse_barycentric();
        if (round % 4 == 0) {
            alpha += Vec3(0.25, -0.25, 0);
        }
        const Vec3 q = displaced(prismoid.triangle, alpha, random.fraction(8, -1, 1));
        const std::optional<PrismoidPoint> expected = checked_place(prismoid, q);
        const int length = random.integer(-500, 500);
        const int unit = random.integer(-400, 400);
        Prismoid scaled = prismoid;
        for (int i = 0; i < 3; ++i) {
            scaled.triangle.v[i] *= std::ldexp(1.0, length);
            scaled.triangle.d[i] *= std::ldexp(1.0, length - unit);
        }
        scaled.range = {std::ldexp(prismoid.range.lo, unit), std::ldexp(prismoid.range.hi, unit)};
        const Vec3 scaled_q = q * std::ldexp(1.0, length);
        const std::optional<PrismoidPoint> place = PointFinder(scaled.triangle, scaled.range).find(scaled_q);
        ASSERT_EQ(place.has_value(), expected.has_value());
        if (place) {
            ASSERT_EQ(place->walls, expected->walls);
            const ScanTriangle scan{q, q + random.dyadic(8), q + random.dyadic(8)};
            ScanTriangle scaled_scan = scan;
            for (Vec3& corner : scaled_scan) {
                corner *= std::ldexp(1.0, length);
            }
            ASSERT_EQ(normal_condition_at(scaled.triangle, scaled_q, place->t, scaled_scan),
                      normal_condition_at(prismoid.triangle, q, expected->t, scan));
        }
        if (testing::Test::HasFailure()) {
            return;
        }
    }
}

// The scan triangle lies in a slice, and holds the line of the wall: m_k > 0 decides, with filters and without.
TEST(NormalConditionAtWall, IsPositiveInTheSliceIfBothDirectionsSeeTheTriangle) {
    BaseTriangle triangle{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                          {Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0.5, 0.5, 1)}};
    const ScanTriangle scan{Vec3(0.25, 0.25, 0), Vec3(0.25, -0.5, 0), Vec3(0.5, 0.25, 0)};
    const ScanTriangle behind{scan[0], scan[2], scan[1]};
    const WallPoint point{2, Displacement(0.0), {&scan[0], &scan[1]}};
    for (const bool filters : {true, false}) {
        set_filters_enabled(filters);
        EXPECT_EQ(normal_condition_at_wall(triangle, point, scan), Sign::positive);
        EXPECT_EQ(normal_condition_at_wall(triangle, point, behind), Sign::negative);
    }
    set_filters_enabled(true);
}

// The plane y = z of the scan triangle holds the wall's line in the slice t = 0. From (0, 0, 0) to (1, 0, 0) m falls
// from positive to negative: the place on the line decides.
TEST(NormalConditionAtWall, IsThatOfThePlaceWhereThePlaneHoldsTheLineOfTheWall) {
    const BaseTriangle triangle{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                                {Vec3(0, 0, 1), Vec3(0, 2, 1), Vec3(0, 0, 1)}};
    for (const double x : {0.25, 0.5, 0.75}) {
        const Vec3 p(x, 0.25, 0.25);
        const Vec3 q(x, -0.25, -0.25);
        const ScanTriangle scan{p, q, Vec3(1, 0, 0)};
        const Sign expected = x < 0.5 ? Sign::positive : x > 0.5 ? Sign::negative : Sign::zero;
        EXPECT_EQ(normal_condition_at_wall(triangle, {2, Displacement(0.0), {&p, &q}}, scan), expected) << x;
    }
}

// Filters carry the work: no exact number is needed for points in general position.
TEST(PointFinder, DecidesRandomPointsWithoutExactNumbers) {
    Samples random(5);
    const SignCounts before = sign_counts();
    constexpr int rounds = 2000;
    Prismoid prismoid;
    for (int round = 0; round < rounds; ++round) {
        if (round % 16 == 0) {
            prismoid = random.prismoid(Sample::random);
        }
        const Vec3 q = displaced(prismoid.triangle, random.barycentric(), random.number(-0.5, 0.5));
        const PointFinder finder(prismoid.triangle, prismoid.range);
        const std::optional<PrismoidPoint> place = finder.find(q);
        EXPECT_TRUE(!place || place->walls == 0);
    }
    EXPECT_LT(sign_counts().exact - before.exact, rounds / 100);
    EXPECT_GT(sign_counts().filtered - before.filtered, rounds);
}

} // namespace
} // namespace foldless
