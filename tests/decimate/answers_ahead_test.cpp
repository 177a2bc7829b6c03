#include <foldless/decimate/answers_ahead.h>

#include "made_scans.h"

#include <foldless/decimate/commit.h>
#include <foldless/decimate/edge_order.h>
#include <foldless/decimate/vertex_directions.h>
#include <foldless/predicates/default_arithmetic.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tbb/task_arena.h>

#include <algorithm>
#include <tuple>
#include <vector>

namespace foldless {
namespace {

using test::bumpy_sphere;
using test::terrain;
using test::torus;

/// The state of a loop over a scan.
class Loop {
public:
    Loop(const Scan& scan, const DecimateOptions& options)
        : options_(options), prepared_(scan), base_(scan), mobility_(scan.positions.size(), Mobility::free),
          quadrics_(scan, prepared_.topology(), Vec3::Zero()), queue_(all_edges(base_)) {
        for (std::size_t v = 0; v < scan.positions.size(); ++v) {
            const auto vertex = static_cast<std::int32_t>(v);
            Vec3 sum = Vec3::Zero();
            for (const std::int32_t f : prepared_.topology().faces_around(vertex)) {
                sum += prepared_.normal(f).value();
            }
            base_.set_direction(vertex, stored_direction(sum.normalized()));
            mobility_[v] = base_.is_border_vertex(vertex) ? Mobility::fixed : Mobility::free;
        }
    }

    [[nodiscard]] AskedState state() const {
        return {&prepared_, &base_, &mobility_, &quadrics_, &options_, Vec3::Zero(), 1e-5, false};
    }
    [[nodiscard]] EdgeQueue& queue() { return queue_; }

    /// The faces around the corners of those that a patch takes away: what a scan vertex beside it may be on.
    [[nodiscard]] std::vector<std::int32_t> around(const Patch& patch) const {
        std::vector<std::int32_t> faces;
        for (const std::int32_t face : patch.removed) {
            for (const std::int32_t v : base_.corners(face)) {
                base_.append_faces_around(v, faces);
            }
        }
        return faces;
    }

    void commit(const EdgeAnswer& answer) {
        std::vector<std::int32_t> edges;
        edges_changed_by(base_, answer.collapse, answer.extent, edges);
        commit_collapse(base_, answer.collapse, answer.patch, answer.trial);
        quadrics_.merge(answer.collapse.stays, answer.collapse.gone);
        requeue(base_, answer.collapse.stays, edges, queue_);
    }

private:
    DecimateOptions options_;
    PreparedScan prepared_;
    BaseSurface base_;
    std::vector<Mobility> mobility_;
    VertexQuadrics quadrics_;
    EdgeQueue queue_;
};

void expect_same(const Trial& a, const Trial& b) {
    ASSERT_EQ(a.faces.size(), b.faces.size());
    for (std::size_t n = 0; n < a.faces.size(); ++n) {
        EXPECT_EQ(std::tie(a.faces[n].range.lo, a.faces[n].range.hi, a.faces[n].scan_faces, a.faces[n].is_scan_face),
                  std::tie(b.faces[n].range.lo, b.faces[n].range.hi, b.faces[n].scan_faces, b.faces[n].is_scan_face));
    }
    ASSERT_EQ(a.places.size(), b.places.size());
    for (std::size_t n = 0; n < a.places.size(); ++n) {
        EXPECT_EQ(std::tie(a.places[n].scan_vertex, a.places[n].face, a.places[n].alpha, a.places[n].t),
                  std::tie(b.places[n].scan_vertex, b.places[n].face, b.places[n].alpha, b.places[n].t));
    }
}

void expect_same(const EdgeAnswer& a, const EdgeAnswer& b) {
    ASSERT_EQ(a.accepted, b.accepted);
    EXPECT_EQ(a.refused, b.refused);
    EXPECT_EQ(a.refused_between_vertices, b.refused_between_vertices);
    EXPECT_EQ(a.retested_vertices, b.retested_vertices);
    if (!a.accepted) {
        return;
    }
    EXPECT_EQ(a.collapse.halfedge, b.collapse.halfedge);
    EXPECT_EQ(a.extent, b.extent);
    EXPECT_EQ(a.patch.removed, b.patch.removed);
    ASSERT_EQ(a.patch.changed.size(), b.patch.changed.size());
    for (std::size_t n = 0; n < a.patch.changed.size(); ++n) {
        EXPECT_EQ(a.patch.changed[n].value.position, b.patch.changed[n].value.position);
        EXPECT_EQ(a.patch.changed[n].value.direction, b.patch.changed[n].value.direction);
    }
    expect_same(a.trial, b.trial);
}

std::vector<std::int32_t> distinct(std::vector<std::int32_t> faces) {
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
}

/// Runs the loop to its end and asks every edge again when it is its turn, from nothing.
void expect_answers_ahead_to_stand(const Scan& scan, const DecimateOptions& options, int threads) {
    const DefaultArithmetic arithmetic;
    tbb::task_arena arena(threads);
    arena.execute([&] {
        Loop loop(scan, options);
        AnswersAhead answers(loop.state());
        std::size_t accepted = 0;
        while (const std::optional<std::int32_t> edge = loop.queue().pop()) {
            const EdgeAnswer& answer = answers.answer(*edge, loop.queue());
            EdgeAnswer now;
            EdgeAsker(loop.state()).ask(*edge, now);
            expect_same(answer, now);
            if (::testing::Test::HasFailure()) {
                return;
            }
            if (answer.accepted) {
                EXPECT_THAT(distinct(answer.read), testing::IsSupersetOf(distinct(loop.around(answer.patch))));
                ++accepted;
                answers.about_to_change(answer.patch);
                loop.commit(answer);
            } else {
                loop.queue().refuse(*edge);
            }
        }
        EXPECT_GT(8 * accepted, scan.positions.size()) << "else little was asked";
    });
}

TEST(AnswersAhead, AreThoseOfTheMomentWhenTheyAreUsed) {
    const DecimateOptions options;
    for (const int threads : {1, 2, 7}) {
        expect_answers_ahead_to_stand(bumpy_sphere(3), options, threads);
        expect_answers_ahead_to_stand(torus(16, 8), options, threads);
        expect_answers_ahead_to_stand(terrain(14, 0.1), options, threads);
    }
}

TEST(AnswersAhead, AreThoseOfTheMomentWhereTheFacesBesideAPatchDecide) {
    expect_answers_ahead_to_stand(terrain(24, 0.6), {}, 16);
}

TEST(AnswersAhead, AreThoseOfTheMomentWhereTwoRingsChange) {
    DecimateOptions options = paper_options();
    options.edge_valence_limit = 20;
    expect_answers_ahead_to_stand(bumpy_sphere(3), options, 5);
}

TEST(AnswersAhead, AreThoseOfTheMomentOverATrimmedBorder) {
    DecimateOptions options;
    options.boundary = Boundary::trim;
    expect_answers_ahead_to_stand(terrain(12, 0.1), options, 5);
}

} // namespace
} // namespace foldless
