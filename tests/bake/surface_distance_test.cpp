#include <foldless/bake/surface_distance.h>

#include "distance_oracle.h"

#include <foldless/io/read_mesh.h>

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <random>
#include <stdexcept>

namespace foldless {
namespace {

/// What surface_distance.h states for meshes of this size.
constexpr double rounding_of(double size) {
    return 0x1p-44 * size;
}

constexpr double infinity = std::numeric_limits<double>::infinity();

DistanceOptions within(double bound) {
    DistanceOptions options;
    options.bound = bound;
    return options;
}

/// The surface of the unit cube.
Scan cube() {
    Scan scan;
    for (int i = 0; i < 8; ++i) {
        scan.positions.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
    }
    scan.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                  {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return scan;
}

/// Two triangles.
Scan quadrilateral(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return {{a, b, c, d}, {{0, 1, 2}, {0, 2, 3}}};
}

Scan sheet(double height) {
    return quadrilateral({0, 0, height}, {1, 0, height}, {1, 1, height}, {0, 1, height});
}

Scan joined(Scan first, const Scan& second) {
    const auto by = static_cast<std::int32_t>(first.positions.size());
    first.positions.insert(first.positions.end(), second.positions.begin(), second.positions.end());
    for (const auto& [a, b, c] : second.faces) {
        first.faces.push_back({a + by, b + by, c + by});
    }
    return first;
}

template <class Map>
Scan mapped(Scan scan, const Map& map) {
    for (Vec3& position : scan.positions) {
        position = map(position);
    }
    return scan;
}

Scan moved(const Scan& scan, const Vec3& by) {
    return mapped(scan, [&](const Vec3& x) { return Vec3(x + by); });
}

Scan scaled(const Scan& scan, double factor) {
    return mapped(scan, [&](const Vec3& x) { return Vec3(x * factor); });
}

/// Triangles here and there, of all sizes, some without area.
Scan random_soup(std::mt19937& random, int faces) {
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    std::uniform_int_distribution<int> grid(-2, 2);
    std::uniform_int_distribution<int> kind(0, 4);
    const auto vector = [&] { return Vec3(number(random), number(random), number(random)); };
    Scan scan;
    for (int i = 0; i < faces; ++i) {
        const bool on_grid = kind(random) == 0; // ties, and points in common
        const double size = std::abs(number(random));
        const Vec3 middle = vector();
        for (int corner = 0; corner < 3; ++corner) {
            scan.positions.push_back(on_grid ? Vec3(grid(random), grid(random), grid(random)) / 2
                                             : Vec3(middle + size * vector()));
        }
        const std::int32_t first = 3 * i;
        scan.faces.push_back({first, first + 1, first + (kind(random) == 0 ? 1 : 2)});
    }
    return scan;
}

ScanTriangle corners(const Scan& scan, const Triangle& face) {
    return {scan.positions[face[0]], scan.positions[face[1]], scan.positions[face[2]]};
}

/// Of a point to a surface, by a search of all faces.
double oracle_distance(const Vec3& query, const Scan& scan) {
    long double least = infinity;
    for (const Triangle& face : scan.faces) {
        least = std::min(least, test::squared_distance<long double>(query, corners(scan, face)));
    }
    return static_cast<double>(std::sqrt(std::max(0.0L, least)));
}

/// The largest distance at the points of a lattice on each face, at most `spacing` from any of its points.
double sampled_maximum(const Scan& from, const Scan& to, double& spacing) {
    constexpr int n = 24;
    double largest = 0.0;
    spacing = 0.0;
    for (const Triangle& face : from.faces) {
        const auto [a, b, c] = corners(from, face);
        spacing = std::max(spacing, std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()}) / n);
        for (int i = 0; i <= n; ++i) {
            for (int k = 0; i + k <= n; ++k) {
                largest = std::max(largest, oracle_distance(a + i * (b - a) / n + k * (c - a) / n, to));
            }
        }
    }
    return largest;
}

void expect_agreement(const OneSidedDistance& found, const Scan& from, const Scan& to, double bound) {
    constexpr double rounding = 1e-8; // of the oracle, which takes a root of a difference
    EXPECT_LE(found.maximum, found.maximum_bound);
    EXPECT_LE(found.maximum_bound - found.maximum, bound);
    EXPECT_LE(found.rms, found.maximum + rounding);
    double spacing = 0.0;
    const double lattice_maximum = sampled_maximum(from, to, spacing);
    EXPECT_LE(lattice_maximum, found.maximum_bound + rounding);
    EXPECT_LE(found.maximum, lattice_maximum + spacing + rounding);
    EXPECT_NEAR(oracle_distance(found.furthest, from), 0.0, rounding);
    EXPECT_NEAR(oracle_distance(found.furthest, to), found.maximum, rounding);
    EXPECT_NEAR(oracle_distance(found.nearest, to), 0.0, rounding);
    EXPECT_NEAR((found.furthest - found.nearest).norm(), found.maximum, rounding);
}

void expect_same_bits(const OneSidedDistance& first, const OneSidedDistance& second) {
    EXPECT_EQ(first.maximum, second.maximum);
    EXPECT_EQ(first.maximum_bound, second.maximum_bound);
    EXPECT_EQ(first.rms, second.rms);
    EXPECT_EQ(first.furthest, second.furthest);
    EXPECT_EQ(first.nearest, second.nearest);
}

void expect_same_bits(const SurfaceDistance& first, const SurfaceDistance& second) {
    expect_same_bits(first.there, second.there);
    expect_same_bits(first.back, second.back);
}

TEST(SurfaceDistance, OfASurfaceToItselfIsNothing) {
    const SurfaceDistance found = surface_distance(cube(), cube(), within(1e-6));
    EXPECT_LE(found.maximum(), rounding_of(1));
    EXPECT_LE(found.maximum_bound(), 1e-6);
    EXPECT_LE(found.rms(), rounding_of(1));
}

TEST(SurfaceDistance, OfACubeToItselfShiftedIsTheShift) {
    const SurfaceDistance found = surface_distance(cube(), moved(cube(), {0.25, 0, 0}), within(1e-6));
    EXPECT_EQ(found.there.maximum, 0.25);
    EXPECT_EQ(found.back.maximum, 0.25);
    EXPECT_LE(found.maximum_bound(), 0.25 + 1e-6);
    EXPECT_EQ(found.there.furthest.x(), 0.0);
    EXPECT_EQ(found.there.nearest.x(), 0.25);
    EXPECT_EQ(found.back.furthest.x(), 1.25);
}

TEST(SurfaceDistance, IsFoundInsideAFaceWhoseCornersAreAtNoDistance) {
    const Vec3 a(0, 0, 0);
    const Vec3 b(2, 0, 0);
    const Vec3 c(1, std::sqrt(3.0), 0);
    const Scan triangle{{a, b, c}, {{0, 1, 2}}};
    const Scan its_corners{{a, b, c}, {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}};
    const SurfaceDistance found = surface_distance(triangle, its_corners, within(1e-6));
    const double radius = 2 / std::sqrt(3.0);
    EXPECT_NEAR(found.there.maximum, radius, 1e-6);
    EXPECT_GE(found.there.maximum_bound, radius);
    EXPECT_LE(found.there.maximum_bound - found.there.maximum, 1e-6);
    EXPECT_LE((found.there.furthest - (a + b + c) / 3).norm(), 1e-5);
    EXPECT_LE(found.back.maximum, rounding_of(2));
}

TEST(SurfaceDistance, OfASheetIsThatToTheNearerOfTwo) {
    const SurfaceDistance found = surface_distance(sheet(0.25), joined(sheet(0), sheet(1)), within(1e-6));
    EXPECT_EQ(found.there.maximum, 0.25);
    EXPECT_EQ(found.back.maximum, 0.75);
    EXPECT_EQ(found.maximum(), 0.75);
    EXPECT_NEAR(found.there.rms, 0.25, 1e-12);
    EXPECT_NEAR(found.back.rms, std::sqrt((0.25 * 0.25 + 0.75 * 0.75) / 2), 1e-12);
}

TEST(SurfaceDistance, FromATentToItsFloorIsAnotherThanBack) {
    const Scan tent = joined(quadrilateral({-1, 0, 0}, {-1, 8, 0}, {0, 8, 1}, {0, 0, 1}),
                             quadrilateral({0, 0, 1}, {0, 8, 1}, {1, 8, 0}, {1, 0, 0}));
    const Scan ground = quadrilateral({-1, 0, 0}, {1, 0, 0}, {1, 8, 0}, {-1, 8, 0});
    const SurfaceDistance found = surface_distance(tent, ground, within(1e-5));
    EXPECT_EQ(found.there.maximum, 1.0);
    EXPECT_LE(found.there.maximum_bound, 1.0 + 1e-5);
    EXPECT_NEAR(found.back.maximum, std::sqrt(0.5), 1e-5);
    EXPECT_GE(found.back.maximum_bound, std::sqrt(0.5));
    EXPECT_LE(found.back.maximum_bound - found.back.maximum, 1e-5);
    EXPECT_NEAR(found.there.rms, std::sqrt(1.0 / 3), 1e-12) << "a mean of z^2, for which the rule is exact";
    EXPECT_NEAR(found.back.rms, std::sqrt(1.0 / 6), 1e-4) << "faces across the ridge";
}

TEST(SurfaceDistance, AgreesWithASearchOfAll) {
    std::mt19937 random(11);
    for (int i = 0; i < 30; ++i) {
        const Scan from = random_soup(random, 1 + i % 7);
        const Scan to = random_soup(random, 1 + i % 11);
        const double bound = i % 2 == 0 ? 1e-2 : 1e-4;
        const SurfaceDistance found = surface_distance(from, to, within(bound));
        expect_agreement(found.there, from, to, bound);
        expect_agreement(found.back, to, from, bound);
    }
}

TEST(SurfaceDistance, IsBracketedByEveryBound) {
    std::mt19937 random(12);
    const Scan from = random_soup(random, 20);
    const Scan to = random_soup(random, 30);
    double low = 0.0;
    double high = infinity;
    for (const double bound : {1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
        const OneSidedDistance found = surface_distance(from, to, within(bound)).there;
        EXPECT_LE(found.maximum_bound - found.maximum, bound);
        low = std::max(low, found.maximum);
        high = std::min(high, found.maximum_bound);
        EXPECT_LE(low, high);
    }
}

TEST(SurfaceDistance, IsTheSameOnAnyNumberOfThreads) {
    std::mt19937 random(13);
    const Scan from = random_soup(random, 3000);
    const Scan to = random_soup(random, 500);
    DistanceOptions options = within(1e-4);
    options.threads = 1;
    const SurfaceDistance on_one = surface_distance(from, to, options);
    for (const int threads : {2, 3, 8}) {
        options.threads = threads;
        expect_same_bits(surface_distance(from, to, options), on_one);
    }
}

TEST(SurfaceDistance, ChangesSidesWithTheMeshes) {
    std::mt19937 random(14);
    const Scan from = random_soup(random, 50);
    const Scan to = random_soup(random, 70);
    const SurfaceDistance one_way = surface_distance(from, to, within(1e-4));
    const SurfaceDistance other_way = surface_distance(to, from, within(1e-4));
    expect_same_bits(one_way.there, other_way.back);
    expect_same_bits(one_way.back, other_way.there);
}

TEST(SurfaceDistance, GrowsWithAPowerOfTwoExactly) {
    std::mt19937 random(15);
    const Scan from = random_soup(random, 50);
    const Scan to = random_soup(random, 70);
    const SurfaceDistance plain = surface_distance(from, to, within(0x1p-12));
    for (const double factor : {0x1p-900, 0x1p-60, 0x1p60, 0x1p1000}) {
        const SurfaceDistance grown =
            surface_distance(scaled(from, factor), scaled(to, factor), within(0x1p-12 * factor));
        EXPECT_EQ(grown.maximum(), plain.maximum() * factor);
        EXPECT_EQ(grown.maximum_bound(), plain.maximum_bound() * factor);
        EXPECT_EQ(grown.rms(), plain.rms() * factor);
        EXPECT_EQ(grown.there.furthest, plain.there.furthest * factor);
    }
}

TEST(SurfaceDistance, DoesNotDependOnTheAxes) {
    std::mt19937 random(16);
    const Scan from = random_soup(random, 50);
    const Scan to = random_soup(random, 70);
    const Eigen::Quaterniond turn = Eigen::Quaterniond(1, 2, 3, 4).normalized();
    const auto turned = [&](const Vec3& x) { return Vec3(turn * x + Vec3(5, 6, 7)); };
    const SurfaceDistance plain = surface_distance(from, to, within(1e-6));
    const SurfaceDistance other = surface_distance(mapped(from, turned), mapped(to, turned), within(1e-6));
    EXPECT_NEAR(plain.there.maximum, other.there.maximum, 1e-6);
    EXPECT_NEAR(plain.back.maximum, other.back.maximum, 1e-6);
    EXPECT_NEAR(plain.there.rms, other.there.rms, 1e-12);
    EXPECT_NEAR(plain.back.rms, other.back.rms, 1e-12);
}

TEST(SurfaceDistance, TellsApartWhatFloat32DoesNot) {
    const Scan far_out = moved(cube(), Vec3::Constant(0x1p20));
    const double shift = 0x1p-30;
    const SurfaceDistance found = surface_distance(far_out, moved(far_out, {0, shift, 0}), within(0x1p-36));
    EXPECT_NEAR(found.there.maximum, shift, rounding_of(1));
    EXPECT_NEAR(found.back.maximum, shift, rounding_of(1));
    EXPECT_LE(found.maximum_bound(), shift + 0x1p-36);
}

TEST(SurfaceDistance, IsThatOfFacesAlone) {
    Scan with_stray_vertices = cube();
    with_stray_vertices.positions.emplace_back(50, 50, 50);
    with_stray_vertices.positions.push_back(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
    const Scan shifted = moved(cube(), {0.25, 0, 0});
    expect_same_bits(surface_distance(with_stray_vertices, shifted, within(1e-3)),
                     surface_distance(cube(), shifted, within(1e-3)));
}

TEST(SurfaceDistance, CountsFacesWithoutArea) {
    const Scan point{{{3, 4, 0}}, {{0, 0, 0}}};
    const Scan segment{{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}};
    const SurfaceDistance found = surface_distance(point, segment, within(1e-9));
    EXPECT_DOUBLE_EQ(found.there.maximum, std::sqrt(17.0));
    EXPECT_EQ(found.back.maximum, 5.0);
    EXPECT_EQ(found.rms(), 0.0);
    EXPECT_EQ(surface_distance(point, point, within(1e-9)).maximum(), 0.0);

    const Scan with_whisker = joined(cube(), {{{0, 0, 0}, {0, 0, -1}}, {{0, 1, 1}}});
    EXPECT_EQ(surface_distance(with_whisker, cube(), within(1e-6)).there.maximum, 1.0);
    EXPECT_LE(surface_distance(with_whisker, cube(), within(1e-6)).there.rms, rounding_of(2));
}

TEST(SurfaceDistance, RefusesWhatIsNoSurface) {
    const Scan no_faces{{{0, 0, 0}}, {}};
    Scan no_vertex = cube();
    no_vertex.faces.push_back({0, 1, 8});
    Scan negative = cube();
    negative.faces.push_back({0, 1, -1});
    Scan not_finite = cube();
    not_finite.positions[3].y() = infinity;
    for (const Scan& bad : {Scan{}, no_faces, no_vertex, negative, not_finite}) {
        EXPECT_THROW((void)surface_distance(bad, cube(), within(1)), std::invalid_argument);
        EXPECT_THROW((void)surface_distance(cube(), bad, within(1)), std::invalid_argument);
    }
}

TEST(SurfaceDistance, RefusesSenselessOptions) {
    for (const double bound : {0.0, -1.0, infinity, std::numeric_limits<double>::quiet_NaN(), 0x1p-41}) {
        EXPECT_THROW((void)surface_distance(cube(), cube(), within(bound)), std::invalid_argument);
    }
    DistanceOptions options = within(1);
    options.threads = 0;
    EXPECT_THROW((void)surface_distance(cube(), cube(), options), std::invalid_argument);
}

TEST(SurfaceDistance, ReportsProgressThatGrowsToTheEnd) {
    std::mt19937 random(17);
    double last = 0.0;
    DistanceOptions options = within(1e-4);
    options.progress = [&](double done) {
        EXPECT_GE(done, last);
        last = done;
        return true;
    };
    EXPECT_FALSE(surface_distance(random_soup(random, 400), random_soup(random, 300), options).cancelled);
    EXPECT_NEAR(last, 1.0, 1e-9);
}

TEST(SurfaceDistance, StopsWhereverItIsAsked) {
    std::mt19937 random(18);
    const Scan from = random_soup(random, 400);
    const Scan to = random_soup(random, 300);
    int calls = 0;
    int last_call = std::numeric_limits<int>::max();
    DistanceOptions options = within(1e-4);
    options.progress = [&](double) { return ++calls < last_call; };
    ASSERT_FALSE(surface_distance(from, to, options).cancelled);
    const int all = calls;
    for (last_call = 1; last_call <= all; ++last_call) {
        calls = 0;
        EXPECT_TRUE(surface_distance(from, to, options).cancelled);
        EXPECT_EQ(calls, last_call);
    }
    options.progress = [](double) -> bool { throw std::logic_error("enough"); };
    EXPECT_THROW((void)surface_distance(from, to, options), std::logic_error);
}

TEST(SurfaceDistance, KeepsTheArithmeticOfTheCallerApart) {
    std::mt19937 random(19);
    const Scan from = random_soup(random, 300);
    const Scan to = random_soup(random, 200);
    const SurfaceDistance plain = surface_distance(from, to, within(1e-4));
    std::fesetround(FE_UPWARD);
    const SurfaceDistance upward = surface_distance(from, to, within(1e-4));
    EXPECT_EQ(std::fegetround(), FE_UPWARD);
    std::fesetround(FE_TONEAREST);
    expect_same_bits(upward, plain);
}

TEST(SurfaceDistance, OfAScanToItselfMovedIsTheLengthOfTheWay) {
    const std::filesystem::path path = std::filesystem::path(FOLDLESS_SCANS) / "bunny.ply";
    if (!std::filesystem::exists(path)) {
        GTEST_SKIP() << "no bunny.ply in " FOLDLESS_SCANS;
    }
    const Scan scan = read_scan(path).scan;
    double size = 0.0;
    for (const Vec3& position : scan.positions) {
        size = std::max(size, (position - scan.positions[0]).norm());
    }
    const Vec3 way = size * Vec3(0.01, 0.02, -0.03); // reached where the surface ends that way
    const double bound = 1e-5 * size;
    const SurfaceDistance found = surface_distance(scan, moved(scan, way), within(bound));
    for (const OneSidedDistance& side : {found.there, found.back}) {
        EXPECT_LE(std::abs(side.maximum - way.norm()), bound);
        EXPECT_GE(side.maximum_bound, way.norm() * (1 - 1e-12));
        EXPECT_LE(side.maximum_bound - side.maximum, bound);
        EXPECT_LE(side.rms, way.norm());
    }
}

} // namespace
} // namespace foldless
