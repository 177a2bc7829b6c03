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

/// The point of the wall at lambda and t.
Vec3 wall_point(const BaseTriangle& triangle, int opposite, double lambda, double t) {
    const auto [i, j] = ends(opposite);
    return (1 - lambda) * triangle.corner(i, t) + lambda * triangle.corner(j, t);
}

/// e.((a_j - a_i)(t) x d(lambda)), exactly.
mpq_class outwards(const BaseTriangle& triangle, int opposite, const Vec3& e, double lambda, double t) {
    const auto [i, j] = ends(opposite);
    const Vector along = exact::corner(triangle, j, t) - exact::corner(triangle, i, t);
    const mpq_class l(lambda);
    const Vector d = (1 - l) * Vector(triangle.d[i]) + l * Vector(triangle.d[j]);
    return exact::dot(Vector(e), exact::cross(along, d));
}

/// e.((a_i - a)(t) x (a_j - a)(t)), exactly: zero where the line through a along e meets the line of the slice.
mpq_class side(const BaseTriangle& triangle, int opposite, const std::array<Vec3, 2>& line, const mpq_class& t) {
    const auto [i, j] = ends(opposite);
    const Vector x = exact::corner(triangle, i, t) - Vector(line[0]);
    const Vector y = exact::corner(triangle, j, t) - Vector(line[0]);
    return exact::dot(Vector(line[1]), exact::cross(x, y));
}

/// How often side(t) changes its sign over a fine grid of the range: a lower bound on its roots.
int sign_changes(const BaseTriangle& triangle, int opposite, const std::array<Vec3, 2>& line, Range range) {
    constexpr int steps = 40;
    int changes = 0;
    int last = 0;
    for (int n = 0; n <= steps; ++n) {
        const mpq_class t = mpq_class(range.lo) + mpq_class(n, steps) * (mpq_class(range.hi) - mpq_class(range.lo));
        const int sign = sgn(side(triangle, opposite, line, t));
        changes += sign != 0 && last != 0 && sign != last ? 1 : 0;
        last = sign != 0 ? sign : last;
    }
    return changes;
}

const BaseTriangle prism{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1)}};

TEST(WallPasses, IsPositiveOutwards) {
    const Wall front(prism, 2); // over the edge from (0, 0) to (1, 0)
    EXPECT_EQ(front.passes({0, -1, 0}, {-1, 1}), Sign::positive);
    EXPECT_EQ(front.passes({0, 1, 0}, {-1, 1}), Sign::negative);
    EXPECT_EQ(front.passes({1, 0, 0}, {-1, 1}), Sign::undecided);
    EXPECT_EQ(front.passes_at_corner({0, -1, 0}, 0), Sign::positive);
    EXPECT_EQ(front.passes_at_corner({0, 1, 0}, 1), Sign::negative);
}

// The value is linear in lambda and in t, so its extremes are at the four corners of the wall.
TEST(WallPasses, IsTheSignOverTheWholeWall) {
    RandomTriangles random(1);
    int decided = 0;
    constexpr int rounds = 5000;
    for (int round = 0; round < rounds; ++round) {
        const BaseTriangle triangle = round % 2 == 0 ? random.wild() : random.tame();
        const int k = round % 3;
        const Vec3 e = random.vector(1e-3);
        const Range range{random.number(-1, 0), random.number(0, 1)};
        const Sign sign = Wall(triangle, k).passes(e, range);
        bool all_positive = true;
        bool all_negative = true;
        for (const double lambda : {0.0, 1.0}) {
            for (const double t : {range.lo, range.hi}) {
                const int corner = sgn(outwards(triangle, k, e, lambda, t));
                all_positive = all_positive && corner > 0;
                all_negative = all_negative && corner < 0;
            }
        }
        EXPECT_TRUE(sign != Sign::positive || all_positive) << "round " << round;
        EXPECT_TRUE(sign != Sign::negative || all_negative) << "round " << round;
        decided += sign != Sign::undecided ? 1 : 0;
    }
    EXPECT_GT(decided, rounds / 4);
}

