#include <foldless/bake/triangle_distance.h>

#include "distance_oracle.h"

#include <CGAL/Exact_rational.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace foldless::distances {
namespace {

using test::squared_distance;

const ScanTriangle right_angled{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 3, 0)};

Vec3 nearest_to(const Vec3& query) {
    return nearest_point(query, right_angled).point;
}

/// Exactly, then rounded.
double true_distance(const Vec3& query, const ScanTriangle& triangle) {
    return std::sqrt(CGAL::to_double(squared_distance<CGAL::Exact_rational>(query, triangle)));
}

double longest_side(const Vec3& query, const ScanTriangle& triangle) {
    const auto& [a, b, c] = triangle;
    return (a.cwiseMax(b).cwiseMax(c).cwiseMax(query) - a.cwiseMin(b).cwiseMin(c).cwiseMin(query)).maxCoeff();
}

/// The promise of the header, with the point on the triangle and at the stated distance.
void expect_right(const Vec3& query, const ScanTriangle& triangle) {
    const NearestPoint found = nearest_point(query, triangle);
    const double rounding = std::ldexp(longest_side(query, triangle), -46);
    EXPECT_NEAR(std::sqrt(found.squared_distance), true_distance(query, triangle), rounding);
    const double rounding_of_point = rounding + std::ldexp(query.norm() + triangle[0].norm(), -50);
    EXPECT_NEAR((found.point - query).norm(), std::sqrt(found.squared_distance), rounding_of_point);
    EXPECT_LE(true_distance(found.point, triangle), rounding_of_point);
}

TEST(TriangleDistance, FindsThePointInsideOnAnEdgeOrAtACorner) {
    EXPECT_TRUE(nearest_to({1, 1, 5}).isApprox(Vec3(1, 1, 0), 1e-15));
    EXPECT_EQ(nearest_to({1, -2, 1}), Vec3(1, 0, 0));
    EXPECT_EQ(nearest_to({-2, 1, 1}), Vec3(0, 1, 0));
    EXPECT_TRUE(nearest_to({2 + 3, 1.5 + 4, -1}).isApprox(Vec3(2, 1.5, 0), 1e-15));
    EXPECT_EQ(nearest_to({-1, -1, 0}), Vec3(0, 0, 0));
    EXPECT_EQ(nearest_to({6, -1, 0}), Vec3(4, 0, 0));
    EXPECT_EQ(nearest_to({0, 5, 2}), Vec3(0, 3, 0));
}

TEST(TriangleDistance, IsNothingAtTheCorners) {
    for (const Vec3& corner : right_angled) {
        EXPECT_EQ(nearest_point(corner, right_angled).squared_distance, 0.0);
    }
}

TEST(TriangleDistance, IsExactOfATriangleThatIsASegmentOrAPoint) {
    const Vec3 a(0, 0, 0);
    const Vec3 b(1, 0, 0);
    const Vec3 c(2, 0, 0);
    for (const ScanTriangle& segment : {ScanTriangle{a, b, c}, {b, a, c}, {c, a, b}, {a, a, c}, {a, c, a}, {c, a, a}}) {
        EXPECT_EQ(nearest_point(Vec3(1.5, 0, 2), segment).squared_distance, 4.0);
        EXPECT_EQ(nearest_point(Vec3(3, 0, 0), segment).squared_distance, 1.0);
    }
    EXPECT_EQ(nearest_point(Vec3(0, 3, 4), {a, a, a}).squared_distance, 25.0);
}

TEST(TriangleDistance, IsRightForThinTrianglesOfAllShapes) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    std::uniform_int_distribution<int> exponent(0, 60);
    const auto vector = [&] { return Vec3(place(random), place(random), place(random)); };
    const auto little = [&] { return std::ldexp(1.0, -exponent(random)); };
    for (int i = 0; i < 20'000; ++i) {
        const Vec3 a = vector();
        const Vec3 b = a + little() * vector();
        const Vec3 c = a + 2 * place(random) * (b - a) + little() * vector();
        const Vec3 foot = a + place(random) * (b - a) + place(random) * (c - a);
        expect_right(foot + little() * vector(), {a, b, c});
        expect_right(foot + little() * (b - a).cross(c - a).normalized(), {c, b, a});
    }
}

} // namespace
} // namespace foldless::distances
