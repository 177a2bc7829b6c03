#include "../soak.h"
#include "prismoid_samples.h"

#include <foldless/predicates/image_arc.h>
#include <foldless/predicates/line_pieces.h>
#include <foldless/predicates/prismoid_line.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace foldless {
namespace {

using Plane = std::array<double, 2>;

Vec3 inner_barycentric(Samples& random) {
    return 0.1 * Vec3::Ones() + 0.7 * random.barycentric();
}

/// A line in a prismoid that stays inside, and its arc.
struct Inside {
    Vec3 p, q;
    std::optional<ImageArc> arc;

    Inside(const Prismoid& prismoid, const Vec3& from, const Vec3& to) : p(from), q(to) {
        const PointFinder finder(prismoid.triangle, prismoid.range);
        const std::optional<PrismoidPoint> a = finder.find(p);
        const std::optional<PrismoidPoint> b = finder.find(q);
        if (a && b && follow_line(prismoid.triangle, {&p, &q}, *a, &*b).kind == Passage::Kind::ends) {
            arc.emplace(prismoid.triangle, ScanLine{&p, &q}, ImageArc::End{*a, true}, ImageArc::End{*b, true});
        }
    }

    /// Points of the arc, alpha_1 and alpha_2.
    [[nodiscard]] std::vector<Plane> points(const Prismoid& prismoid, int count) const {
        const PointFinder finder(prismoid.triangle, prismoid.range);
        std::vector<Plane> result;
        for (int i = 0; i <= count; ++i) {
            const Vec3 x = p + (q - p) * (static_cast<double>(i) / count);
            if (const std::optional<PrismoidPoint> at = finder.find(x)) {
                const Vec3 alpha = rounded_place(prismoid.triangle, x, at->t).alpha;
                result.push_back({alpha[1], alpha[2]});
            }
        }
        return result;
    }
};

double cross(const Plane& o, const Plane& a, const Plane& b) {
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

/// Whether two chains of chords cross each other.
bool cross_each_other(const std::vector<Plane>& a, const std::vector<Plane>& b) {
    for (std::size_t i = 1; i < a.size(); ++i) {
        for (std::size_t j = 1; j < b.size(); ++j) {
            if (cross(a[i - 1], a[i], b[j - 1]) * cross(a[i - 1], a[i], b[j]) < 0 &&
                cross(b[j - 1], b[j], a[i - 1]) * cross(b[j - 1], b[j], a[i]) < 0) {
                return true;
            }
        }
    }
    return false;
}

double distance(const std::vector<Plane>& a, const std::vector<Plane>& b) {
    double least = 1;
    for (const Plane& x : a) {
        for (const Plane& y : b) {
            least = std::min(least, std::hypot(x[0] - y[0], x[1] - y[1]));
        }
    }
    return least;
}

Sample any_sample(int round) {
    return static_cast<Sample>(round % samples);
}

TEST(ImageArc, IsApartFromAnotherExactlyIfTheyDoNotCross) {
    Samples random(11);
    constexpr int coarse = 64;
    constexpr int fine = 4096; // where coarse chords cross that are curves beside each other
    int apart = 0;
    int crossing = 0;
    int undecided = 0;
    for (int round = 0; round < soak(100000); ++round) {
        const Prismoid prismoid = random.prismoid(any_sample(round));
        const auto point = [&] {
            const double part = random.number(0, 1);
            return displaced(prismoid.triangle, inner_barycentric(random),
                             prismoid.range.lo + part * (prismoid.range.hi - prismoid.range.lo));
        };
        const Vec3 a = point();
        const Vec3 b = point();
        const Vec3 c = point();
        const Vec3 d = point();
        const Inside x(prismoid, a, b);
        const Inside y(prismoid, c, d);
        if (!x.arc || !y.arc) {
            continue;
        }
        const std::vector<Plane> here = x.points(prismoid, coarse);
        const std::vector<Plane> there = y.points(prismoid, coarse);
        const bool do_cross = cross_each_other(here, there);
        crossing += do_cross ? 1 : 0;
        if (are_apart(*x.arc, *y.arc, {})) {
            EXPECT_FALSE(do_cross && cross_each_other(x.points(prismoid, fine), y.points(prismoid, fine))) << round;
            ++apart;
        } else {
            undecided += do_cross || distance(here, there) < 0.02 ? 0 : 1;
        }
    }
    EXPECT_GT(apart, soak(100000) / 10);
    EXPECT_GT(crossing, soak(100000) / 100);
    EXPECT_LE(undecided, soak(100000) / 10000) << "where J is nearly zero, pieces have no end";
}

// Two lines over each other: their images cross, however far apart they are in space.
TEST(ImageArc, IsNotApartFromOneThatPassesOverIt) {
    Samples random(12);
    int count = 0;
    for (int round = 0; round < soak(40000); ++round) {
        const Prismoid prismoid = random.prismoid(any_sample(round));
        const Vec3 alpha = inner_barycentric(random);
        const auto through = [&](double part) {
            const Vec3 m =
                displaced(prismoid.triangle, alpha, prismoid.range.lo + part * (prismoid.range.hi - prismoid.range.lo));
            const Vec3 e = 0.1 * random.vector();
            return Inside(prismoid, m - e, m + e);
        };
        const Inside x = through(0.25);
        const Inside y = through(0.75);
        if (x.arc && y.arc) {
            EXPECT_FALSE(are_apart(*x.arc, *y.arc, {})) << round;
            ++count;
        }
    }
    EXPECT_GT(count, soak(40000) / 10);
}

TEST(ImageArc, MayShareAnEndWithAnother) {
    Samples random(13);
    int apart = 0;
    int count = 0;
    for (int round = 0; round < soak(40000); ++round) {
        const Prismoid prismoid = random.prismoid(any_sample(round));
        const double part = random.number(0.25, 0.75);
        const Vec3 p = displaced(prismoid.triangle, inner_barycentric(random),
                                 prismoid.range.lo + part * (prismoid.range.hi - prismoid.range.lo));
        const Inside x(prismoid, p, p + 0.1 * random.vector());
        const Inside y(prismoid, p + 0.1 * random.vector(), p);
        if (x.arc && y.arc) {
            EXPECT_FALSE(are_apart(*x.arc, *y.arc, {})) << round;
            apart += are_apart(*x.arc, *y.arc, {SharedEnd::from, SharedEnd::to}) ? 1 : 0;
            ++count;
        }
    }
    EXPECT_GT(count, soak(40000) / 10);
    EXPECT_GT(apart, count * 19 / 20) << "few pairs leave in nearly one direction";
}

/// Halves of the unit square with right walls, which meet on the wall from (1, 0) to (0, 1).
class OnTwoHalves : public testing::Test {
protected:
    static Prismoid half(const Vec3& a, const Vec3& b, const Vec3& c) {
        const Vec3 up(0, 0, 1);
        return {{{a, b, c}, {up, up, up}}, {-1, 1}};
    }
    Prismoid lower_ = half({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    Prismoid upper_ = half({1, 1, 0}, {0, 1, 0}, {1, 0, 0});
    CommonWall wall_{0, 0};
};

TEST_F(OnTwoHalves, ArcsMeetOnTheWall) {
    const Inside a(lower_, {0.25, 0.25, 0}, {0.5, 0.5, 0});
    const Inside over_it(upper_, {0.75, 0.75, 0.5}, {0.5, 0.5, 0.5});
    const Inside beside_it(upper_, {0.75, 0.75, 0.5}, {0.5 - 0x1p-30, 0.5 + 0x1p-30, 0.5});
    const Inside short_of_it(upper_, {0.75, 0.75, 0.5}, {0.5 + 0x1p-30, 0.5 + 0x1p-30, 0.5});
    EXPECT_FALSE(are_apart_on_wall(*a.arc, *over_it.arc, wall_, {}));
    EXPECT_TRUE(are_apart_on_wall(*a.arc, *beside_it.arc, wall_, {}));
    EXPECT_TRUE(are_apart_on_wall(*a.arc, *short_of_it.arc, wall_, {}));
    EXPECT_TRUE(are_apart_on_wall(*a.arc, *over_it.arc, wall_, {SharedEnd::to, SharedEnd::to}));
}

TEST_F(OnTwoHalves, ArcsMayLieAlongTheWallOnBothSides) {
    const Inside a(lower_, {0.75, 0.25, 0}, {0.25, 0.75, 0});
    const Inside over_it(upper_, {0.625, 0.375, 0.5}, {0.375, 0.625, 0.5});
    const Inside before_it(upper_, {1, 0, 0.5}, {0.875, 0.125, 0.5});
    EXPECT_FALSE(are_apart_on_wall(*a.arc, *over_it.arc, wall_, {}));
    EXPECT_TRUE(are_apart_on_wall(*a.arc, *before_it.arc, wall_, {}));
}

TEST_F(OnTwoHalves, ALineIsCutIntoPiecesThatAreMoreThanPoints) {
    const Vec3 p(0.25, 0.25, 0);
    const Vec3 on_wall(0.5, 0.5, 0);
    const Vec3 q(0.75, 0.75, 0);
    const PrismoidPoint start{Displacement(), 0};
    const PrismoidPoint at_wall{Displacement(), wall_bit(0)};

    LinePieces across(7, start);
    across.cross(0, Displacement(), 9, 0);
    const std::vector<LinePiece> two = across.end(start);
    ASSERT_EQ(two.size(), 2);
    EXPECT_EQ(two[0].triangle, 7);
    EXPECT_TRUE(two[0].from.is_of_line);
    EXPECT_FALSE(two[0].to.is_of_line);
    EXPECT_EQ(two[1].triangle, 9);
    EXPECT_FALSE(two[1].from.is_of_line);

    LinePieces from_wall(7, at_wall);
    from_wall.cross(0, Displacement(), 9, 0);
    const std::vector<LinePiece> last = from_wall.end(start);
    ASSERT_EQ(last.size(), 1);
    EXPECT_EQ(last[0].triangle, 9);
    EXPECT_TRUE(last[0].from.is_of_line);

    LinePieces to_wall(7, start);
    to_wall.cross(0, Displacement(), 9, 0);
    const std::vector<LinePiece> first = to_wall.end(at_wall);
    ASSERT_EQ(first.size(), 1);
    EXPECT_EQ(first[0].triangle, 7);
    EXPECT_TRUE(first[0].to.is_of_line);

    // The parameters of the pieces of a line that crosses the wall half-way.
    const ScanLine line{&p, &q};
    const ImageArc here(lower_.triangle, line, two[0].from, two[0].to);
    const ImageArc there(upper_.triangle, line, two[1].from, two[1].to);
    EXPECT_NEAR(here.parameters().hi, 0.5, 1e-14);
    EXPECT_NEAR(there.parameters().lo, 0.5, 1e-14);
    EXPECT_LE(here.bounds(0).lo, 0);
}

TEST_F(OnTwoHalves, ARayMissesWhatIsBesideItOrOutOfRange) {
    const Inside a(lower_, {0.25, 0.25, 0}, {0.375, 0.25, 0});
    const auto flat = [](double x, double y, double z) {
        return ScanTriangle{Vec3(x, y, z), Vec3(x + 0.1, y, z), Vec3(x, y + 0.1, z)};
    };
    const Range range{-0.5, 0.5};
    EXPECT_FALSE(certainly_misses(*a.arc, 0.5, flat(0.29, 0.22, 0.25), range)); // at (0.3125, 0.25)
    EXPECT_FALSE(certainly_misses(*a.arc, 0.5, flat(0.29, 0.22, -0.25), range));
    EXPECT_TRUE(certainly_misses(*a.arc, 0.5, flat(0.29, 0.22, 0.75), range));
    EXPECT_TRUE(certainly_misses(*a.arc, 0.5, flat(0.32, 0.22, 0.25), range));
    EXPECT_FALSE(certainly_misses(*a.arc, 0.5, flat(0.3125, 0.22, 0.25), range)); // through its side
}

TEST(SharedPoint, IsThatOfOneVertex) {
    const SharedPoint none = shared_point({1, 2}, {3, 4});
    EXPECT_EQ(none.a, SharedEnd::none);
    const SharedPoint walls = shared_point({-1, 2}, {-1, 4});
    EXPECT_EQ(walls.a, SharedEnd::none);
    const SharedPoint one = shared_point({1, 2}, {2, 4});
    EXPECT_EQ(one.a, SharedEnd::to);
    EXPECT_EQ(one.b, SharedEnd::from);
}

} // namespace
} // namespace foldless
