#include <foldless/decimate/base_surface.h>

#include "made_scans.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <vector>

namespace foldless {
namespace {

using test::pyramid;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

TEST(BaseSurface, StartsAsTheScan) {
    const Scan scan = pyramid({0.4, 0.7, 0.3});
    const BaseSurface base(scan);
    ASSERT_EQ(base.face_slots(), 4);
    for (std::int32_t f = 0; f < 4; ++f) {
        EXPECT_THAT(base.corners(f), UnorderedElementsAre(scan.faces[f][0], scan.faces[f][1], scan.faces[f][2]));
        EXPECT_THAT(base.face(f).scan_faces, ElementsAre(f));
    }
    for (std::int32_t v = 0; v < 5; ++v) {
        EXPECT_EQ(base.vertex(v).position, scan.positions[v]);
        EXPECT_EQ(base.vertex(v).scan_vertex, v);
        EXPECT_EQ(base.place(v).kept, v);
    }
}

TEST(BaseSurface, KnowsTheFaceAcrossEachEdge) {
    const Scan scan = test::torus(5, 4);
    const BaseSurface base(scan);
    for (std::int32_t f = 0; f < static_cast<std::int32_t>(base.face_slots()); ++f) {
        const Triangle corners = base.corners(f);
        for (int k = 0; k < 3; ++k) {
            const Triangle across = base.corners(base.neighbour(f, k));
            EXPECT_EQ(std::count(across.begin(), across.end(), corners[k]), 0);
            EXPECT_EQ(std::count(across.begin(), across.end(), corners[(k + 1) % 3]), 1);
            EXPECT_EQ(std::count(across.begin(), across.end(), corners[(k + 2) % 3]), 1);
        }
    }
}

TEST(BaseSurface, GoesAroundAVertexCounterClockwise) {
    const Scan scan = test::terrain(3, 0.1);
    const BaseSurface base(scan);
    std::vector<std::int32_t> around;
    for (std::int32_t v = 0; v < static_cast<std::int32_t>(base.vertex_slots()); ++v) {
        around.clear();
        base.append_faces_around(v, around);
        ASSERT_FALSE(around.empty());
        const std::size_t steps = base.is_border_vertex(v) ? around.size() - 1 : around.size();
        for (std::size_t n = 0; n < steps; ++n) {
            const Triangle corners = base.corners(around[n]);
            const auto k = std::find(corners.begin(), corners.end(), v) - corners.begin();
            EXPECT_EQ(base.neighbour(around[n], static_cast<int>(k + 1) % 3), around[(n + 1) % around.size()]);
        }
    }
}

// A pyramid: vertex 4 is the top.
class APyramid : public testing::Test {
protected:
    Scan scan_ = pyramid({0.4, 0.7, 0.3});
    BaseSurface base_{scan_};
};

TEST_F(APyramid, RemembersAVertexThatMoved) {
    base_.set_vertex(4, {Vec3(0.1, 0.2, 0.3), Vec3(0, 0.5, 1), -1});
    EXPECT_EQ(base_.vertex(4).position, Vec3(0.1, 0.2, 0.3));
    EXPECT_EQ(base_.vertex(4).direction, Vec3(0, 0.5, 1));
    EXPECT_EQ(base_.vertex(4).scan_vertex, -1);
    base_.set_vertex(4, {Vec3(0.4, 0.2, 0.3), Vec3(0, 0.5, 1), -1});
    EXPECT_EQ(base_.vertex(4).position, Vec3(0.4, 0.2, 0.3));
}

TEST_F(APyramid, RemembersThatAVertexIsNotKeptThoughItHasNotMoved) {
    base_.set_vertex(4, {scan_.positions[4], Vec3(0, 0, 1), -1});
    EXPECT_EQ(base_.vertex(4).position, scan_.positions[4]);
    EXPECT_EQ(base_.vertex(4).scan_vertex, -1);
}

TEST_F(APyramid, KeepsPositionsApartWhereVerticesGo) {
    base_.set_vertex(0, {Vec3(1, 2, 3), Vec3(0, 0, 1), -1});
    base_.set_vertex(1, {Vec3(4, 5, 6), Vec3(0, 0, 1), -1});
    base_.drop_vertex(0);
    base_.set_vertex(2, {Vec3(7, 8, 9), Vec3(0, 0, 1), -1});
    base_.set_vertex(3, {Vec3(10, 11, 12), Vec3(0, 0, 1), -1});
    EXPECT_EQ(base_.vertex(1).position, Vec3(4, 5, 6));
    EXPECT_EQ(base_.vertex(2).position, Vec3(7, 8, 9));
    EXPECT_EQ(base_.vertex(3).position, Vec3(10, 11, 12));
}

TEST_F(APyramid, RemembersWhatAFaceIs) {
    const std::vector<std::int32_t> scan_faces{2, 0, 3};
    base_.set_face(1, {{-0.5, 0.25}, scan_faces, -1, false});
    EXPECT_EQ(base_.face(1).range.lo, -0.5);
    EXPECT_EQ(base_.face(1).range.hi, 0.25);
    EXPECT_THAT(base_.face(1).scan_faces, ElementsAre(2, 0, 3));
    EXPECT_FALSE(base_.face(1).is_scan_face);
    EXPECT_THAT(base_.face(0).scan_faces, ElementsAre(0));
    EXPECT_TRUE(base_.face(0).is_scan_face);
    base_.clear_face(1);
    EXPECT_THAT(base_.face(1).scan_faces, IsEmpty());
    EXPECT_EQ(base_.face(1).first_vertex, -1);
}

TEST_F(APyramid, ChainsTheScanVerticesOfAFace) {
    base_.clear_face(1);
    base_.set_place(4, 1, Vec3(0.25, 0.25, 0.5), 0.125);
    base_.set_place(2, 1, Vec3(0.5, 0.25, 0.25), -1.0);
    EXPECT_EQ(base_.face(1).first_vertex, 2);
    EXPECT_EQ(base_.next_on_face(2), 4);
    EXPECT_EQ(base_.next_on_face(4), -1);
    EXPECT_EQ(base_.place(4).face, 1);
    EXPECT_EQ(base_.place(4).kept, -1);
    EXPECT_EQ(base_.place(4).alpha, Vec3(0.25, 0.25, 0.5));
    EXPECT_EQ(base_.place(4).t, 0.125);
}

TEST_F(APyramid, GivesAScanVertexItsLastPlace) {
    base_.clear_face(1);
    base_.set_place(4, 1, Vec3(0.25, 0.25, 0.5), 0.125);
    base_.clear_face(1);
    base_.clear_face(2);
    base_.set_place(4, 2, Vec3(0.5, 0.25, 0.25), 0.25);
    EXPECT_EQ(base_.place(4).face, 2);
    EXPECT_EQ(base_.place(4).t, 0.25);
    EXPECT_EQ(base_.face(1).first_vertex, -1);
    EXPECT_EQ(base_.face(2).first_vertex, 4);
}

/// What is left of a surface, by the numbers that it had at the start.
struct FaceAsItIs {
    std::int32_t first_number;
    Triangle corners;
    std::array<std::int32_t, 3> across; ///< or -1
    std::vector<std::int32_t> scan_faces;
    std::vector<std::int32_t> scan_vertices;
    bool is_scan_face;
    bool operator==(const FaceAsItIs&) const = default;
};
std::vector<FaceAsItIs> faces_of(const BaseSurface& base) {
    std::vector<FaceAsItIs> faces;
    for (const auto handle : base.connectivity().faces()) {
        const std::int32_t f = handle.idx();
        const BaseFace face = base.face(f);
        FaceAsItIs as_it_is{base.first_number(f), base.corners(f), {-1, -1, -1}, {}, {}, face.is_scan_face};
        as_it_is.scan_faces.assign(face.scan_faces.begin(), face.scan_faces.end());
        for (int k = 0; k < 3; ++k) {
            const std::int32_t across = base.neighbour(f, k);
            as_it_is.across[k] = across < 0 ? -1 : base.first_number(across);
        }
        for (std::int32_t v = face.first_vertex; v >= 0; v = base.next_on_face(v)) {
            EXPECT_EQ(base.place(v).face, f);
            as_it_is.scan_vertices.push_back(v);
        }
        faces.push_back(as_it_is);
    }
    return faces;
}

/// Collapses so many edges, wherever it can, but for those to the border.
void collapse_some(BaseSurface& base, int count) {
    Connectivity& mesh = base.connectivity();
    for (const auto halfedge : mesh.halfedges()) {
        if (count == 0 || mesh.status(mesh.edge_handle(halfedge)).deleted() || halfedge.from().is_boundary() ||
            !mesh.is_collapse_ok(halfedge)) {
            continue;
        }
        --count;
        const std::int32_t gone = halfedge.from().idx();
        const std::int32_t there = halfedge.face().idx();
        const std::int32_t beside = mesh.opposite_face_handle(halfedge).idx();
        const std::int32_t next = mesh.opposite_face_handle(halfedge.next()).idx();
        mesh.collapse(halfedge);
        base.drop_vertex(gone);
        base.clear_face(there);
        base.clear_face(beside);
        base.set_face(next, {{-1, 1}, std::vector<std::int32_t>{there, beside, next}, -1, false});
        base.set_place(gone, next, Vec3(0.5, 0.25, 0.25), 1.0);
    }
}

TEST(BaseSurface, IsTheSameWithoutGaps) {
    const Scan scan = test::torus(8, 7);
    BaseSurface base(scan);
    for (int round = 0; round < 3; ++round) { // the second time numbers are not those of the start any more
        collapse_some(base, 8);
        const std::vector<FaceAsItIs> before = faces_of(base);
        const std::size_t edges = base.connectivity().n_edges();
        base.close_gaps(number_what_is_left(base.connectivity()));
        EXPECT_EQ(faces_of(base), before) << "round " << round;
        EXPECT_EQ(base.face_slots(), before.size());
        EXPECT_EQ(base.connectivity().n_faces(), before.size());
        EXPECT_LT(base.connectivity().n_edges(), edges);
        EXPECT_EQ(2 * base.connectivity().n_edges(), 3 * before.size()); // closed
    }
}

TEST(BaseSurface, GoesAroundVerticesOfABorderAsBeforeWithoutGaps) {
    const Scan scan = test::terrain(6, 0.1);
    BaseSurface base(scan);
    collapse_some(base, 6);
    const auto fans = [&] {
        std::vector<std::vector<std::int32_t>> result;
        for (std::int32_t v = 0; v < static_cast<std::int32_t>(base.vertex_slots()); ++v) {
            std::vector<std::int32_t>& fan = result.emplace_back();
            if (!base.connectivity().status(OpenMesh::VertexHandle(v)).deleted()) {
                base.append_faces_around(v, fan);
            }
            std::transform(fan.begin(), fan.end(), fan.begin(), [&](std::int32_t f) { return base.first_number(f); });
        }
        return result;
    };
    const auto before = fans();
    base.close_gaps(number_what_is_left(base.connectivity()));
    EXPECT_EQ(fans(), before);
}

} // namespace
} // namespace foldless
