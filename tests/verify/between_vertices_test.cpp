// Faults that no test of vertices sees, and surfaces that lie over a base mesh twice.

#include "../soak.h"
#include "made_meshes.h"
#include "random_scans.h"
#include "surface_oracle.h"
#include "violations.h"

#include <foldless/io/defects.h>
#include <foldless/io/errors.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace foldless {
namespace {

using namespace test;
using oracle::Judgement;

/// A base mesh over the square of made_meshes.h with corners at these heights and the directions (x, y, 1), one range
/// for all faces; and a scan with the same border and these vertices inside. With a centre the base mesh has four faces
/// around it, else two.
struct SquareCase {
    std::array<double, 4> heights;
    std::vector<Vec3> inside;
    std::vector<std::array<double, 2>> directions; ///< of the corners, and of the centre if there is one
    std::vector<Vec3> centre;
    double reach; ///< ranges [-reach, reach]
};

Pair pair_of(const SquareCase& c) {
    Pair pair{square({-c.reach, c.reach}), {}};
    for (int k = 0; k < 4; ++k) {
        pair.base.positions[k].z() = c.heights[k];
    }
    pair.scan.positions = pair.base.positions;
    for (const Vec3& centre : c.centre) {
        pair.base.positions.push_back(centre);
        pair.base.scan_vertex.push_back(-1);
        pair.base.faces = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
        pair.base.ranges.assign(4, pair.base.ranges[0]);
    }
    pair.base.directions.clear();
    for (const auto& [x, y] : c.directions) {
        pair.base.directions.emplace_back(x, y, 1);
    }
    pair.scan.positions.insert(pair.scan.positions.end(), c.inside.begin(), c.inside.end());
    //     3 ------- 2
    //     | \   / / |      or all four sides to one vertex inside
    //     |  4---5  |
    //     | /   \ \ |
    //     0 ------- 1
    pair.scan.faces = c.inside.size() == 1
                          ? std::vector<Triangle>{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}
                          : std::vector<Triangle>{{0, 1, 4}, {1, 5, 4}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {3, 0, 4}};
    return pair;
}

/// A vertex has one place, sees its faces from the front, and they go round it once.
void expect_vertices_pass(const VerifyResult& result, const Scan& scan) {
    for (const Violation violation : {Violation::kept_vertex, Violation::jacobian, Violation::no_preimage,
                                      Violation::several_preimages, Violation::orientation}) {
        EXPECT_EQ(count(result, violation), 0U) << name(violation);
    }
    for (const LocatedViolation& found : result.located) {
        const bool at_vertex =
            std::find(scan.positions.begin(), scan.positions.end(), found.position) != scan.positions.end();
        EXPECT_FALSE(found.violation == Violation::normal_condition && at_vertex);
    }
}

/// verify() finds this violation and no other, and the oracle refuses, too.
void expect_only(const SquareCase& c, Violation violation) {
    const Pair pair = pair_of(c);
    const VerifyResult result = verify(pair.base, pair.scan);
    EXPECT_THAT(result, HasOnly(violation));
    EXPECT_EQ(result.level, Level::surface);
    expect_vertices_pass(result, pair.scan);
    EXPECT_EQ(oracle::judge(pair.base, pair.scan).kind, Judgement::Kind::refused);
}

TEST(BetweenVertices, AFoldAtAWallIsFound) {
    expect_only({{-0.0625, 0.0625, -0.0625, 0},
                 {{0.5625, 0.4375, -0.0625}, {0.75, 0.25, 0.125}},
                 {{0.75, -1.4375}, {-0.1875, -0.75}, {0.3125, 0.5625}, {0.375, -0.5625}},
                 {},
                 0.5625},
                Violation::normal_condition);
}

TEST(BetweenVertices, AFoldBesideAPillarIsFound) {
    expect_only({{-0.125, 0.1875, 0.125, 0.1875},
                 {{0.5625, 0.75, 0}, {0.75, 0.6875, 0.3125}},
                 {{-0.3125, 0.1875}, {0.1875, -0.0625}, {0.25, -0.25}, {-0.5, -0.125}, {-0.3125, 0.375}},
                 {{0.375, 0.5625, 0.0625}},
                 0.5625},
                Violation::normal_condition);
}

TEST(BetweenVertices, AnEdgeThatLeavesTheRangesIsFound) {
    expect_only({{0, 0.3125, -0.3125, 0.0625},
                 {{0.375, 0.5625, 0}},
                 {{0.75, -0.5}, {0.0625, 1.375}, {-1.1875, 0.75}, {1.125, -0.0625}},
                 {},
                 0.125},
                Violation::trace);
}

TEST(BetweenVertices, APillarThatMissesItsTriangleIsFound) {
    expect_only({{0, 0, 0, 0},
                 {{0.75, 0.5, 0.1875}},
                 {{-0.3125, -0.0625}, {0.625, 0.25}, {0.25, -0.625}, {-0.125, 0.0625}, {0.1875, -0.4375}},
                 {{0.375, 0.5625, 0.375}},
                 0.25},
                Violation::pillar);
}

/// A random case of this kind: steep directions, so that a good part folds.
SquareCase random_case(Random& random, double step) {
    const auto number = [&](double lo, double hi) {
        const double x = uniform(random, lo, hi);
        return step > 0 ? step * std::round(x / step) : x;
    };
    SquareCase c;
    const double height = uniform(random, 0.1, 1.2);
    const double tilt = uniform(random, 0.3, 2.5);
    const bool has_centre = index(random, 2) == 0;
    for (double& z : c.heights) {
        z = number(-height / 2, height / 2);
    }
    for (int n = index(random, 2); n >= 0; --n) {
        const double x = number(0, 1);
        const double y = number(0, 1);
        c.inside.emplace_back(x, y, number(-height, height));
    }
    for (int n = has_centre ? 5 : 4; n > 0; --n) {
        const double x = number(-tilt, tilt);
        c.directions.push_back({x, number(-tilt, tilt)});
    }
    if (has_centre) {
        const double x = number(0.2, 0.8);
        const double y = number(0.2, 0.8);
        c.centre.emplace_back(x, y, number(-height / 2, height / 2));
    }
    c.reach = number(0.1, 0.8);
    return c;
}

bool has_defect(const Pair& pair) {
    try {
        require_no_defects(pair.scan);
        require_no_defects(Scan{pair.base.positions, pair.base.faces, false});
        return false;
    } catch (const RefusedMesh&) {
        return true;
    }
}

// Most are refused at once for a Jacobian or a vertex without a place; the oracle is as quick there. With the coarse
// step many scan vertices and edges meet walls and pillars exactly, where verify() must decide and the oracle has no
// opinion.
TEST(BetweenVertices, RandomSquaresAreJudgedAsByTheOracle) {
    std::map<std::string, int> counts;
    for (int seed = 0; seed < soak(20000); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Pair pair = pair_of(random_case(random, seed % 4 == 0 ? 0.0625 : 0));
        if (has_defect(pair)) {
            continue;
        }
        VerifyOptions options;
        options.threads = 1;
        const VerifyResult result = verify(pair.base, pair.scan, options);
        const Judgement truth = oracle::judge(pair.base, pair.scan);
        const bool represents = truth.kind == Judgement::Kind::represents;
        if (truth.kind != Judgement::Kind::tie) {
            EXPECT_EQ(result.certified(), represents)
                << "seed " << seed << ": " << testing::PrintToString(result) << "; oracle: " << truth.reason;
        }
        ++counts[result.certified() ? "certified" : "refused"];
        for (const Violation violation : {Violation::normal_condition, Violation::trace, Violation::pillar}) {
            if (!result.certified() && count(result, violation) == result.violation_total()) {
                ++counts["only " + std::string(name(violation))];
            }
        }
    }
    for (const auto& [what, count] : counts) {
        RecordProperty(what, count);
    }
    EXPECT_GT(counts["certified"], 0);
    EXPECT_GT(counts["only normal_condition"] + counts["only trace"] + counts["only pillar"], 0);
}

// --- Covers ----------------------------------------------------------------------------------------------------------

TEST(Covers, ABipyramidWoundTwiceIsRefusedWithAndWithoutKeptPoles) {
    for (const bool keeps_poles : {true, false}) {
        BaseMesh base;
        base.positions = bipyramid_off_centre(3, 1).positions;
        base.directions = base.positions;
        base.faces = bipyramid_off_centre(3, 1).faces;
        base.scan_vertex.assign(5, -1);
        base.ranges.assign(base.faces.size(), {-0.7, 2});
        for (const int laps : {1, 2}) {
            Scan scan = bipyramid_off_centre(9, laps);
            for (int pole = 0; pole < 2; ++pole) {
                if (keeps_poles) {
                    base.scan_vertex[pole] = pole;
                } else {
                    scan.positions[pole] += Vec3(0.05, 0.03, 0);
                }
            }
            for (std::size_t v = 2; v < scan.positions.size(); ++v) { // beside walls and pillars
                scan.positions[v] = scan.positions[v] * 1.1 + Vec3(0.01, 0.02, 0.005);
            }
            const VerifyResult result = verify(base, scan);
            const Judgement truth = oracle::judge(base, scan);
            EXPECT_EQ(result.certified(), laps == 1) << testing::PrintToString(result);
            EXPECT_EQ(truth.kind, laps == 1 ? Judgement::Kind::represents : Judgement::Kind::refused) << truth.reason;
        }
    }
}

Scan beside(const Scan& a, const Scan& b) {
    Scan both = a;
    const auto shift = static_cast<std::int32_t>(a.positions.size());
    both.positions.insert(both.positions.end(), b.positions.begin(), b.positions.end());
    for (const auto& [i, j, k] : b.faces) {
        both.faces.push_back({i + shift, j + shift, k + shift});
    }
    return both;
}

TEST(Covers, TwoPartsOfAScanOneInTheOtherAreRefusedOverOnePartOfTheBase) {
    const Scan sphere = turned_sphere(1);
    const Scan nested = beside(sphere, test::scaled(sphere, 1.4));
    BaseMesh base = octahedron({-0.5, 2});
    EXPECT_THAT(verify(base, nested), Has(Violation::degree));
    EXPECT_EQ(oracle::judge(base, nested).kind, Judgement::Kind::refused);

    // With another part of the base mesh far away, which nothing covers, the topologies agree.
    const BaseMesh one = base;
    for (std::size_t v = 0; v < 6; ++v) {
        base.positions.push_back(one.positions[v] + Vec3(50, 0, 0));
    }
    base.directions.insert(base.directions.end(), one.directions.begin(), one.directions.end());
    base.scan_vertex.assign(12, -1);
    for (const auto& [i, j, k] : one.faces) {
        base.faces.push_back({i + 6, j + 6, k + 6});
    }
    base.ranges.assign(16, {-0.5, 2});
    EXPECT_THAT(verify(base, nested), HasOnly(Violation::degree));
    EXPECT_EQ(oracle::judge(base, nested).kind, Judgement::Kind::refused);

    Scan apart = sphere;
    for (Vec3& p : apart.positions) {
        p += Vec3(50, 0, 0);
    }
    EXPECT_THAT(verify(base, beside(sphere, apart)), IsCertified());
    const Judgement truth = oracle::judge(base, beside(sphere, apart));
    EXPECT_EQ(truth.kind, Judgement::Kind::represents) << truth.reason;
}

/// Rows of cells: position(i, j) for 0 <= i <= rows, 0 <= j <= columns.
template <class Position>
Scan sheet(int rows, int columns, Position position) {
    Scan scan;
    scan.float32 = false;
    for (int i = 0; i <= rows; ++i) {
        for (int j = 0; j <= columns; ++j) {
            scan.positions.push_back(position(i, j));
        }
    }
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < columns; ++j) {
            const std::int32_t a = i * (columns + 1) + j;
            const std::int32_t b = a + columns + 1;
            scan.faces.push_back({a, b, b + 1});
            scan.faces.push_back({a, b + 1, a + 1});
        }
    }
    return scan;
}

