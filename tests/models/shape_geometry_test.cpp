#include <foldless/models/make_model.h>

#include "mesh_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace foldless {
namespace {

using std::numbers::pi;

Scan scan_of(Shape shape, std::int64_t faces) {
    ModelRequest request;
    request.shape = shape;
    request.faces = faces;
    return to_scan(make_model(request));
}

Vec3 area_vector(const Scan& scan, const Triangle& f) {
    return (scan.positions[f[1]] - scan.positions[f[0]]).cross(scan.positions[f[2]] - scan.positions[f[0]]);
}

TEST(ShapeGeometry, VolumesAreTheKnownOnes) {
    constexpr double polyhedron = 0.01; // relative: what a polyhedron of 20,000 faces lacks
    const auto volume = [](Shape shape) { return check_mesh(scan_of(shape, 20'000)).volume; };
    EXPECT_NEAR(volume(Shape::sphere), 4 * pi / 3, polyhedron * 4 * pi / 3);
    EXPECT_NEAR(volume(Shape::torus), 2 * pi * pi * 0.16, polyhedron * 2 * pi * pi * 0.16);
    EXPECT_NEAR(volume(Shape::knot), pi * 0.25 * 31.8986, polyhedron * pi * 0.25 * 31.8986);
    constexpr double float32 = 1e-6; // relative: the rounding of the positions
    EXPECT_NEAR(volume(Shape::ears), 1 + 2 * 0.6 * 0.04 * 0.8, float32);
    EXPECT_NEAR(volume(Shape::spike), 5, 5 * float32);
    EXPECT_NEAR(volume(Shape::cube), 40 * 40 * 40, 40 * 40 * 40 * float32);
}

TEST(ShapeGeometry, SphereHasRadiusOne) {
    for (const Vec3& p : scan_of(Shape::sphere, 5000).positions) {
        EXPECT_NEAR(p.norm(), 1, 1e-7);
    }
}

TEST(ShapeGeometry, BumpySphereIsStarShaped) {
    const Scan scan = scan_of(Shape::bumpy_sphere, 20'000);
    double least = 1;
    double greatest = 1;
    for (const Vec3& p : scan.positions) {
        least = std::min(least, p.norm());
        greatest = std::max(greatest, p.norm());
    }
    EXPECT_LT(least, 0.85);
    EXPECT_GT(greatest, 1.15);
    for (const Triangle& f : scan.faces) {
        EXPECT_GT(scan.positions[f[0]].dot(area_vector(scan, f)), 0);
    }
}

TEST(ShapeGeometry, TerrainIsAHeightField) {
    const Scan scan = scan_of(Shape::terrain, 20'000);
    for (const Triangle& f : scan.faces) {
        EXPECT_GT(area_vector(scan, f).z(), 0);
    }
}

TEST(ShapeGeometry, CubeHasWholeCoordinatesAndEqualFaces) {
    const Scan scan = scan_of(Shape::cube, 12 * 49 * 49); // 49 * (1.0 / 49) is not 1
    for (const Vec3& p : scan.positions) {
        EXPECT_EQ(p, Vec3(std::round(p.x()), std::round(p.y()), std::round(p.z())));
    }
    for (const Triangle& f : scan.faces) {
        EXPECT_EQ(area_vector(scan, f).norm(), 1);
    }
}

/// Whether the vertical line through (x, y) meets the face.
bool is_over(const Scan& scan, const Triangle& f, double x, double y) {
    int positive = 0;
    int negative = 0;
    for (int i = 0; i < 3; ++i) {
        const Vec3& a = scan.positions[f[i]];
        const Vec3& b = scan.positions[f[(i + 1) % 3]];
        const double side = (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
        positive += side > 0 ? 1 : 0;
        negative += side < 0 ? 1 : 0;
    }
    return positive == 3 || negative == 3;
}

TEST(ShapeGeometry, FoldLiesInThreeLayersTheMiddleOneFacingDown) {
    const Scan scan = scan_of(Shape::fold, 5000);
    std::vector<std::pair<double, bool>> layers; // height, faces up
    for (const Triangle& f : scan.faces) {
        if (is_over(scan, f, 1.4987, 1.0123)) { // on no edge
            layers.emplace_back(scan.positions[f[0]].z(), area_vector(scan, f).z() > 0);
        }
    }
    std::sort(layers.begin(), layers.end());
    ASSERT_EQ(layers.size(), 3U);
    EXPECT_TRUE(layers[0].second);
    EXPECT_FALSE(layers[1].second);
    EXPECT_TRUE(layers[2].second);
    EXPECT_NEAR(layers[2].first - layers[0].first, 0.6, 1e-6);
}

TEST(ShapeGeometry, NoShapeCrossesItself) {
    for (const Shape shape : all_shapes) {
        EXPECT_FALSE(crosses_itself(scan_of(shape, 2500))) << name_of(shape);
    }
}

TEST(ShapeGeometry, ACrossingWouldBeSeen) {
    Scan scan = scan_of(Shape::ears, 2500);
    const auto last = static_cast<std::int32_t>(scan.positions.size());
    scan.positions.insert(scan.positions.end(), {{0.5, 0.5, 0.3}, {0.5, 0.6, -2}, {0.6, 0.5, -2}}); // into the body
    scan.faces.push_back({last, last + 1, last + 2});
    EXPECT_TRUE(crosses_itself(scan));
}

} // namespace
} // namespace foldless
