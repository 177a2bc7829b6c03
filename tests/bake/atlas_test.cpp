#include "random_triangles.h"

#include <foldless/bake/atlas.h>
#include <foldless/bake/chart_samples.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace foldless {
namespace {

BaseMesh soup(const std::vector<std::array<Vec3, 3>>& triangles) {
    BaseMesh base;
    for (const auto& corners : triangles) {
        const auto first = static_cast<std::int32_t>(base.positions.size());
        base.positions.insert(base.positions.end(), corners.begin(), corners.end());
        base.faces.push_back({first, first + 1, first + 2});
    }
    return base;
}

/// Triangles of all sizes, here and there a sliver.
BaseMesh random_soup(RandomTriangles& random, int faces) {
    std::vector<std::array<Vec3, 3>> triangles;
    for (int face = 0; face < faces; ++face) {
        const double size = std::exp2(random.number(-4, 0));
        std::array<Vec3, 3> corners{random.vector(size), random.vector(size), random.vector(size)};
        if (face % 7 == 3) {
            corners[face % 3] = 0.5 * (corners[(face + 1) % 3] + corners[(face + 2) % 3]) + random.vector(1e-7);
        }
        triangles.push_back(corners);
    }
    return soup(triangles);
}

/// All samples of a chart with its gutter, as chart_samples makes them of a face that is covered to the last sample.
std::vector<ChartSample> chart_samples(const Chart& chart, int gutter) {
    const Vec3 up(0, 0, 1);
    const BaseTriangle triangle{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {up, up, up}};
    const Scan scan{{triangle.v[0], triangle.v[1], triangle.v[2]}, {{0, 1, 2}}};
    FaceSamples samples(chart.lattice, {-1, 1});
    for (int j = 0; j <= chart.lattice.rows; ++j) {
        for (int i = 0; i <= chart.lattice.last_column(j); ++i) {
            samples.at(i, j).face = 0;
        }
    }
    return with_gutter(samples, triangle, scan, gutter);
}

/// Every texel belongs to one chart at most, and all lie in the picture; the share of them that has an owner.
double expect_apart(const Atlas& atlas) {
    std::vector<std::int32_t> owner(static_cast<std::size_t>(atlas.size) * static_cast<std::size_t>(atlas.size), -1);
    std::size_t owned = 0;
    for (std::int32_t face = 0; face < static_cast<std::int32_t>(atlas.charts.size()); ++face) {
        const Chart& chart = atlas.charts[face];
        EXPECT_GE(chart.lattice.columns, 1);
        EXPECT_GE(chart.lattice.rows, 1);
        for (const ChartSample& sample : chart_samples(chart, atlas.gutter)) {
            const auto [x, y] = chart.texel(sample.i, sample.j);
            if (x < 0 || x >= atlas.size || y < 0 || y >= atlas.size) {
                ADD_FAILURE() << "chart " << face << " leaves the picture at " << x << " " << y;
                return 0.0;
            }
            std::int32_t& there = owner[static_cast<std::size_t>(y * atlas.size + x)];
            if (there >= 0) {
                ADD_FAILURE() << "charts " << face << " and " << there << " meet at " << x << " " << y;
                return 0.0;
            }
            there = face;
            ++owned;
        }
    }
    return static_cast<double>(owned) / static_cast<double>(owner.size());
}

TEST(Atlas, KeepsChartsAndGuttersApart) {
    RandomTriangles random(1);
    for (const int faces : {1, 2, 3, 4, 17, 40}) {
        const BaseMesh base = random_soup(random, faces);
        for (const int size : {64, 100, 256}) {
            for (const int gutter : {1, 2}) {
                SCOPED_TRACE(std::to_string(faces) + " faces, size " + std::to_string(size) + ", gutter " +
                             std::to_string(gutter));
                const Atlas atlas = make_atlas(base, {size, gutter});
                EXPECT_EQ(atlas.size, size);
                EXPECT_EQ(atlas.gutter, gutter);
                ASSERT_EQ(atlas.charts.size(), base.faces.size());
                expect_apart(atlas);
            }
        }
    }
    expect_apart(make_atlas(random_soup(random, 1000), {512, 2}));
}

TEST(Atlas, HasTheRightAngleOppositeTheLongestEdge) {
    RandomTriangles random(2);
    const BaseMesh base = random_soup(random, 40);
    const Atlas atlas = make_atlas(base, {256, 2});
    for (std::size_t face = 0; face < base.faces.size(); ++face) {
        const auto length = [&](int corner) {
            return (base.positions[base.faces[face][(corner + 1) % 3]] -
                    base.positions[base.faces[face][(corner + 2) % 3]])
                .norm();
        };
        EXPECT_EQ(length(atlas.charts[face].corner), std::max({length(0), length(1), length(2)}));
    }
}

TEST(Atlas, HasCoordinatesAtCentresOfTexels) {
    RandomTriangles random(3);
    const BaseMesh base = random_soup(random, 25);
    const Atlas atlas = make_atlas(base, {128, 2});
    for (std::int32_t face = 0; face < 25; ++face) {
        const Chart& chart = atlas.charts[face];
        const std::array<std::array<int, 2>, 3> samples{{{0, 0}, {chart.lattice.columns, 0}, {0, chart.lattice.rows}}};
        for (int k = 0; k < 3; ++k) {
            const auto [x, y] = chart.texel(samples[k][0], samples[k][1]);
            const Eigen::Vector2d found = atlas.coordinates(face, (chart.corner + k) % 3);
            EXPECT_EQ(found.x() * 128, x + 0.5);
            EXPECT_EQ(found.y() * 128, y + 0.5);
        }
    }
}

// Gutters included; one chart alone fills half of a square at most.
TEST(Atlas, FillsThePicture) {
    RandomTriangles random(4);
    for (const int faces : {1, 2, 40}) {
        EXPECT_GT(expect_apart(make_atlas(random_soup(random, faces), {256, 1})), faces == 1 ? 0.2 : 0.4) << faces;
    }
}

TEST(Atlas, GivesEveryFaceTheSameTexelsPerLength) {
    const std::array<Vec3, 3> large{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 2, 0)};
    const std::array<Vec3, 3> small{Vec3(0, 0, 5), Vec3(1, 0, 5), Vec3(0, 0.5, 5)};
    const Atlas atlas = make_atlas(soup({large, large, small, small}), {256, 2});
    EXPECT_NEAR(atlas.charts[0].lattice.columns, 4 * atlas.charts[2].lattice.columns, 4);
    EXPECT_NEAR(atlas.charts[0].lattice.rows, 4 * atlas.charts[2].lattice.rows, 4);
    EXPECT_NEAR(atlas.charts[0].lattice.columns, 2 * atlas.charts[0].lattice.rows, 2);
}

