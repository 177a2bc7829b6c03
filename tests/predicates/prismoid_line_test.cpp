#include "../soak.h"
#include "passage_oracle.h"
#include "prismoid_samples.h"

#include <foldless/predicates/prismoid_line.h>

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

namespace foldless {
namespace {

const double infinity = std::numeric_limits<double>::infinity();

/// What happened in the passages that were checked.
struct Counts {
    int ends = 0;
    int leaves = 0;
    int at_once = 0; ///< of those that leave
    int pillars = 0;
    int lost = 0;
    int exact = 0; ///< that needed exact numbers

    [[nodiscard]] int passages() const { return ends + leaves + pillars + lost; }
};
Counts counts;

using Kind = Passage::Kind;

/// A start or an end as both know it.
struct Known {
    PrismoidPoint at;
    oracle::Root t;
};

/// The place of q in the prismoid.
std::optional<Known> known_place(const Prismoid& prismoid, const Vec3& q) {
    const std::vector<oracle::Place> places = oracle::places(prismoid.triangle, prismoid.range, q);
    const std::optional<PrismoidPoint> at = PointFinder(prismoid.triangle, prismoid.range).find(q);
    EXPECT_EQ(at.has_value(), !places.empty());
    if (!at || places.empty()) {
        return std::nullopt;
    }
    EXPECT_EQ(at->walls, places[0].walls);
    return Known{*at, places[0].t};
}

/// The kept vertex at corner k.
Known at_kept_corner(int k) {
    return {{Displacement(0.0), walls_at_corner(k)}, oracle::root_at(0)};
}

/// The next passage, found to agree with the oracle, with and without filters; and the wall point as the oracle has it.
struct Step {
    Passage passage;
    std::optional<oracle::Exit> exit;
};
Step checked_step(const Prismoid& prismoid, const Vec3& p, const Vec3& q, const Known& start,
                  const std::optional<Known>& end) {
    const ScanLine line{&p, &q};
    const std::optional<oracle::Exit> exit =
        oracle::exit_of(prismoid.triangle, prismoid.range, p, q, {start.t, start.at.walls});
    const TruePassage truth{prismoid.range, exit, end ? std::optional(end->t) : std::nullopt};
    const PrismoidPoint* known_end = end ? &end->at : nullptr;
    {
        const WithoutFilters exactly;
        EXPECT_EQ(disagreement(follow_line(prismoid.triangle, line, start.at, known_end), truth), "");
    }
    const SignCounts before = sign_counts();
    const Passage passage = follow_line(prismoid.triangle, line, start.at, known_end);
    counts.exact += sign_counts().exact > before.exact ? 1 : 0;
    EXPECT_EQ(disagreement(passage, truth), "");
    counts.ends += passage.kind == Kind::ends ? 1 : 0;
    counts.lost += passage.kind == Kind::lost ? 1 : 0;
    counts.pillars += passage.kind == Kind::pillar ? 1 : 0;
    counts.leaves += passage.kind == Kind::leaves ? 1 : 0;
    counts.at_once += passage.kind == Kind::leaves && exit && exit->at_start ? 1 : 0;
    if (passage.kind == Kind::leaves && exit && exit->past_end <= 0) {
        // X, for a scan triangle on the line.
        const ScanTriangle scan{p, q, p + Vec3(q[1] - p[1] + 0.25, p[0] - q[0] - 0.125, 0.0625)};
        const Sign expected =
            as_sign(oracle::normal_condition_at_wall(prismoid.triangle, passage.wall, p, q, exit->t, scan));
        const WallPoint at{passage.wall, passage.t, line};
        EXPECT_EQ(normal_condition_at_wall(prismoid.triangle, at, scan), expected);
        const WithoutFilters exactly;
        EXPECT_EQ(normal_condition_at_wall(prismoid.triangle, at, scan), expected);
    }
    return {passage, exit};
}

/// Follows the line through a fan from face to face; each passage is checked.
void check_line(const std::vector<Prismoid>& fan, const Vec3& p, const Vec3& q) {
    const int n = static_cast<int>(fan.size());
    int at = 0;
    std::optional<Known> start;
    for (at = 0; at < n && !start; ++at) {
        start = known_place(fan[at], p);
    }
    if (!start) {
        return;
    }
    --at;
    for (int steps = 0; steps < 2 * n + 4; ++steps) {
        const Step step = checked_step(fan[at], p, q, *start, known_place(fan[at], q));
        if (testing::Test::HasFailure() || step.passage.kind != Kind::leaves || !step.exit || step.exit->past_end > 0) {
            return;
        }
        const int wall = step.passage.wall;
        if (wall == 0 || within(step.passage.t, fan[at].range) == Sign::negative) {
            return; // out of the fan
        }
        // Wall 1 is the one of corners 2 and 0, wall 2 that of corners 0 and 1.
        at = wall == 1 ? (at + 1) % n : (at + n - 1) % n;
        // A line that starts on a pillar and leaves at once is still there, at a corner of the wall that is shared.
        Walls walls = wall_bit(3 - wall);
        if (!is_one(step.exit->zero)) {
            const bool at_centre = (step.exit->zero & wall_bit(0)) == 0;
            walls = walls_at_corner(at_centre ? 0 : wall);
        }
        start = Known{{step.passage.t, walls}, step.exit->t};
        if (within(start->at.t, fan[at].range) == Sign::negative) {
            return;
        }
    }
}

/// A point of one of the prismoids; with few digits, so that it is exactly there, if the sample has few.
Vec3 point_in(Samples& random, const std::vector<Prismoid>& fan, bool coarse) {
    const Prismoid& prismoid = fan[static_cast<std::size_t>(random.integer(0, static_cast<int>(fan.size()) - 1))];
    const Vec3 alpha = coarse ? random.coarse_barycentric() : random.barycentric();
    const double part = random.number(0, 1);
    const double t =
        coarse ? std::ldexp(std::round(8 * prismoid.range.lo + 8 * part * (prismoid.range.hi - prismoid.range.lo)), -3)
               : prismoid.range.lo + part * (prismoid.range.hi - prismoid.range.lo);
    return displaced(prismoid.triangle, alpha, t);
}

TEST(PrismoidLine, GoesFromFaceToFaceAsRationalArithmeticSays) {
    Samples random(1);
    counts = {};
    const int rounds = soak(20000);
    int exact_on_random_fans = 0;
    std::vector<Prismoid> fan;
    Sample sample = Sample::random;
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(round);
        if (round % 16 == 0) {
            sample = round % 64 == 0    ? Sample::random_prism
                     : round % 64 == 32 ? Sample::nearly_parallel
                                        : Sample::random;
            fan = random.fan(sample, random.integer(4, 8));
        }
        const int before = counts.exact;
        check_line(fan, point_in(random, fan, false), point_in(random, fan, false));
        exact_on_random_fans += sample == Sample::random ? counts.exact - before : 0;
        if (testing::Test::HasFailure()) {
            return;
        }
    }
    EXPECT_GT(counts.ends, rounds / 10);
    EXPECT_GT(counts.leaves, rounds / 2);
    EXPECT_LT(exact_on_random_fans, rounds / 20) << "filters decide nearly all";
}

// Points and corners on grids: lines start and end on walls, run along them, and pass through pillars.
TEST(PrismoidLine, GoesFromFaceToFaceAsRationalArithmeticSaysOnGrids) {
    Samples random(2);
    counts = {};
    const int rounds = soak(8000);
    std::vector<Prismoid> fan;
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(round);
        if (round % 8 == 0) {
            fan = random.fan(static_cast<Sample>(1 + round / 8 % 4), random.integer(4, 8));
        }
        Vec3 p = point_in(random, fan, true);
        Vec3 q = point_in(random, fan, true);
        if (p == q) {
            continue;
        }
        check_line(fan, p, q);
        double& x = round % 2 == 0 ? p[round % 3] : q[round % 3];
        x = std::nextafter(x, round % 5 < 2 ? infinity : -infinity);
        check_line(fan, p, q);
        if (testing::Test::HasFailure()) {
            return;
        }
    }
    EXPECT_GT(counts.ends, rounds / 10);
    EXPECT_GT(counts.leaves, rounds / 10);
    EXPECT_GT(counts.at_once, rounds / 40);
    EXPECT_GT(counts.pillars, rounds / 100);
    EXPECT_GT(counts.exact, rounds / 10);
}

