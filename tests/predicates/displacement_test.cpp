#include "../soak.h"
#include "prismoid_samples.h"

#include <foldless/predicates/displacement.h>
#include <foldless/predicates/prismoid_line.h>
#include <foldless/predicates/prismoid_point.h>

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

namespace foldless {
namespace {

const double infinity = std::numeric_limits<double>::infinity();

/// A displacement of a kind that the predicates produce, with the root that it stands for.
struct Known {
    Displacement t;
    oracle::Root root;
};

TEST(Displacement, OfADoubleIsThatDouble) {
    const Displacement t(0.25);
    EXPECT_TRUE(t.is_double());
    EXPECT_EQ(t.approximate(), 0.25);
    EXPECT_EQ(compare(t, Displacement(0.25)), Sign::zero);
    EXPECT_EQ(compare(t, Displacement(std::nextafter(0.25, 1))), Sign::negative);
    EXPECT_EQ(compare(t, Displacement(-0.25)), Sign::positive);
    EXPECT_EQ(compare(Displacement(0.0), Displacement(-0.0)), Sign::zero);
    const WithoutFilters exactly;
    EXPECT_EQ(compare(t, Displacement(std::nextafter(0.25, 0))), Sign::positive);
    EXPECT_EQ(compare(t, Displacement(0.25)), Sign::zero);
}

TEST(Within, IsPositiveInsideZeroAtTheEndsAndNegativeOutside) {
    const Range range{-0.5, 0.25};
    for (const bool filters : {true, false}) {
        set_filters_enabled(filters);
        EXPECT_EQ(within(Displacement(0.0), range), Sign::positive);
        EXPECT_EQ(within(Displacement(-0.5), range), Sign::zero);
        EXPECT_EQ(within(Displacement(0.25), range), Sign::zero);
        EXPECT_EQ(within(Displacement(std::nextafter(0.25, 1)), range), Sign::negative);
        EXPECT_EQ(within(Displacement(std::nextafter(-0.5, -1)), range), Sign::negative);
        EXPECT_EQ(within(Displacement(0.25), {0.25, 0.25}), Sign::zero);
    }
    set_filters_enabled(true);
}

/// Places and crossings of a few points and lines of one prismoid.
std::vector<Known> displacements(Samples& random, const Prismoid& prismoid, const std::vector<Vec3>& points) {
    std::vector<Known> result;
    const PointFinder finder(prismoid.triangle, prismoid.range);
    std::vector<std::optional<PrismoidPoint>> places;
    for (const Vec3& q : points) {
        places.push_back(finder.find(q));
        const std::vector<oracle::Place> expected = oracle::places(prismoid.triangle, prismoid.range, q);
        EXPECT_EQ(places.back().has_value(), !expected.empty());
        if (places.back() && !expected.empty()) {
            result.push_back({places.back()->t, expected[0].t});
        }
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < points.size(); ++j) {
            if (!places[i] || points[i] == points[j]) {
                continue;
            }
            const std::vector<oracle::Place> start = oracle::places(prismoid.triangle, prismoid.range, points[i]);
            const Passage passage = follow_line(prismoid.triangle, {&points[i], &points[j]}, *places[i], nullptr);
            const std::optional<oracle::Exit> exit =
                oracle::exit_of(prismoid.triangle, prismoid.range, points[i], points[j], start[0]);
            if (exit && passage.kind == Passage::Kind::leaves) {
                result.push_back({passage.t, exit->t});
            }
        }
    }
    const double t = random.fraction(8, -1, 1);
    result.push_back({Displacement(t), oracle::root_at(t)});
    return result;
}

void expect_ordered(const std::vector<Known>& known, int& zeros) {
    for (const Known& a : known) {
        ASSERT_TRUE(is_root(a.t, a.root));
        for (const Known& b : known) {
            const Sign expected = as_sign(oracle::compare(a.root, b.root));
            zeros += &a != &b && expected == Sign::zero ? 1 : 0;
            ASSERT_EQ(compare(a.t, b.t), expected);
            const WithoutFilters exactly;
            ASSERT_EQ(compare(a.t, b.t), expected);
        }
        // Against the doubles around it.
        const double near = a.t.approximate();
        for (const double x : {near, std::nextafter(near, infinity), std::nextafter(near, -infinity)}) {
            const Sign expected = as_sign(oracle::compare(a.root, oracle::root_at(x)));
            ASSERT_EQ(compare(a.t, Displacement(x)), expected);
            ASSERT_EQ(compare(Displacement(x), a.t), -expected);
            const WithoutFilters exactly;
            ASSERT_EQ(compare(a.t, Displacement(x)), expected);
        }
    }
}

TEST(Displacement, OfPlacesAndCrossingsIsComparedAsRationalArithmeticDoes) {
    Samples random(1);
    int zeros = 0;
    const int rounds = soak(20000);
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(round);
        const Sample sample = static_cast<Sample>(round % samples);
        const Prismoid prismoid = random.prismoid(sample);
        const bool coarse = sample != Sample::random && sample != Sample::random_prism;
        std::vector<Vec3> points;
        for (int i = 0; i < 3; ++i) {
            const Vec3 alpha = coarse ? random.coarse_barycentric() : random.barycentric();
            points.push_back(displaced(prismoid.triangle, alpha, random.fraction(8, -1, 1)));
        }
        points.push_back(points[0]); // the same place
        points.push_back(points[0] + Vec3(0, 0x1p-52, 0));
        expect_ordered(displacements(random, prismoid, points), zeros);
        if (testing::Test::HasFailure()) {
            return;
        }
    }
    EXPECT_GT(zeros, rounds);
}

