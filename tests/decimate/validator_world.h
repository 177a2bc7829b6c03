/// \file
/// A scan with its base mesh and a validator, for patches made by hand.
#pragma once

#include <foldless/decimate/commit.h>
#include <foldless/decimate/validator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <ostream>
#include <utility>
#include <vector>

namespace foldless {

/// GoogleTest prints verdicts by name.
inline void PrintTo(Verdict verdict, std::ostream* out) {
    *out << name(verdict);
}

} // namespace foldless

namespace foldless::test {

/// The scan as its own base mesh, all directions the same until a test sets others.
class World {
public:
    explicit World(Scan scan, const Vec3& direction = Vec3::UnitZ())
        : scan_(std::move(scan)), prepared_(scan_), base_(scan_) {
        for (std::size_t v = 0; v < base_.vertex_slots(); ++v) {
            base_.set_direction(static_cast<std::int32_t>(v), direction);
        }
    }

    [[nodiscard]] const Scan& scan() const { return scan_; }
    [[nodiscard]] const PreparedScan& prepared() const { return prepared_; }
    [[nodiscard]] const ScanTopology& topology() const { return prepared_.topology(); }
    [[nodiscard]] BaseSurface& base() { return base_; }

    [[nodiscard]] Verdict judge(const Patch& patch, const ValidatorOptions& options = {}) {
        Validator validator(base_, prepared_, options);
        const Verdict verdict = validator.judge(patch);
        trial_ = validator.trial();
        return verdict;
    }
    /// Of the last patch judged.
    [[nodiscard]] const Trial& trial() const { return trial_; }

    /// The edge between two base vertices, -1 if there is none.
    [[nodiscard]] std::int32_t edge(std::int32_t a, std::int32_t b) const {
        const auto h = base_.connectivity().find_halfedge(OpenMesh::VertexHandle(a), OpenMesh::VertexHandle(b));
        return h.is_valid() ? base_.connectivity().edge_handle(h).idx() : -1;
    }

    /// The collapse of one base vertex into another.
    [[nodiscard]] Collapse collapse(std::int32_t gone, std::int32_t stays) const {
        return {base_.connectivity().find_halfedge(OpenMesh::VertexHandle(gone), OpenMesh::VertexHandle(stays)), gone,
                stays};
    }

    /// The patch of that collapse onto the place of `stays`.
    [[nodiscard]] Patch collapse_patch(std::int32_t gone, std::int32_t stays) const {
        Patch patch;
        fill_faces(base_, collapse(gone, stays), Extent::both_stars, patch);
        BaseVertex vertex = base_.vertex(gone);
        vertex.scan_vertex = -1;
        patch.changed.push_back({gone, vertex});
        return patch;
    }

    /// Carries out the collapse whose patch was judged last, and accepted.
    void commit_collapse(std::int32_t gone, std::int32_t stays, const Patch& patch) {
        foldless::commit_collapse(base_, collapse(gone, stays), patch, trial_);
    }

    /// Every face of the scan.
    [[nodiscard]] std::vector<std::int32_t> all_faces() const {
        std::vector<std::int32_t> faces(scan_.faces.size());
        std::iota(faces.begin(), faces.end(), 0);
        return faces;
    }

    /// A patch in which the given triangles take the place of everything.
    [[nodiscard]] Patch replacing_all(const std::vector<Triangle>& triangles) const {
        Patch patch;
        patch.removed = all_faces();
        for (const Triangle& corners : triangles) {
            patch.added.push_back({corners, -1});
        }
        return patch;
    }

private:
    Scan scan_;
    PreparedScan prepared_;
    BaseSurface base_;
    Trial trial_;
};

/// A vertex of a patch that is no scan vertex.
inline PatchVertex moved(std::int32_t index, const Vec3& position, const Vec3& direction = Vec3::UnitZ()) {
    return {index, {position, direction, -1}};
}

/// The patch that puts a bipyramid with as many corners in the place of a spindle, its poles kept, turned a little.
inline Patch bipyramid(const World& world, int corners) {
    const auto first = static_cast<std::int32_t>(world.scan().positions.size()); // the index of a new vertex
    std::vector<Triangle> faces;
    for (int n = 0; n < corners; ++n) {
        faces.push_back({first + n, first + (n + 1) % corners, 0});
        faces.push_back({first + (n + 1) % corners, first + n, 1});
    }
    Patch patch = world.replacing_all(faces);
    for (const auto& [pole, direction] : {std::pair{0, Vec3(0, 0, 1)}, std::pair{1, Vec3(0, 0, -1)}}) {
        patch.changed.push_back({pole, {world.scan().positions[pole], direction, pole}});
    }
    for (std::int32_t v = 2; v < first; ++v) {
        patch.changed.push_back(moved(v, world.scan().positions[v]));
    }
    for (int n = 0; n < corners; ++n) {
        const double angle = 2 * std::numbers::pi * n / corners + 0.2;
        const Vec3 outwards(std::cos(angle), std::sin(angle), 0);
        patch.changed.push_back(moved(first + n, outwards, outwards));
    }
    return patch;
}

} // namespace foldless::test