/// A point of wall k, exact in doubles for samples of few digits.
struct WallPoint {
    Vec3 q;
    Vec3 d;     ///< d(lambda)
    Vec3 along; ///< a_j - a_i
};
WallPoint wall_point(const BaseTriangle& triangle, int k, double lambda, double t) {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    const Vec3 along = triangle.corner(j, t) - triangle.corner(i, t);
    return {triangle.corner(i, t) + lambda * along, triangle.d[i] + lambda * (triangle.d[j] - triangle.d[i]), along};
}

// e lies in the tangent plane of the wall: the quadratic has a double root at the start, or vanishes.
TEST(PrismoidLine, StaysOrLeavesAtATangentAsTheWallCurves) {
    Samples random(3);
    counts = {};
    const int rounds = soak(20000);
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(round);
        const std::vector<Prismoid> fan = random.fan(static_cast<Sample>(1 + round % 4), random.integer(4, 8));
        const double lambda = random.fraction(4, 0, 1);
        const WallPoint start = wall_point(fan[0].triangle, 1, lambda, random.fraction(8, 0, 1) * fan[0].range.hi);
        const Vec3 e = random.fraction(4, -1, 1) * start.d + random.fraction(4, -1, 1) * start.along;
        if (e.isZero()) {
            continue;
        }
        // Starting there, touching there on the way, and touching at the end.
        check_line(fan, start.q, start.q + e);
        check_line(fan, start.q - 0.5 * e, start.q + 0.5 * e);
        check_line(fan, start.q - 0.25 * e, start.q);
        if (testing::Test::HasFailure()) {
            return;
        }
    }
    EXPECT_GT(counts.at_once, 0);
    EXPECT_GT(counts.leaves, rounds / 20);
}

