#include "mapped_scan.h"

#include <foldless/bake/reconstruct.h>
#include <foldless/bake/subdivision.h>

#include <foldless/io/defects.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace foldless {
namespace {

using Weights = Subdivision::Weights;

/// The weight of each vertex of the mesh that has one: the same for the same point, whatever face it is seen from.
std::map<std::int32_t, int> place(const Triangle& face, const Weights& weights) {
    std::map<std::int32_t, int> result;
    for (int k = 0; k < 3; ++k) {
        if (weights[k] > 0) {
            result[face[k]] = weights[k];
        }
    }
    return result;
}

const std::vector<std::pair<std::size_t, std::vector<Triangle>>>& meshes() {
    static const std::vector<std::pair<std::size_t, std::vector<Triangle>>> all{
        {3, {{0, 1, 2}}},
        {4, {{0, 1, 2}, {2, 1, 3}}},
        {4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}},
        {5, {{4, 1, 2}, {2, 1, 3}, {3, 0, 2}}}};
    return all;
}

TEST(Subdivision, NumbersEveryPointOnce) {
    for (const auto& [vertices, faces] : meshes()) {
        for (int level = 0; level <= 4; ++level) {
            const Subdivision subdivision(vertices, faces, level);
            const int n = 1 << level;
            EXPECT_EQ(subdivision.segments(), n);
            std::map<std::size_t, std::map<std::int32_t, int>> places;
            std::map<std::map<std::int32_t, int>, std::size_t> numbers;
            for (std::int32_t face = 0; face < static_cast<std::int32_t>(faces.size()); ++face) {
                for (int c = 0; c <= n; ++c) {
                    for (int b = 0; b + c <= n; ++b) {
                        const Weights weights{n - b - c, b, c};
                        const auto here = place(faces[face], weights);
                        // Points inside two faces with the same corners would be taken for one; no mesh here has such.
                        const std::size_t number = subdivision.vertex(face, weights);
                        EXPECT_EQ(places.try_emplace(number, here).first->second, here);
                        EXPECT_EQ(numbers.try_emplace(here, number).first->second, number);
                    }
                }
            }
            EXPECT_EQ(places.rbegin()->first + 1, subdivision.vertex_count());
            EXPECT_EQ(places.size(), subdivision.vertex_count());
        }
    }
}

TEST(Subdivision, CutsAFaceIntoFacesOfItsOrientation) {
    const std::vector<Triangle> faces{{0, 1, 2}};
    for (int level = 0; level <= 4; ++level) {
        const Subdivision subdivision(3, faces, level);
        std::size_t count = 0;
        subdivision.for_each_face([&](const Weights& a, const Weights& b, const Weights& c) {
            ++count;
            for (const Weights& corner : {a, b, c}) {
                EXPECT_EQ(corner[0] + corner[1] + corner[2], 1 << level);
                EXPECT_GE(*std::min_element(corner.begin(), corner.end()), 0);
            }
            EXPECT_EQ((b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]), 1) << "of the area of one";
        });
        EXPECT_EQ(count, std::size_t{1} << (2 * level));
        EXPECT_EQ(count, subdivision.faces_per_face());
    }
}

BaseMesh octahedron() {
    BaseMesh base;
    base.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    base.directions = base.positions;
    base.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    return base;
}

/// Every edge has one face on either side.
void expect_closed(const Scan& scan) {
    std::map<std::pair<std::int32_t, std::int32_t>, int> halves;
    for (const Triangle& face : scan.faces) {
        for (int k = 0; k < 3; ++k) {
            EXPECT_EQ(++halves[std::pair(face[k], face[(k + 1) % 3])], 1);
        }
    }
    for (const auto& [half, count] : halves) {
        EXPECT_TRUE(halves.contains(std::pair(half.second, half.first)));
    }
}

TEST(Reconstruct, OfAClosedBaseMeshIsClosed) {
    const BaseMesh base = test::decimated_model(Shape::torus, 600, 60).base;
    for (int level = 0; level <= 4; ++level) {
        const Scan scan = reconstruct(base, [](std::int32_t, const Vec3&) { return MapValue{}; }, {level, 1});
        EXPECT_EQ(scan.faces.size(), base.faces.size() << (2 * level));
        EXPECT_EQ(2 * scan.positions.size(), scan.faces.size()) << "of a torus";
        expect_closed(scan);
    }
}

TEST(Reconstruct, DisplacesAlongTheInterpolatedDirection) {
    const Scan scan = reconstruct(octahedron(), [](std::int32_t, const Vec3&) { return MapValue{0.5}; }, {3, 1});
    EXPECT_EQ(scan.positions.size(), 6U + 12 * 7 + 8 * 21);
    for (const Vec3& position : scan.positions) {
        EXPECT_EQ(position.lpNorm<1>(), 1.5);
    }
    for (const auto& [a, b, c] : scan.faces) {
        const Vec3& at = scan.positions[a];
        EXPECT_GT((scan.positions[b] - at).cross(scan.positions[c] - at).dot(at), 0.0) << "outward";
    }
}

