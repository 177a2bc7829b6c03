#include "made_scans.h"
#include "validator_world.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <vector>

namespace foldless {
namespace {

using test::pyramid;
using test::World;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

constexpr int any_valence = 1000;

/// make_collapse() of the edge between two vertices, the listed vertices being fixed.
struct Asked {
    Verdict verdict;
    Collapse collapse;
};

Asked ask(World& world, std::int32_t a, std::int32_t b, const std::vector<std::int32_t>& fixed = {},
          int valence_limit = any_valence) {
    std::vector<Mobility> mobility(world.scan().positions.size(), Mobility::free);
    for (const std::int32_t v : fixed) {
        mobility[v] = Mobility::fixed;
    }
    Asked asked{};
    asked.verdict = make_collapse(world.base(), world.edge(a, b), {mobility, valence_limit, true}, asked.collapse);
    return asked;
}

/// Two tetrahedra on both sides of the triangle 0, 1, 2.
Scan triangular_bipyramid() {
    return {{{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {0, 0, 1}, {0, 0, -1}},
            {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}}};
}

// Vertices 0, 1, 2 make a triangle that is no face: an edge of it cannot go without pinching the surface.
TEST(MakeCollapse, RefusesAnEdgeOfATriangleThatIsNoFace) {
    World world(triangular_bipyramid());
    EXPECT_EQ(ask(world, 0, 1).verdict, Verdict::link_condition);
    EXPECT_EQ(ask(world, 0, 3).verdict, Verdict::accepted); // its vertex of valence 3 may go
}

TEST(MakeCollapse, AcceptsTheEdgesOfAnOctahedron) {
    World world(test::bumpy_sphere(0));
    EXPECT_EQ(ask(world, 0, 2).verdict, Verdict::accepted);
}

TEST(MakeCollapse, RefusesAnEdgeBesideAVertexOfMoreThanAThousandEdges) {
    World world(test::spindle(most_edges_at_a_vertex, 1));
    EXPECT_EQ(ask(world, 2, 3).verdict, Verdict::accepted);
    World crowded(test::spindle(most_edges_at_a_vertex + 1, 1));
    EXPECT_EQ(ask(crowded, 2, 3).verdict, Verdict::valence);
}

TEST(MakeCollapse, RefusesAnInnerEdgeBetweenBorderVertices) {
    Scan scan = pyramid({0, 0, 0});
    scan.faces = {{0, 1, 2}, {0, 2, 3}};
    scan.positions.pop_back();
    World world(scan);
    EXPECT_EQ(ask(world, 0, 2).verdict, Verdict::boundary);
}

TEST(MakeCollapse, RefusesAnEdgeOfALockedBorder) {
    World world(pyramid({0.4, 0.7, 0.3}));
    EXPECT_EQ(ask(world, 0, 1, {0, 1, 2, 3}).verdict, Verdict::boundary);
    EXPECT_EQ(ask(world, 0, 4, {0, 1, 2, 3}).verdict, Verdict::accepted);
}

TEST(MakeCollapse, RefusesAnEdgeBetweenFixedInnerVertices) {
    World world(test::bumpy_sphere(1));
    const Triangle& face = world.scan().faces[0];
    EXPECT_EQ(ask(world, face[0], face[1], {face[0], face[1]}).verdict, Verdict::frozen);
    EXPECT_EQ(ask(world, face[0], face[1], {face[0], face[2]}).verdict, Verdict::accepted);
}

TEST(MakeCollapse, RefusesAtTheValenceLimitAndAcceptsBelow) {
    World world(test::bumpy_sphere(0)); // every vertex has valence 4
    EXPECT_EQ(ask(world, 0, 2, {}, 7).verdict, Verdict::valence);
    EXPECT_EQ(ask(world, 0, 2, {}, 8).verdict, Verdict::accepted);
}

TEST(MakeCollapse, LetsTheFixedEndStay) {
    World world(test::bumpy_sphere(0));
    for (const std::int32_t fixed : {0, 2}) {
        const Asked asked = ask(world, 0, 2, {fixed});
        EXPECT_EQ(asked.verdict, Verdict::accepted);
        EXPECT_EQ(asked.collapse.stays, fixed);
        EXPECT_EQ(asked.collapse.gone, 2 - fixed);
    }
}

TEST(MakeCollapse, LetsTheBorderVertexStay) {
    World world(pyramid({0.4, 0.7, 0.3}));
    for (const std::int32_t corner : {0, 1, 2, 3}) {
        EXPECT_EQ(ask(world, corner, 4).collapse.stays, corner);
    }
}

TEST(MakeCollapse, NamesTheEndsOfItsHalfedge) {
    World world(test::bumpy_sphere(0));
    const Collapse collapse = ask(world, 0, 2).collapse;
    const Collapse back = reversed(world.base(), collapse);
    EXPECT_EQ(back.gone, collapse.stays);
    EXPECT_EQ(back.stays, collapse.gone);
    EXPECT_EQ(world.base().connectivity().from_vertex_handle(back.halfedge).idx(), back.gone);
    EXPECT_EQ(reversed(world.base(), back).halfedge, collapse.halfedge);
}

TEST(FillFaces, TakesTheStarsAndDropsTheTwoFacesOfTheEdge) {
    World world(pyramid({0.4, 0.7, 0.3}));
    Patch patch;
    fill_faces(world.base(), world.collapse(4, 0), Extent::both_stars, patch);
    EXPECT_THAT(patch.removed, ElementsAre(0, 1, 2, 3));
    ASSERT_EQ(patch.added.size(), 2);
    EXPECT_THAT((std::vector{patch.added[0].slot, patch.added[1].slot}), ElementsAre(1, 2));
    EXPECT_THAT(patch.added[0].corners, UnorderedElementsAre(0, 1, 2));
    EXPECT_THAT(patch.added[1].corners, UnorderedElementsAre(0, 2, 3));
}

TEST(FillFaces, TakesOneStarWhereTheOtherVertexStaysAsItIs) {
    World world(test::terrain(6, 0.0));
    Patch patch;
    fill_faces(world.base(), world.collapse(24, 25), Extent::star_of_gone, patch);
    EXPECT_EQ(patch.removed.size(), 6);
    EXPECT_EQ(patch.added.size(), 4);
    for (const PatchFace& face : patch.added) {
        EXPECT_THAT(face.corners, testing::Contains(25));
        EXPECT_THAT(face.corners, testing::Not(testing::Contains(24)));
    }
}

// Places count the corners, so OpenMesh must not turn them; here the first corner is each in turn.
TEST(CommitCollapse, LeavesTheCornersOfEveryFaceInTheirOrder) {
    Scan scan = test::terrain(6, 0.05);
    for (std::size_t v = 0; v < scan.positions.size(); ++v) { // no scan edge through a base vertex
        const auto angle = static_cast<double>(v * v);
        scan.positions[v] += 0.03 * Vec3(std::sin(angle), std::cos(angle), 0);
    }
    int accepted = 0;
    for (int turns = 0; turns < 3; ++turns) {
        for (const auto& [gone, stays] : {std::pair{24, 25}, {25, 24}, {24, 31}, {31, 24}, {24, 32}, {32, 24}}) {
            World world(scan);
            Patch patch;
            fill_faces(world.base(), world.collapse(gone, stays), Extent::star_of_gone, patch);
            patch.changed.push_back({gone, world.base().vertex(gone)});
            patch.changed[0].value.scan_vertex = -1;
            if (world.judge(patch) != Verdict::accepted) {
                continue;
            }
            ++accepted;
            std::vector<Triangle> before;
            for (std::size_t f = 0; f < scan.faces.size(); ++f) {
                before.push_back(world.base().corners(static_cast<std::int32_t>(f)));
            }
            world.commit_collapse(gone, stays, patch);
            for (std::size_t f = 0; f < before.size(); ++f) {
                const auto face = static_cast<std::int32_t>(f);
                if (!std::binary_search(patch.removed.begin(), patch.removed.end(), face)) {
                    EXPECT_EQ(world.base().corners(face), before[f]) << "face " << f;
                }
            }
            for (const PatchFace& face : patch.added) {
                EXPECT_EQ(world.base().corners(face.slot), face.corners);
            }
        }
        for (Triangle& face : scan.faces) {
            std::rotate(face.begin(), face.begin() + 1, face.end());
        }
    }
    EXPECT_GE(accepted, 12);
}

TEST(FillFaces, TakesTheRingOfTheRimToo) {
    World world(test::terrain(6, 0.0));
    const Collapse inner = world.collapse(24, 25); // near the middle of 7 * 7 vertices
    Patch stars;
    Patch rings;
    fill_faces(world.base(), inner, Extent::both_stars, stars);
    fill_faces(world.base(), inner, Extent::two_rings, rings);
    EXPECT_EQ(stars.removed.size(), 10);
    EXPECT_EQ(stars.added.size(), 8);
    EXPECT_EQ(rings.removed.size() - rings.added.size(), 2);
    EXPECT_GT(rings.removed.size(), stars.removed.size());
    std::vector<std::int32_t> rim;
    rim_of(world.base(), inner, rim);
    EXPECT_EQ(rim.size(), 8);
    for (const std::int32_t v : rim) {
        std::vector<std::int32_t> around;
        around.clear();
        world.base().append_faces_around(v, around);
        for (const std::int32_t f : around) {
            EXPECT_TRUE(std::binary_search(rings.removed.begin(), rings.removed.end(), f));
        }
    }
}

/// The verdict on the collapse of 4 into 0 of a flat pyramid when vertex 0 moves to the given place.
Verdict guarded(const Vec3& place) {
    World world(pyramid({0.5, 0.5, 0}));
    Patch patch = world.collapse_patch(4, 0);
    patch.changed.push_back(test::moved(0, place));
    return guard_faces(world.base(), patch);
}

TEST(GuardFaces, RefusesAFaceWithoutArea) {
    EXPECT_EQ(guarded({1, 0.25, 0}), Verdict::degenerate); // on the edge 1-2
    EXPECT_EQ(guarded({0.875, 0.25, 0}), Verdict::accepted);
}

TEST(GuardFaces, RefusesACoordinateThatIsNotFinite) {
    EXPECT_EQ(guarded({std::numeric_limits<double>::quiet_NaN(), 0, 0}), Verdict::degenerate);
    EXPECT_EQ(guarded({0, -std::numeric_limits<double>::infinity(), 0}), Verdict::degenerate);
}

TEST(GuardFaces, RefusesAFaceThatTurnsOver) {
    EXPECT_EQ(guarded({1.125, 0.5, 0}), Verdict::flip); // beyond the edge 1-2
    EXPECT_EQ(guarded({0.875, 0.5, 0}), Verdict::accepted);
}

TEST(GuardFaces, RefusesAFaceThatTurnsByARightAngle) {
    EXPECT_EQ(guarded({1, 0.5, 1}), Verdict::flip); // the face with 1-2 stands upright
    EXPECT_EQ(guarded({0.875, 0.5, 1}), Verdict::accepted);
}

/// Collapses one halfedge after the other, the n-th of those that OpenMesh allows, and compares all in between.
void expect_link_condition_of_openmesh(const Scan& scan, std::size_t n) {
    World world(scan);
    Connectivity& mesh = world.base().connectivity();
    const std::vector<Mobility> mobility(scan.positions.size(), Mobility::free);
    for (;;) {
        std::vector<OpenMesh::HalfedgeHandle> allowed;
        for (const auto edge : mesh.edges()) {
            Collapse collapse;
            const Verdict verdict = make_collapse(world.base(), edge.idx(), {mobility, 1000, false}, collapse);
            if (verdict == Verdict::boundary) {
                continue; // not asked then
            }
            const bool is_ok = mesh.is_collapse_ok(collapse.halfedge);
            ASSERT_TRUE(is_ok || verdict == Verdict::link_condition) << edge.idx();
            // OpenMesh does not see a closed component of four faces.
            const bool is_tetrahedron = mesh.valence(OpenMesh::VertexHandle(collapse.gone)) == 3 &&
                                        mesh.valence(OpenMesh::VertexHandle(collapse.stays)) == 3;
            ASSERT_TRUE(!is_ok || is_tetrahedron || verdict == Verdict::accepted) << edge.idx();
            if (verdict == Verdict::accepted) {
                allowed.push_back(collapse.halfedge);
            }
        }
        if (allowed.empty()) {
            return;
        }
        mesh.collapse(allowed[n % allowed.size()]);
    }
}

TEST(MakeCollapse, AsksTheLinkConditionAsOpenMeshDoes) {
    for (std::size_t n : {0, 7, 1000003}) {
        expect_link_condition_of_openmesh(test::terrain(6, 0.1), n);
        expect_link_condition_of_openmesh(test::torus(8, 5), n);
        expect_link_condition_of_openmesh(test::bumpy_sphere(1), n);
    }
}

} // namespace
} // namespace foldless