// A chord of the curved wall: both of its ends on the wall, or a little before and beyond them.
TEST(PrismoidLine, CrossesACurvedWallTwice) {
    Samples random(4);
    counts = {};
    const int rounds = soak(12000);
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(round);
        const std::vector<Prismoid> fan = random.fan(Sample::dyadic, random.integer(4, 8));
        const BaseTriangle& triangle = fan[0].triangle;
        const Range range = fan[0].range;
        const auto on_wall = [&] {
            return wall_point(triangle, 1, random.fraction(8, 0, 1),
                              range.lo + random.fraction(8, 0, 1) * (range.hi - range.lo))
                .q;
        };
        const Vec3 a = on_wall();
        const Vec3 b = on_wall();
        const Vec3 e = b - a;
        if (e.isZero()) {
            continue;
        }
        check_line(fan, a, b);
        check_line(fan, a - 0.25 * e, b + 0.25 * e);
        check_line(fan, a - 0.25 * e, b);
        check_line(fan, a, b + 0.25 * e);
        if (testing::Test::HasFailure()) {
            return;
        }
    }
    EXPECT_GT(counts.leaves, rounds / 2);
}

TEST(PrismoidLine, StartsAtAKeptCornerIntoTheFaceThatHoldsItsDirectionOrTheNextOne) {
    Samples random(5);
    counts = {};
    const int rounds = soak(30000);
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(round);
        const Sample sample = round % 2 == 0 ? Sample::random : static_cast<Sample>(1 + round / 2 % 6);
        const Prismoid prismoid = random.prismoid(sample);
        const BaseTriangle& triangle = prismoid.triangle;
        const int k = round % 3;
        const Vec3& p = triangle.v[k];
        Vec3 e = 0.25 * random.dyadic(3);
        if (round % 4 == 1) { // along the wall where it starts, with a double root at t = 0, or in the slice
            const WallPoint at = wall_point(triangle, (k + 1) % 3, 1, 0);
            e = -random.fraction(4, 0, 1) * at.along + random.fraction(4, -1, 1) * at.d;
        } else if (round % 4 == 2) { // along the base edge
            e = triangle.v[(k + 1) % 3] - p;
        } else if (round % 4 == 3) {
            e = 0.5 * (triangle.v[(k + 1) % 3] + triangle.v[(k + 2) % 3]) - p + 0.25 * random.vector();
        }
        const Vec3 q = p + e;
        if (q == p || triangle.d[k].cross(q - p).isZero()) {
            continue; // up the pillar
        }
        checked_step(prismoid, p, q, at_kept_corner(k), known_place(prismoid, q));
        if (testing::Test::HasFailure()) {
            return;
        }
        // And from elsewhere to the kept corner.
        const Vec3 from =
            displaced(triangle, random.coarse_barycentric(), random.fraction(8, 0, 1) * prismoid.range.hi);
        const std::optional<Known> start = known_place(prismoid, from);
        if (start && from != p) {
            checked_step(prismoid, from, p, *start, at_kept_corner(k));
        }
        if (testing::Test::HasFailure()) {
            return;
        }
    }
    EXPECT_GT(counts.ends, rounds / 4);
    EXPECT_GT(counts.at_once, rounds / 20);
}