TEST(WallPasses, AgreesAtTheCornersWithRationalArithmetic) {
    RandomTriangles random(2);
    for (int round = 0; round < 5000; ++round) {
        const BaseTriangle triangle = random.wild();
        const int k = round % 3;
        for (const int lambda : {0, 1}) {
            // Every other direction lies in the wall but for its rounding.
            const auto [i, j] = ends(k);
            const Vec3 in_wall = random.number(-1, 1) * (triangle.v[j] - triangle.v[i]) +
                                 random.number(-1, 1) * triangle.d[lambda == 0 ? i : j];
            const Vec3 e = round % 2 == 0 ? random.vector() : in_wall;
            const Sign sign = Wall(triangle, k).passes_at_corner(e, lambda);
            if (sign != Sign::undecided) {
                EXPECT_EQ(sign == Sign::positive, sgn(outwards(triangle, k, e, lambda, 0)) > 0) << "round " << round;
            }
        }
    }
}

TEST(WallMisses, IsFalseForEveryLineThroughTheWall) {
    RandomTriangles random(3);
    for (int round = 0; round < 5000; ++round) {
        const BaseTriangle triangle = round % 2 == 0 ? random.wild() : random.tame();
        const int k = round % 3;
        const Vec3 through = wall_point(triangle, k, random.number(0, 1), random.number(-0.9, 0.9));
        const Vec3 e = random.vector();
        EXPECT_FALSE(Wall(triangle, k).misses(through - random.number(0, 1) * e, e, {-1, 1})) << "round " << round;
    }
}

TEST(WallMisses, IsTrueOnlyWhereTheSideKeepsItsSign) {
    RandomTriangles random(4);
    int missed = 0;
    constexpr int rounds = 1000;
    for (int round = 0; round < rounds; ++round) {
        const BaseTriangle triangle = random.tame();
        const int k = round % 3;
        const std::array<Vec3, 2> line{random.vector(), random.vector()};
        const Range range{random.number(-1, 0), random.number(0, 1)};
        if (Wall(triangle, k).misses(line[0], line[1], range)) {
            ++missed;
            EXPECT_EQ(sign_changes(triangle, k, line, range), 0) << "round " << round;
        }
    }
    EXPECT_GT(missed, rounds / 10);
}

TEST(WallMeetsOnceAtMost, IsFalseForALineThroughTwoPoints) {
    RandomTriangles random(5);
    for (int round = 0; round < 3000; ++round) {
        const BaseTriangle triangle = round % 2 == 0 ? random.wild() : random.tame();
        const int k = round % 3;
        const Vec3 first = wall_point(triangle, k, random.number(0, 1), random.number(-0.9, -0.1));
        const Vec3 second = wall_point(triangle, k, random.number(0, 1), random.number(0.1, 0.9));
        EXPECT_FALSE(Wall(triangle, k).meets_once_at_most(first, second - first, {-1, 1})) << "round " << round;
        EXPECT_EQ(Wall(triangle, k).passes(second - first, {-1, 1}), Sign::undecided) << "round " << round;
    }
}

TEST(WallMeetsOnceAtMost, IsTrueOnlyWhereTheSideHasOneRootAtMost) {
    RandomTriangles random(6);
    int once = 0;
    constexpr int rounds = 1000;
    for (int round = 0; round < rounds; ++round) {
        const BaseTriangle triangle = random.tame();
        const int k = round % 3;
        const std::array<Vec3, 2> line{random.vector(), random.vector()};
        const Range range{random.number(-1, 0), random.number(0, 1)};
        if (Wall(triangle, k).meets_once_at_most(line[0], line[1], range)) {
            ++once;
            EXPECT_LE(sign_changes(triangle, k, line, range), 1) << "round " << round;
        }
    }
    EXPECT_GT(once, rounds / 4);
}