// The crossings of a wall as its two faces see them are the same number from two polynomials, or from one and a cubic.
TEST(Displacement, IsEqualFromBothSidesOfAWall) {
    Samples random(2);
    int both = 0;
    const SignCounts before = sign_counts();
    const int rounds = soak(20000);
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(round);
        const std::vector<Prismoid> fan = random.fan(Sample::random, 5);
        const Vec3 p = displaced(fan[0].triangle, random.barycentric(), 0);
        const Vec3 q = displaced(fan[1].triangle, random.barycentric(), random.number(-0.1, 0.1));
        const std::optional<PrismoidPoint> a = PointFinder(fan[0].triangle, fan[0].range).find(p);
        const std::optional<PrismoidPoint> b = PointFinder(fan[1].triangle, fan[1].range).find(q);
        if (!a || !b) {
            continue;
        }
        const Passage forth = follow_line(fan[0].triangle, {&p, &q}, *a, nullptr);
        const Passage back = follow_line(fan[1].triangle, {&q, &p}, *b, nullptr);
        if (forth.kind == Passage::Kind::leaves && back.kind == Passage::Kind::leaves && forth.wall == 1 &&
            back.wall == 2) {
            ++both;
            EXPECT_EQ(compare(forth.t, back.t), Sign::zero);
        }
    }
    EXPECT_GT(both, rounds / 4);
    EXPECT_GE(sign_counts().exact - before.exact, both);
}

TEST(Displacement, ThatIsADoubleIsKnownAsOne) {
    const BaseTriangle prism{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                             {Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1)}};
    const PointFinder finder(prism, {-0.3, 0.7});
    for (const double t : {0.0, 0.5, -0.125, 0.1, 0x1p-900, -0x1p-1074}) {
        const Vec3 q(0.25, 0.25, t);
        for (const bool filters : {true, false}) {
            set_filters_enabled(filters);
            const std::optional<PrismoidPoint> place = finder.find(q);
            set_filters_enabled(true);
            ASSERT_TRUE(place);
            const Range bounds = place->t.bounds();
            EXPECT_TRUE(bounds.lo <= t && t <= bounds.hi);
            EXPECT_LE(bounds.hi - bounds.lo, 1e-15 * std::abs(t) + 0x1p-1000) << t;
        }
    }
    // Exactly, if halving the range meets it or it is 0.
    const WithoutFilters exactly;
    for (const double t : {0.0, 0.5, -0.125}) {
        const Vec3 q(0.25, 0.25, t);
        EXPECT_TRUE(PointFinder(prism, {-1, 1}).find(q)->t.is_double());
    }
    const Vec3 on_base(0.25, 0.25, 0);
    EXPECT_TRUE(finder.find(on_base)->t.is_double());
}

// What files record, and what ranges are made of.
TEST(Displacement, IsKnownToTheLastDigitsWhereverItLies) {
    // A line that crosses the wall y = 0 of an almost right prism at t = x: the other root of its quadratic is far
    // away.
    for (const double x : {0.5, 1.0 / 3, 0x1p-30 / 3, 0x1p-90 / 3}) {
        for (int exponent = 4; exponent <= 200; exponent += 14) {
            BaseTriangle triangle{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                                  {Vec3(0, 0, 1), Vec3(0, std::ldexp(1.0, -exponent), 1), Vec3(0, 0, 1)}};
            const Vec3 p(0.25, 0.25, 0);
            const Vec3 q(0.5, -0.25, 2 * x);
            const PrismoidPoint start{Displacement(0.0), 0};
            for (const bool filters : {true, false}) {
                set_filters_enabled(filters);
                const Passage passage = follow_line(triangle, {&p, &q}, start, nullptr);
                set_filters_enabled(true);
                ASSERT_EQ(passage.kind, Passage::Kind::leaves);
                ASSERT_EQ(passage.wall, 2);
                const Range bounds = passage.t.bounds();
                EXPECT_LE(bounds.hi - bounds.lo, filters ? 1e-12 : 1e-14 * bounds.hi)
                    << (filters ? "with filters, " : "without, ") << "x " << x << ", exponent " << exponent;
            }
        }
    }
}

} // namespace
} // namespace foldless
