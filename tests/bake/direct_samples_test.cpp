#include "mapped_scan.h"

#include <foldless/bake/atlas_maps.h>
#include <foldless/bake/direct_samples.h>
#include <foldless/io/bounding_box.h>
#include <foldless/models/make_model.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace foldless {
namespace {

using test::MappedScan;

Atlas atlas_of(const MappedScan& mapped) {
    return make_atlas(mapped.base, {256, 2});
}

AtlasMaps baked(const MappedScan& mapped, BakeMethod method, int threads) {
    const std::vector<Eigen::Vector3f> no_colours;
    AtlasMapsOptions options;
    options.method = method;
    options.threads = threads;
    return bake_atlas(mapped.base, ScanSurface(mapped.scan, no_colours), mapped.map, atlas_of(mapped), options);
}

/// A triangle in z = 0 that is displaced upwards, and triangles over all of it at these heights, seen from in front
/// from above if `up`.
struct Stack {
    BaseMesh base;
    Scan scan;
    SurfaceMap map;

    void add_sheet(double height, bool up) {
        const auto first = static_cast<std::int32_t>(scan.positions.size());
        for (const Vec3& corner : {Vec3(-1, -1, height), Vec3(3, -1, height), Vec3(-1, 3, height)}) {
            scan.positions.push_back(corner);
        }
        scan.faces.push_back(up ? Triangle{first, first + 1, first + 2} : Triangle{first, first + 2, first + 1});
    }

    explicit Stack(Range range) {
        base.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        base.faces = {{0, 1, 2}};
        base.directions.assign(3, Vec3(0, 0, 1));
        map = {{0, 0}, {}, {range}, {false}};
    }

    [[nodiscard]] FaceSamples samples() const {
        const ScanRays rays(scan);
        return direct_samples(base, rays, map, {0, 0, {8, 8}});
    }
};

TEST(DirectSamples, TakeTheNearestSheetThatFacesTheRightWay) {
    Stack stack({-1.0, 1.0});
    stack.add_sheet(0.75, true);
    stack.add_sheet(-0.5, true);
    stack.add_sheet(0.25, false);
    stack.add_sheet(-1.25, true); // out of range
    const FaceSamples samples = stack.samples();
    EXPECT_EQ(samples.contested, 45U);
    for (int j = 0; j <= 8; ++j) {
        for (int i = 0; i <= 8 - j; ++i) {
            ASSERT_EQ(samples.at(i, j).face, 1);
            ASSERT_DOUBLE_EQ(samples.at(i, j).t, -0.5);
        }
    }
}

TEST(DirectSamples, AreFoundAtBothEndsOfTheRange) {
    for (const double height : {-0.3, 0.7}) {
        Stack stack({-0.3, 0.7});
        stack.add_sheet(height, true);
        const FaceSamples samples = stack.samples();
        EXPECT_EQ(samples.contested, 0U);
        ASSERT_EQ(samples.at(3, 2).face, 0);
        EXPECT_EQ(samples.at(3, 2).t, height);
    }
}

TEST(DirectSamples, AreUncoveredWhereNothingFacesTheRightWay) {
    Stack stack({-1.0, 1.0});
    stack.add_sheet(0.5, false);
    stack.add_sheet(1.5, true);
    EXPECT_FALSE(stack.samples().at(1, 1).exists());
}

TEST(DirectSamples, AreTheSameOnAnyNumberOfThreads) {
    const MappedScan mapped = test::decimated_model(Shape::bumpy_sphere, 1500, 100);
    const AtlasMaps on_one = baked(mapped, BakeMethod::direct, 1);
    const AtlasMaps on_four = baked(mapped, BakeMethod::direct, 4);
    EXPECT_EQ(on_one.displacement.values, on_four.displacement.values);
    EXPECT_EQ(on_one.mask.values, on_four.mask.values);
    EXPECT_EQ(on_one.vector.values, on_four.vector.values);
    EXPECT_EQ(on_one.normal.values, on_four.normal.values);
    EXPECT_EQ(on_one.uncovered, on_four.uncovered);
}

/// The vector from the sample to the point of the scan; nothing if it is uncovered.
std::optional<Eigen::Vector3f> vector_at(const AtlasMaps& maps, const std::array<int, 2>& texel) {
    const auto index = static_cast<std::size_t>(texel[1] * maps.mask.width + texel[0]);
    return maps.mask.values[index] == 0.0F ? std::nullopt
                                           : std::optional(Eigen::Vector3f(&maps.vector.values[3 * index]));
}

/// The largest difference between displacements of samples that have one in both maps, model units.
double largest_difference(const Atlas& atlas, const AtlasMaps& one, const AtlasMaps& other) {
    float largest = 0.0F;
    for (const Chart& chart : atlas.charts) {
        for (int j = 0; j <= chart.lattice.rows; ++j) {
            for (int i = 0; i <= chart.lattice.last_column(j); ++i) {
                const auto first = vector_at(one, chart.texel(i, j));
                const auto second = vector_at(other, chart.texel(i, j));
                largest = std::max(largest, first && second ? (*first - *second).norm() : 0.0F);
            }
        }
    }
    return static_cast<double>(largest);
}

/// Where both find the same face, both compute its point in doubles. Where float32 finds the face on the other side of
/// an edge, the point is on that edge: beside the line by a few 2^-24 of the size, and further along it by that over
/// the cosine between direction and normal, for which 1/20 leaves room.
TEST(DirectSamples, AgreeWithTheInverseMethod) {
    constexpr double bound = 0x1p-22 * 20;
    for (const Shape shape : {Shape::bumpy_sphere, Shape::torus, Shape::knot}) {
        const MappedScan mapped = test::decimated_model(shape, 3000, 200);
        const AtlasMaps inverse = baked(mapped, BakeMethod::inverse, 1);
        const AtlasMaps direct = baked(mapped, BakeMethod::direct, 1);
        EXPECT_EQ(direct.samples, inverse.samples);
        EXPECT_EQ(inverse.uncovered, 0U);
        EXPECT_EQ(direct.contested, 0U);
        EXPECT_EQ(direct.uncovered, 0U) << "of " << direct.samples << " rays";
        EXPECT_LE(largest_difference(atlas_of(mapped), inverse, direct), bound * bounding_box_diagonal(mapped.scan));
    }
}

} // namespace
} // namespace foldless