/// Half of a square, with right walls.
const Prismoid prism{{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1)}},
                     {-1, 1}};

Passage passage(const Prismoid& prismoid, const Vec3& p, const Vec3& q, bool ends = false) {
    const std::optional<Known> start = known_place(prismoid, p);
    return checked_step(prismoid, p, q, start.value(), ends ? known_place(prismoid, q) : std::nullopt).passage;
}

TEST(PrismoidLine, EndsWhereItsEndIs) {
    const Passage inside = passage(prism, {0.25, 0.25, 0}, {0.5, 0.25, 0.5}, true);
    EXPECT_EQ(inside.kind, Kind::ends);
    EXPECT_EQ(compare(inside.t, Displacement(0.5)), Sign::zero);
    EXPECT_EQ(passage(prism, {0.25, 0.25, 0}, {0.5, 0.25, 0}, true).kind, Kind::ends);  // in a slice
    EXPECT_EQ(passage(prism, {0.25, 0.25, 0}, {0.5, 0.5, 0.5}, true).kind, Kind::ends); // on a wall
    EXPECT_EQ(passage(prism, {0.25, 0, 0}, {0.5, 0, 0.5}, true).kind, Kind::ends);      // along a wall
    EXPECT_EQ(passage(prism, {0.25, 0, 0}, {0.5, 0, 0}, true).kind, Kind::ends);        // both
}

TEST(PrismoidLine, LeavesAtOnceThroughTheWallItStartsOnIfTheCoordinateFalls) {
    for (const double rise : {-0.25, 0.0, 0.25}) {
        const Passage out = passage(prism, {0.25, 0, 0}, {0.25, -0.5, rise});
        EXPECT_EQ(out.kind, Kind::leaves);
        EXPECT_EQ(out.wall, 2);
        EXPECT_EQ(compare(out.t, Displacement(0)), Sign::zero);
        const Passage in = passage(prism, {0.25, 0, 0}, {0.25, 2, rise});
        EXPECT_EQ(in.kind, Kind::leaves);
        EXPECT_EQ(in.wall, 0);
    }
}

TEST(PrismoidLine, MeetsAPillarWhereTwoWallsDo) {
    for (const double rise : {-0.25, 0.0, 0.25}) {
        EXPECT_EQ(passage(prism, {0.25, 0.25, 0}, {-0.25, -0.25, rise}).kind, Kind::pillar);
        EXPECT_EQ(passage(prism, {0.25, 0.25, 0}, {-0.25, -0.25 + 0x1p-52, rise}).kind, Kind::leaves);
    }
}

