#include <foldless/io/defects.h>

#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace foldless {
namespace {

// Points of which no three lie on one line, on the curve (i, i^2, i^3).
Scan mesh(std::vector<Triangle> faces, int vertices) {
    Scan scan;
    for (int i = 0; i < vertices; ++i) {
        scan.positions.emplace_back(i, i * i, i * i * i);
    }
    scan.faces = std::move(faces);
    return scan;
}

std::string defects_of(const std::vector<Triangle>& faces, int vertices) {
    return inspect(mesh(faces, vertices)).defects.text();
}

const std::vector<Triangle> tetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

// A strip whose ends meet with a half turn: the smallest has five faces.
const std::vector<Triangle> moebius_strip{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 0, 4}, {4, 0, 1}};

TEST(Defects, AreAbsentFromWholeMeshes) {
    EXPECT_EQ(defects_of(tetrahedron, 4), "");
    EXPECT_EQ(defects_of({{0, 1, 2}}, 3), "");
    EXPECT_EQ(defects_of({{0, 1, 2}, {2, 1, 3}}, 4), "");
    EXPECT_FALSE(inspect(mesh(tetrahedron, 4)).defects.any());
    EXPECT_NO_THROW(require_no_defects(mesh(tetrahedron, 4)));
}

TEST(Defects, CountAMeshWithoutFaces) {
    EXPECT_EQ(defects_of({}, 3), "no faces");
    EXPECT_EQ(defects_of({}, 0), "no faces");
}

TEST(Defects, CountVerticesThatAreNotFinite) {
    Scan scan = mesh(tetrahedron, 5);
    scan.positions[1].y() = NAN;
    EXPECT_EQ(inspect(scan).defects.text(), "1 vertex that is not finite");
    scan.positions[4].z() = -INFINITY;
    EXPECT_EQ(inspect(scan).defects.text(), "2 vertices that are not finite");
    scan.positions[1].y() = 1e308;
    scan.positions[4].z() = 5e-324;
    EXPECT_EQ(inspect(scan).defects.text(), "");
}

TEST(Defects, CountFacesWithAnIndexOutOfRange) {
    EXPECT_EQ(defects_of({{0, 1, 2}, {0, 1, 4}, {-1, 2, 3}}, 4), "2 faces with an index out of range");
    EXPECT_EQ(defects_of({{0, 1, 2}, {1, 0, 3}}, 4), "");
}

TEST(Defects, CountFacesWithARepeatedIndexOnce) {
    EXPECT_EQ(defects_of({{0, 1, 2}, {3, 3, 4}}, 5), "1 face with a repeated index");
    EXPECT_EQ(defects_of({{0, 1, 0}, {3, 4, 4}, {5, 5, 5}}, 6), "3 faces with a repeated index");
}

TEST(Defects, CountFacesOfExactlyNoArea) {
    Scan scan = mesh({{0, 1, 2}}, 3);
    scan.positions = {{0, 0, 0}, {0.1, 0.1, 0.1}, {0.3, 0.3, 0.3}};
    EXPECT_EQ(inspect(scan).defects.text(), "1 zero-area face");
    scan.positions[2].x() = std::nextafter(0.3, 1.0);
    EXPECT_EQ(inspect(scan).defects.text(), "");
    scan.positions[1] = scan.positions[0];
    EXPECT_EQ(inspect(scan).defects.text(), "1 zero-area face") << "two vertices at one place";
}