// What is on an edge or a corner is displaced by the lowest face around it.
TEST(Reconstruct, AsksTheLowestFace) {
    const BaseMesh base = octahedron();
    const Scan scan = reconstruct(
        base, [](std::int32_t face, const Vec3&) -> MapValue { return {static_cast<double>(face)}; }, {1, 1});
    const std::array<double, 6> lowest{0, 1, 0, 2, 0, 4};
    for (std::size_t vertex = 0; vertex < 6; ++vertex) {
        EXPECT_EQ(scan.positions[vertex], (1 + lowest[vertex]) * base.positions[vertex]);
    }
}

/// Covered where alpha_0 of face 0, and beyond it, is at least a share.
struct CoveredCorner {
    double share;
    MapValue operator()(std::int32_t /*face*/, const Vec3& alpha) const { return {0.0, 0.5 + alpha[0] - share}; }
};

BaseMesh one_triangle() {
    BaseMesh base;
    base.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    base.directions = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    base.faces = {{0, 1, 2}};
    return base;
}

double area(const Scan& scan) {
    double sum = 0.0;
    for (const auto& [a, b, c] : scan.faces) {
        sum += 0.5 * (scan.positions[b] - scan.positions[a]).cross(scan.positions[c] - scan.positions[a]).z();
    }
    return sum;
}

TEST(Reconstruct, CutsFacesWhereTheCoverEnds) {
    for (const double share : {0.125, 0.25, 0.3, 0.75}) { // the covered corner is a triangle of 1 - share
        for (const int level : {0, 1, 3}) {
            const Scan scan = reconstruct(one_triangle(), CoveredCorner{share}, {level, 1});
            EXPECT_NEAR(area(scan), 0.5 * (1 - share) * (1 - share), 1e-8) << share << " at level " << level;
            EXPECT_FALSE(inspect(scan).defects.any());
        }
    }
    const Scan whole = reconstruct(one_triangle(), CoveredCorner{0.0}, {3, 1});
    EXPECT_EQ(whole.faces.size(), 64U);
    const Scan nothing = reconstruct(one_triangle(), CoveredCorner{1.01}, {3, 1});
    EXPECT_TRUE(nothing.faces.empty());
    EXPECT_TRUE(nothing.positions.empty());
}

// Only a corner is covered, and what is left of its faces has no area.
TEST(Reconstruct, LeavesNoFacesWithoutArea) {
    EXPECT_TRUE(reconstruct(one_triangle(), CoveredCorner{1.0}, {1, 1}).faces.empty());
}

// The cover ends on an edge at one place for both of its faces.
TEST(Reconstruct, HasOneRimWhereTheCoverEnds) {
    const BaseMesh base = octahedron();
    for (const double height : {-0.6, 0.1, 0.3}) {
        const MapValueAt cap = [&](std::int32_t face, const Vec3& alpha) -> MapValue {
            double z = 0.0;
            for (int k = 0; k < 3; ++k) {
                z += alpha[k] * base.positions[base.faces[face][k]].z();
            }
            return {0.0, 0.5 + z - height};
        };
        const Inspection inspection = inspect(reconstruct(base, cap, {3, 1}));
        EXPECT_FALSE(inspection.defects.any());
        EXPECT_EQ(inspection.topology.boundary_loops, 1U) << height;
        EXPECT_EQ(inspection.topology.euler_characteristic, 1) << height;
    }
}

// Where the lowest face at an edge covers nothing of what another one covers.
TEST(Reconstruct, IsAManifoldWhereMapsDisagree) {
    for (std::int32_t bare = 0; bare < 8; ++bare) {
        const MapValueAt but_one = [&](std::int32_t face, const Vec3&) -> MapValue {
            return {0.0, face == bare ? 0.0 : 1.0};
        };
        const Inspection inspection = inspect(reconstruct(octahedron(), but_one, {2, 1}));
        EXPECT_FALSE(inspection.defects.any()) << bare;
        EXPECT_EQ(inspection.topology.boundary_loops, 1U) << bare;
    }
}

TEST(Reconstruct, IsTheSameOnAnyNumberOfThreads) {
    const BaseMesh base = test::decimated_model(Shape::knot, 900, 100).base;
    const MapValueAt wavy = [](std::int32_t face, const Vec3& alpha) -> MapValue {
        return {0.01 * face * alpha[0] * alpha[1], alpha[2] - 0.01 * face};
    };
    const Scan first = reconstruct(base, wavy, {3, 1});
    const Scan second = reconstruct(base, wavy, {3, 3});
    EXPECT_EQ(first.positions, second.positions);
    EXPECT_EQ(first.faces, second.faces);
}

TEST(Reconstruct, RefusesSenselessOptions) {
    const MapValueAt zero = [](std::int32_t, const Vec3&) { return MapValue{}; };
    EXPECT_THROW((void)reconstruct(octahedron(), zero, {-1, 1}), std::invalid_argument);
    EXPECT_THROW((void)reconstruct(octahedron(), zero, {ReconstructOptions::max_level + 1, 1}), std::invalid_argument);
    EXPECT_THROW((void)reconstruct(octahedron(), zero, {1, 0}), std::invalid_argument);
    BaseMesh flat = octahedron();
    flat.face_directions = std::vector<Vec3>(8, Vec3(0, 0, 1));
    EXPECT_THROW((void)reconstruct(flat, zero, {1, 1}), std::invalid_argument);
}

} // namespace
} // namespace foldless
