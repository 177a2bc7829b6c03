#include "made_scans.h"

#include <foldless/decimate/decimate.h>
#include <foldless/decimate/local_order.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

namespace foldless {
namespace {

using test::bumpy_sphere;
using test::terrain;

/// The same scan with vertices and faces in a random order.
Scan shuffled(const Scan& scan, std::uint32_t seed) {
    LocalOrder order{std::vector<std::int32_t>(scan.positions.size()), std::vector<std::int32_t>(scan.faces.size())};
    std::mt19937 random(seed);
    for (std::vector<std::int32_t>* indices : {&order.vertices, &order.faces}) {
        std::iota(indices->begin(), indices->end(), 0);
        std::shuffle(indices->begin(), indices->end(), random);
    }
    return in_order(scan, order);
}

std::vector<std::array<Vec3, 3>> corners_of(const std::vector<Triangle>& faces, const std::vector<Vec3>& positions) {
    std::vector<std::array<Vec3, 3>> result;
    result.reserve(faces.size());
    for (const Triangle& face : faces) {
        result.push_back({positions[face[0]], positions[face[1]], positions[face[2]]});
    }
    return result;
}

Scan points(const std::vector<Vec3>& positions) {
    return {positions, {{0, 1, 2}}, false};
}

TEST(LocalOrder, FollowsTheMortonCurve) {
    Scan scan = points({{3, 3, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    EXPECT_EQ(local_order(scan).vertices, (std::vector<std::int32_t>{4, 5, 6, 3, 1, 2, 0}));
}

TEST(LocalOrder, SortsFacesByTheirVerticesAndKeepsTheOrderOfCorners) {
    Scan scan{{{3, 3, 0}, {0, 0, 0}, {3, 0, 0}, {0, 3, 0}}, {{0, 3, 2}, {2, 3, 1}}, true};
    const LocalOrder order = local_order(scan);
    EXPECT_EQ(order.vertices, (std::vector<std::int32_t>{1, 2, 3, 0}));
    EXPECT_EQ(order.faces, (std::vector<std::int32_t>{1, 0}));
    EXPECT_EQ(in_order(scan, order).faces, (std::vector<Triangle>{{1, 2, 0}, {3, 2, 1}}));
}

TEST(LocalOrder, CanBeUndone) {
    const Scan scan = shuffled(terrain(4, 0.1), 5);
    const LocalOrder order = local_order(scan);
    const Scan again = as_before(in_order(scan, order), order);
    EXPECT_EQ(again.positions, scan.positions);
    EXPECT_EQ(again.faces, scan.faces);
    EXPECT_EQ(again.float32, scan.float32);
}

TEST(LocalOrder, KeepsEveryFaceWhereItIs) {
    const Scan scan = bumpy_sphere(3);
    const LocalOrder order = local_order(scan);
    const Scan ordered = in_order(scan, order);
    const std::vector<std::array<Vec3, 3>> before = corners_of(scan.faces, scan.positions);
    const std::vector<std::array<Vec3, 3>> after = corners_of(ordered.faces, ordered.positions);
    for (std::size_t f = 0; f < after.size(); ++f) {
        EXPECT_EQ(after[f], before[order.faces[f]]);
    }
    std::vector<std::int32_t> sorted = order.vertices;
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::int32_t> all(scan.positions.size());
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(sorted, all);
}

TEST(LocalOrder, HoldsAtEveryScale) {
    const double huge = std::numeric_limits<double>::max();
    const double tiny = std::numeric_limits<double>::denorm_min();
    EXPECT_EQ(local_order(points({{huge, 0, 0}, {-huge, 0, 0}, {0, huge, 0}})).vertices,
              (std::vector<std::int32_t>{1, 0, 2}));
    EXPECT_EQ(local_order(points({{tiny, 0, 0}, {0, 0, 0}, {0, tiny, 0}})).vertices,
              (std::vector<std::int32_t>{1, 2, 0}));
    EXPECT_EQ(local_order(points({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}})).vertices, (std::vector<std::int32_t>{0, 1, 2}));
}

TEST(Decimate, GivesTheSameBaseMeshHoweverTheScanIsNumbered) {
    for (const Scan& scan : {bumpy_sphere(3), terrain(16, 0.2)}) {
        const DecimateResult expected = decimate(scan);
        auto faces = corners_of(expected.base.faces, expected.base.positions);
        const auto by_coordinates = [](const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
            return std::lexicographical_compare(a[0].data(), a[0].data() + 9, b[0].data(), b[0].data() + 9);
        };
        std::sort(faces.begin(), faces.end(), by_coordinates);
        for (const std::uint32_t seed : {1U, 2U, 3U}) {
            const DecimateResult result = decimate(shuffled(scan, seed));
            auto others = corners_of(result.base.faces, result.base.positions);
            std::sort(others.begin(), others.end(), by_coordinates);
            EXPECT_EQ(others, faces);
        }
    }
}

} // namespace
} // namespace foldless
