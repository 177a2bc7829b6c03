#include "mapped_scan.h"

#include <foldless/bake/atlas_maps.h>
#include <foldless/bake/atlas_sampler.h>
#include <foldless/bake/reconstruct.h>
#include <foldless/bake/surface_distance.h>
#include <foldless/io/bounding_box.h>
#include <foldless/io/defects.h>
#include <foldless/models/make_model.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace foldless {
namespace {

using test::MappedScan;

AtlasMaps baked(const MappedScan& mapped, const Atlas& atlas, int threads) {
    const std::vector<Eigen::Vector3f> no_colours;
    AtlasMapsOptions options;
    options.threads = threads;
    return bake_atlas(mapped.base, ScanSurface(mapped.scan, no_colours), mapped.map, atlas, options);
}

TEST(AtlasMaps, AreTheSameOnAnyNumberOfThreads) {
    const MappedScan mapped = test::decimated_model(Shape::bumpy_sphere, 1500, 100);
    const Atlas atlas = make_atlas(mapped.base, {256, 2});
    const AtlasMaps on_one = baked(mapped, atlas, 1);
    const AtlasMaps on_three = baked(mapped, atlas, 3);
    EXPECT_EQ(on_one.displacement.values, on_three.displacement.values);
    EXPECT_EQ(on_one.mask.values, on_three.mask.values);
    EXPECT_EQ(on_one.vector.values, on_three.vector.values);
    EXPECT_EQ(on_one.normal.values, on_three.normal.values);
    EXPECT_EQ(on_one.samples, on_three.samples);
    EXPECT_GT(on_one.samples, 0U);
    EXPECT_EQ(on_one.uncovered, 0U);
    EXPECT_EQ(on_one.contested, 0U);
}

TEST(AtlasMaps, AreZeroOfAScanThatIsItsBase) {
    const Scan scan = to_scan(make_model({Shape::torus, 300, {}}));
    DecimateOptions options;
    options.target_faces = scan.faces.size();
    const MappedScan mapped = test::decimated(scan, options);
    const AtlasMaps maps = baked(mapped, make_atlas(mapped.base, {512, 2}), 1);
    EXPECT_EQ(maps.uncovered, 0U);
    for (const float value : maps.displacement.values) {
        ASSERT_EQ(value, 0.0F);
    }
    for (const float value : maps.vector.values) {
        ASSERT_EQ(value, 0.0F);
    }
    EXPECT_EQ(*std::max_element(maps.mask.values.begin(), maps.mask.values.end()), 1.0F);
}

TEST(AtlasMaps, HaveNormalsOfLengthOne) {
    const MappedScan mapped = test::decimated_model(Shape::knot, 1000, 200);
    const AtlasMaps maps = baked(mapped, make_atlas(mapped.base, {256, 2}), 1);
    for (std::size_t texel = 0; texel < maps.mask.values.size(); ++texel) {
        const Eigen::Vector3f normal(&maps.normal.values[3 * texel]);
        ASSERT_NEAR(normal.norm(), maps.mask.values[texel], 1e-5);
    }
}

/// The Hausdorff distance of what the map of an atlas gives back, in diagonals of the scan.
double distance_back(const MappedScan& mapped, int size, int level) {
    const Atlas atlas = make_atlas(mapped.base, {size, 2});
    const AtlasMaps maps = baked(mapped, atlas, 1);
    const AtlasSampler sampler(atlas, maps.displacement, maps.mask);
    const Scan back = reconstruct(
        mapped.base, [&](std::int32_t face, const Vec3& alpha) { return sampler.value(face, alpha); }, {level, 1});
    EXPECT_FALSE(inspect(back).defects.any());
    EXPECT_EQ(inspect(back).topology.boundary_loops, inspect(mapped.scan).topology.boundary_loops);
    const double diagonal = bounding_box_diagonal(mapped.scan);
    DistanceOptions options;
    options.bound = 1e-4 * diagonal;
    options.threads = 1;
    return surface_distance(mapped.scan, back, options).maximum() / diagonal;
}

TEST(AtlasMaps, GiveTheScanBack) {
    const MappedScan mapped = test::decimated_model(Shape::bumpy_sphere, 3000, 150);
    const double coarse = distance_back(mapped, 128, 2);
    const double fine = distance_back(mapped, 512, 5);
    RecordProperty("coarse", std::to_string(coarse));
    RecordProperty("fine", std::to_string(fine));
    EXPECT_LT(fine, 2e-3);
    EXPECT_LT(fine, 0.5 * coarse) << coarse;
    EXPECT_LT(distance_back(mapped, 256, 4), coarse);
}

TEST(AtlasMaps, GiveATrimmedScanBack) {
    DecimateOptions options;
    options.target_faces = 60;
    options.boundary = Boundary::trim;
    const MappedScan mapped = test::decimated(to_scan(make_model({Shape::cylinder, 3000, {}})), options);
    ASSERT_GT(inspect(mapped.scan).topology.boundary_loops, 0U);
    EXPECT_GT(baked(mapped, make_atlas(mapped.base, {256, 2}), 1).uncovered, 0U);
    const double coarse = distance_back(mapped, 128, 3);
    const double fine = distance_back(mapped, 512, 6);
    EXPECT_LT(fine, 5e-3); // the border is known to a texel
    EXPECT_LT(fine, 0.5 * coarse) << coarse;
}

TEST(AtlasMaps, StopWhenAsked) {
    const MappedScan mapped = test::decimated_model(Shape::torus, 300, 60);
    const std::vector<Eigen::Vector3f> no_colours;
    AtlasMapsOptions options;
    options.progress = [](double) { return false; };
    const Atlas atlas = make_atlas(mapped.base, {128, 1});
    const ScanSurface surface(mapped.scan, no_colours);
    EXPECT_TRUE(bake_atlas(mapped.base, surface, mapped.map, atlas, options).cancelled);
    options.threads = 0;
    EXPECT_THROW((void)bake_atlas(mapped.base, surface, mapped.map, atlas, options), std::invalid_argument);
}

} // namespace
} // namespace foldless