/// Every crossing at a displacement that the tests construct.
const Wall::Wanted everywhere{{-2, 2}, false};

/// Whether one of the crossings is the constructed one, within its own error and what rounding moved it by.
bool lists(const Wall::Crossings& crossings, double s, double lambda, double t) {
    for (int n = 0; n < crossings.count; ++n) {
        const Wall::Crossing& at = crossings.values[n];
        const double slack = 1e-6;
        if (std::abs(at.s - s) <= at.error + slack && std::abs(at.lambda - lambda) <= at.error + slack &&
            std::abs(at.t - t) <= at.t_error + slack) {
            return true;
        }
    }
    return false;
}

TEST(WallCrossings, FindsTheCrossingThatWasConstructed) {
    RandomTriangles random(7);
    for (int round = 0; round < 5000; ++round) {
        const BaseTriangle triangle = random.tame();
        const int k = round % 3;
        const double s = random.number(0.01, 0.99);
        const double lambda = random.number(0.01, 0.99);
        const double t = random.number(-0.9, 0.9);
        const Vec3 e = random.vector();
        const Vec3 a = wall_point(triangle, k, lambda, t) - s * e;
        const Wall::Crossings found = Wall(triangle, k).crossings(a, e, everywhere);
        bool unproven = false;
        for (int n = 0; n < found.count; ++n) {
            unproven = unproven || std::isinf(found.values[n].error);
        }
        EXPECT_TRUE(unproven || lists(found, s, lambda, t)) << "round " << round;
    }
}

TEST(WallCrossings, FindsBothCrossingsOfALineThroughTwoPoints) {
    RandomTriangles random(8);
    int proven = 0;
    constexpr int rounds = 2000;
    for (int round = 0; round < rounds; ++round) {
        const BaseTriangle triangle = random.tame();
        const int k = round % 3;
        const std::array<double, 2> lambda{random.number(0.05, 0.45), random.number(0.55, 0.95)};
        const std::array<double, 2> t{random.number(-0.9, -0.3), random.number(0.3, 0.9)};
        const Vec3 first = wall_point(triangle, k, lambda[0], t[0]);
        const Vec3 second = wall_point(triangle, k, lambda[1], t[1]);
        const Vec3 e = 2 * (second - first); // the points lie at s = 1/4 and 3/4
        const Wall::Crossings found = Wall(triangle, k).crossings(first - 0.25 * e, e, everywhere);
        ASSERT_LE(found.count, 2);
        if (lists(found, 0.25, lambda[0], t[0]) && lists(found, 0.75, lambda[1], t[1])) {
            ++proven;
        }
    }
    EXPECT_GT(proven, rounds * 9 / 10);
}

// What is reported exists: the point of the edge and that of the wall are the same, up to the errors.
TEST(WallCrossings, ReportsOnlyPointsOfBoth) {
    RandomTriangles random(9);
    int reported = 0;
    for (int round = 0; round < 5000; ++round) {
        const BaseTriangle triangle = random.wild();
        const int k = round % 3;
        const Vec3 a = random.vector();
        const Vec3 e = random.vector();
        const Wall::Crossings found = Wall(triangle, k).crossings(a, e, everywhere);
        for (int n = 0; n < found.count; ++n) {
            const Wall::Crossing& at = found.values[n];
            if (std::isinf(at.error)) {
                continue;
            }
            ++reported;
            const Vec3 on_wall = wall_point(triangle, k, at.lambda, at.t);
            EXPECT_NEAR((a + at.s * e - on_wall).norm(), 0, 1e-12 + 10 * (at.error + at.t_error)) << "round " << round;
            EXPECT_TRUE(at.s >= -at.error && at.s <= 1 + at.error);
            EXPECT_TRUE(at.lambda >= -at.error && at.lambda <= 1 + at.error);
        }
    }
    EXPECT_GT(reported, 200);
}