TEST(Defects, CountEdgesOfThreeFaces) {
    EXPECT_EQ(defects_of({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, 5), "1 non-manifold edge, 2 non-manifold vertices");
    EXPECT_EQ(defects_of({{0, 1, 2}, {1, 0, 3}, {0, 2, 4}}, 5), "");
}

// Two tetrahedra that share an edge: four faces at it, two of each.
TEST(Defects, CountEdgesOfFourFaces) {
    std::vector<Triangle> faces = tetrahedron;
    for (const Triangle& face : tetrahedron) {
        faces.push_back({face[0] < 2 ? face[0] : face[0] + 2, face[1] < 2 ? face[1] : face[1] + 2,
                         face[2] < 2 ? face[2] : face[2] + 2});
    }
    EXPECT_EQ(defects_of(faces, 6), "1 non-manifold edge, 2 non-manifold vertices");
}

TEST(Defects, CountADoubledFaceAtItsEdges) {
    std::vector<Triangle> faces = tetrahedron;
    faces.push_back(faces[0]);
    EXPECT_EQ(defects_of(faces, 4), "3 non-manifold edges, 3 non-manifold vertices");
}

TEST(Defects, CountEdgesThatBothFacesRunAlongInOneDirection) {
    EXPECT_EQ(defects_of({{0, 1, 2}, {0, 1, 3}}, 4), "1 inconsistently oriented edge");
    EXPECT_EQ(defects_of({{0, 1, 2}, {1, 0, 3}}, 4), "");
    std::vector<Triangle> faces = tetrahedron;
    std::swap(faces[2][0], faces[2][1]);
    EXPECT_EQ(defects_of(faces, 4), "3 inconsistently oriented edges") << "one face is turned over";
}

// Two triangles, then two closed surfaces, that meet in one vertex.
TEST(Defects, CountBowTies) {
    EXPECT_EQ(defects_of({{0, 1, 2}, {0, 3, 4}}, 5), "1 non-manifold vertex");
    EXPECT_EQ(defects_of({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}, 5), "") << "a fan";
    std::vector<Triangle> faces = tetrahedron;
    for (const Triangle& face : tetrahedron) {
        faces.push_back({face[0] + 3, face[1] + 3, face[2] + 3});
    }
    EXPECT_EQ(defects_of(faces, 7), "1 non-manifold vertex");
}

// A closed fan around a vertex, and an open one beside it.
TEST(Defects, CountAClosedFanBesideAnOpenOne) {
    EXPECT_EQ(defects_of({{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 4, 5}}, 6), "1 non-manifold vertex");
    EXPECT_EQ(defects_of({{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}, 6), "");
}

TEST(Defects, CountPartsThatCannotBeOriented) {
    EXPECT_EQ(defects_of(moebius_strip, 5), "1 inconsistently oriented edge, 1 non-orientable component");
    std::vector<Triangle> two = moebius_strip;
    for (const Triangle& face : moebius_strip) {
        two.push_back({face[0] + 5, face[1] + 5, face[2] + 5});
    }
    EXPECT_EQ(defects_of(two, 10), "2 inconsistently oriented edges, 2 non-orientable components");
    // A strip that is closed without the half turn.
    EXPECT_EQ(defects_of({{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4}, {2, 0, 5}, {0, 3, 5}}, 6), "");
}

// The projective plane on six vertices: closed, and every edge has two faces.
TEST(Defects, CountTheProjectivePlane) {
    const std::vector<Triangle> faces{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                                      {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
    const Inspection found = inspect(mesh(faces, 6));
    EXPECT_EQ(found.defects.non_orientable_components, 1U);
    EXPECT_EQ(found.defects.non_manifold_edges, 0U);
    EXPECT_EQ(found.defects.non_manifold_vertices, 0U);
    EXPECT_EQ(found.topology.euler_characteristic, 1);
}

TEST(Defects, RefuseWithAllCounts) {
    const Scan scan = mesh({{0, 1, 2}, {0, 1, 3}, {3, 3, 4}, {5, 6, 99}}, 7);
    EXPECT_EQ(message_of<RefusedMesh>([&] { require_no_defects(scan); }),
              "1 face with an index out of range, 1 face with a repeated index, 1 inconsistently oriented edge");
}

TEST(Defects, DoNotDependOnTheOrderOfFacesCornersAndVertices) {
    std::vector<Triangle> faces = moebius_strip;
    faces.insert(faces.end(), {{5, 6, 7}, {6, 5, 8}, {5, 6, 9}, {5, 10, 11}, {2, 2, 3}, {12, 13, 14}, {12, 13, 15}});
    const Inspection expected = inspect(mesh(faces, 17));
    std::mt19937 random(7);
    for (int round = 0; round < 50; ++round) {
        std::vector<std::int32_t> renumbered(17);
        std::iota(renumbered.begin(), renumbered.end(), 0);
        std::shuffle(renumbered.begin(), renumbered.end(), random);
        std::shuffle(faces.begin(), faces.end(), random);
        std::vector<Triangle> changed = faces;
        for (Triangle& face : changed) {
            std::rotate(face.begin(), face.begin() + random() % 3, face.end());
            for (std::int32_t& vertex : face) {
                vertex = renumbered[static_cast<std::size_t>(vertex)];
            }
        }
        const Inspection found = inspect(mesh(changed, 17));
        EXPECT_EQ(found.defects.text(), expected.defects.text());
        EXPECT_EQ(found.topology.components, expected.topology.components);
        EXPECT_EQ(found.topology.boundary_edges, expected.topology.boundary_edges);
    }
}

TEST(Topology, OfASphereATorusADiskAndAnAnnulus) {
    const Topology sphere = inspect(mesh(tetrahedron, 4)).topology;
    EXPECT_EQ(sphere.euler_characteristic, 2);
    EXPECT_EQ(sphere.boundary_loops, 0U);

    // Seven vertices, fourteen faces: the smallest torus.
    std::vector<Triangle> torus;
    for (std::int32_t i = 0; i < 7; ++i) {
        torus.push_back({i, (i + 1) % 7, (i + 3) % 7});
        torus.push_back({i, (i + 3) % 7, (i + 2) % 7});
    }
    const Inspection on_torus = inspect(mesh(torus, 7));
    EXPECT_EQ(on_torus.defects.text(), "");
    EXPECT_EQ(on_torus.topology.euler_characteristic, 0);

    const Topology disk = inspect(mesh({{0, 1, 2}, {0, 2, 3}}, 4)).topology;
    EXPECT_EQ(disk.euler_characteristic, 1);
    EXPECT_EQ(disk.boundary_loops, 1U);
    EXPECT_EQ(disk.boundary_edges, 4U);

    const Topology annulus =
        inspect(mesh({{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4}, {2, 0, 5}, {0, 3, 5}}, 6)).topology;
    EXPECT_EQ(annulus.euler_characteristic, 0);
    EXPECT_EQ(annulus.boundary_loops, 2U);
    EXPECT_EQ(annulus.boundary_edges, 6U);
}

TEST(Topology, CountsPartsAndUnusedVertices) {
    const Topology topology = inspect(mesh({{0, 1, 2}, {4, 5, 6}, {6, 5, 7}}, 9)).topology;
    EXPECT_EQ(topology.components, 2U);
    EXPECT_EQ(topology.unused_vertices, 2U);
    EXPECT_EQ(topology.boundary_loops, 2U);
    EXPECT_EQ(topology.euler_characteristic, 2);
}

} // namespace
} // namespace foldless