// Along the wall y = 0 to the corner at the origin and beyond it.
TEST(PrismoidLine, MeetsAPillarAtTheEndOfTheWallAlongWhichItRuns) {
    for (const double rise : {-0.25, 0.0, 0.25}) {
        EXPECT_EQ(passage(prism, {0.5, 0, 0}, {-0.5, 0, rise}).kind, Kind::pillar);
    }
}

TEST(PrismoidLine, IsLostIfItsEndIsNotWhereItShouldBe) {
    EXPECT_EQ(passage(prism, {0.25, 0.25, 0}, {0.25, 0.25, 0.5}).kind, Kind::lost);
    const PrismoidPoint start{Displacement(0.0), 0};
    const PrismoidPoint behind{Displacement(-0.5), 0};
    const Vec3 p(0.25, 0.25, 0);
    const Vec3 q(0.25, 0.25, 0.5);
    EXPECT_EQ(follow_line(prism.triangle, {&p, &q}, start, &behind).kind, Kind::lost);
}

/// A fan whose lengths, and in these units displacements, are multiplied by powers of two.
struct Scale {
    int length;
    int displacement;

    [[nodiscard]] Vec3 operator()(const Vec3& q) const { return q * std::ldexp(1.0, length); }
    [[nodiscard]] Prismoid operator()(Prismoid prismoid) const {
        for (int i = 0; i < 3; ++i) {
            prismoid.triangle.v[i] *= std::ldexp(1.0, length);
            prismoid.triangle.d[i] *= std::ldexp(1.0, length - displacement);
        }
        prismoid.range = {std::ldexp(prismoid.range.lo, displacement), std::ldexp(prismoid.range.hi, displacement)};
        return prismoid;
    }
};

/// What follow_line() says of the line is the same after scaling.
void expect_same_scaled(const Prismoid& prismoid, const Vec3& p, const Vec3& q, const Scale& scale) {
    const std::optional<Known> start = known_place(prismoid, p);
    if (!start || p == q) {
        return;
    }
    const std::optional<Known> end = known_place(prismoid, q);
    const Step step = checked_step(prismoid, p, q, *start, end);
    const Passage& expected = step.passage;
    if (expected.kind == Kind::lost || (step.exit && step.exit->past_end > 0)) {
        return;
    }
    const Prismoid scaled = scale(prismoid);
    const Vec3 from = scale(p);
    const Vec3 to = scale(q);
    const PointFinder finder(scaled.triangle, scaled.range);
    const std::optional<PrismoidPoint> scaled_start = finder.find(from);
    const std::optional<PrismoidPoint> scaled_end = finder.find(to);
    ASSERT_TRUE(scaled_start);
    ASSERT_EQ(scaled_end.has_value(), end.has_value());
    const Passage found =
        follow_line(scaled.triangle, {&from, &to}, *scaled_start, scaled_end ? &*scaled_end : nullptr);
    ASSERT_EQ(found.kind, expected.kind);
    ASSERT_EQ(found.wall, expected.wall);
}

TEST(PrismoidLine, AnswersTheSameAtEveryMagnitude) {
    Samples random(6);
    const int rounds = soak(20000);
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(round);
        const std::vector<Prismoid> fan = random.fan(static_cast<Sample>(round % samples), 6);
        expect_same_scaled(fan[0], point_in(random, {fan[0]}, true), point_in(random, fan, true),
                           {random.integer(-500, 500), random.integer(-400, 400)});
        if (testing::Test::HasFailure()) {
            return;
        }
    }
}

// Some products of three lengths leave the range of doubles, and others, of the opposite sign, do not.
TEST(PrismoidLine, AnswersTheSameWhereProductsOverflowOrUnderflow) {
    Samples random(7);
    const int rounds = soak(10000);
    std::vector<Prismoid> fan;
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(round);
        if (round % 16 == 0) {
            fan = random.fan(Sample::random, 6);
        }
        expect_same_scaled(fan[0], point_in(random, {fan[0]}, false), point_in(random, fan, false),
                           {random.integer(338, 345) * (round % 4 == 0 ? -1 : 1), random.integer(-2, 2)});
        if (testing::Test::HasFailure()) {
            return;
        }
    }
}

} // namespace
} // namespace foldless