TEST(WallCrossings, LeavesOutWhatIsNotWanted) {
    const Wall front(prism, 2); // over the edge from (0, 0) to (1, 0)
    const Vec3 inside(0.25, 0.25, 0.5);
    const Vec3 out(0, -0.5, 0);
    EXPECT_EQ(front.crossings(inside, out, {{0, 1}, false}).count, 1);
    EXPECT_EQ(front.crossings(inside, out, {{0, 1}, true}).count, 1);
    EXPECT_EQ(front.crossings(inside, out, {{0.75, 1}, false}).count, 0);
    EXPECT_EQ(front.crossings(inside, out, {{-1, 0.25}, false}).count, 0);
    EXPECT_EQ(front.crossings(inside + out, -out, {{0, 1}, false}).count, 1);
    EXPECT_EQ(front.crossings(inside + out, -out, {{0, 1}, true}).count, 0); // it comes in
}

TEST(WallMetOnlyAtCorner, IsFalseForAnEdgeThatComesBack) {
    RandomTriangles random(10);
    for (int round = 0; round < 3000; ++round) {
        const BaseTriangle triangle = round % 2 == 0 ? random.wild() : random.tame();
        const int k = round % 3;
        const auto [i, j] = ends(k);
        const Vec3 again = wall_point(triangle, k, random.number(0.1, 0.9), random.number(0.1, 0.9));
        EXPECT_FALSE(Wall(triangle, k).met_only_at_corner(again - triangle.v[i], 0, {0, 1})) << "round " << round;
        EXPECT_FALSE(Wall(triangle, k).met_only_at_corner(again - triangle.v[j], 1, {0, 1})) << "round " << round;
    }
}

TEST(WallMetOnlyAtCorner, IsTrueForAnEdgeThatLeavesAtOnce) {
    const Wall front(prism, 2);
    EXPECT_TRUE(front.met_only_at_corner({0.5, 0.5, 0.25}, 0, {0, 0.25}));
    EXPECT_TRUE(front.met_only_at_corner({-0.5, 0.5, 0.25}, 1, {0, 0.25}));
    EXPECT_FALSE(front.met_only_at_corner({0.5, 0, 0.25}, 0, {0, 0.25})); // runs along the wall
}

TEST(StaysOffWall, SeesAnEdgeThatRunsBesideTheWall) {
    const EdgePart beside = part_of_edge({0.125, 0.125, 0.25}, {0.5, 0, 0}, {0, 1}, 0);
    EXPECT_TRUE(stays_off_wall(prism, 2, beside, {0, 0.5}));
    const EdgePart through = part_of_edge({0.125, 0.125, 0.25}, {0.5, -0.25, 0}, {0, 1}, 0);
    EXPECT_FALSE(stays_off_wall(prism, 2, through, {0, 0.5}));
    const EdgePart before = part_of_edge({0.125, 0.125, 0.25}, {0.5, -0.25, 0}, {0, 0.375}, 0);
    EXPECT_TRUE(stays_off_wall(prism, 2, before, {0, 0.5}));
    const EdgePart vague = part_of_edge({0.125, 0.125, 0.25}, {0.5, -0.25, 0}, {0, 0.375}, 0.5);
    EXPECT_FALSE(stays_off_wall(prism, 2, vague, {0, 0.5}));
}

TEST(StaysOffWall, IsFalseForEveryPartThatMeetsTheWall) {
    RandomTriangles random(11);
    for (int round = 0; round < 5000; ++round) {
        const BaseTriangle triangle = round % 2 == 0 ? random.wild() : random.tame();
        const int k = round % 3;
        const Vec3 through = wall_point(triangle, k, random.number(0, 1), random.number(-0.9, 0.9));
        const Vec3 e = random.vector();
        const double s = random.number(0.1, 0.9);
        const EdgePart part = part_of_edge(through - s * e, e, {random.number(0, s), random.number(s, 1)}, 0);
        EXPECT_FALSE(stays_off_wall(triangle, k, part, {-1, 1})) << "round " << round;
    }
}

} // namespace
} // namespace foldless