TEST(Covers, AStripWoundOneAndAHalfTimesOverASquareIsRefused) {
    const Scan plane = grid(8, -2, 2, 0);
    BaseMesh base;
    base.positions = plane.positions;
    base.directions.assign(plane.positions.size(), {0, 0, 1});
    base.scan_vertex.assign(plane.positions.size(), -1);
    base.faces = plane.faces;
    base.ranges.assign(plane.faces.size(), {-1, 2});
    for (const double turns : {0.9, 1.5}) {
        const Scan strip = sheet(4, 48, [&](int i, int j) {
            const double angle = 2 * std::numbers::pi * turns * j / 48 + 0.05;
            const double radius = 0.61 + 0.22 * i;
            return Vec3(radius * std::cos(angle), radius * std::sin(angle), 0.1 * angle);
        });
        const VerifyResult result = verify(base, strip);
        EXPECT_EQ(result.level, Level::surface);
        EXPECT_THAT(result, turns < 1 ? testing::Matcher<VerifyResult>(IsCertified())
                                      : testing::Matcher<VerifyResult>(Has(Violation::overlap)));
    }
}

TEST(Covers, AStripWoundOneAndAHalfTimesAroundATorusIsRefused) {
    constexpr int around = 16;
    constexpr int across = 12;
    const auto on_tube = [](double u, double v, double radius) {
        const double r = 1 + radius * std::cos(v);
        return Vec3(r * std::cos(u), r * std::sin(u), radius * std::sin(v));
    };
    BaseMesh base;
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            const double u = 2 * std::numbers::pi * i / around;
            const double v = 2 * std::numbers::pi * j / across;
            base.positions.push_back(on_tube(u, v, 0.4));
            base.directions.emplace_back(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
            const auto at = [](int a, int b) { return (a % around) * across + b % across; };
            base.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            base.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    base.scan_vertex.assign(base.positions.size(), -1);
    base.ranges.assign(base.faces.size(), {-0.2, 0.25});
    const Scan strip = sheet(4, 48, [&](int i, int j) {
        const double v = 3 * std::numbers::pi * j / 48 + 0.03;
        return on_tube(0.21 * i + 0.02, v, 0.3 + 0.02 * v);
    });
    const VerifyResult result = verify(base, strip);
    EXPECT_THAT(result, Has(Violation::topology)); // a closed base mesh
    EXPECT_THAT(result, Has(Violation::overlap));  // though the images of its borders are simple and do not meet
}

} // namespace
} // namespace foldless