// Faces with next to no area: the picture is as long as the longest, whatever the area says.
TEST(Atlas, IsAsLargeAsItCanBeForSlivers) {
    for (const double width : {1e-3, 1e-8, 1e-12, 0.0}) {
        const std::array<Vec3, 3> sliver{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, width, 0)};
        const std::array<Vec3, 3> needle{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, width, 0)};
        for (const int faces : {1, 2, 5}) {
            expect_apart(make_atlas(soup(std::vector(static_cast<std::size_t>(faces), needle)), {256, 2}));
            const Atlas atlas = make_atlas(soup(std::vector(static_cast<std::size_t>(faces), sliver)), {256, 2});
            expect_apart(atlas);
            EXPECT_GT(std::max(atlas.charts[0].lattice.columns, atlas.charts[0].lattice.rows), 50)
                << width << " " << faces;
        }
    }
}

TEST(Atlas, RefusesWhatDoesNotFit) {
    RandomTriangles random(5);
    const BaseMesh base = random_soup(random, 200);
    EXPECT_THROW((void)make_atlas(base, {64, 2}), AtlasTooSmall);
    EXPECT_THROW((void)make_atlas(base, {8, 2}), AtlasTooSmall);
    EXPECT_THROW((void)make_atlas(random_soup(random, 1), {5, 2}), AtlasTooSmall);
    EXPECT_NO_THROW((void)make_atlas(base, {256, 2}));
}

TEST(Atlas, IsTheSameForTheSameMesh) {
    RandomTriangles random(6);
    const BaseMesh base = random_soup(random, 60);
    const Atlas first = make_atlas(base, {256, 2});
    const Atlas second = make_atlas(base, {256, 2});
    for (std::size_t face = 0; face < base.faces.size(); ++face) {
        const auto all = [&](const Chart& chart) {
            return std::array{chart.corner, chart.lattice.columns, chart.lattice.rows, chart.x,
                              chart.y,      chart.turned ? 1 : 0};
        };
        EXPECT_EQ(all(first.charts[face]), all(second.charts[face]));
    }
}

} // namespace
} // namespace foldless
