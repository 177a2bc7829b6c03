#include "deep_check.h"

#include "made_scans.h"

#include <foldless/io/bounding_box.h>
#include <foldless/io/defects.h>
#include <foldless/io/float32.h>
#include <foldless/verify/verify.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace foldless::test {
namespace {

/// A stored place, alpha and t in double, reproduces its vertex up to this share of the diagonal.
constexpr double place_error = 1e-9;

/// Barycentric coordinates of a point on a wall may be negative by their rounding.
constexpr double alpha_error = 1e-9;

/// Directions have unit length up to their rounding to float32.
constexpr double unit_error = 1e-6;

bool has_face_directions(const DecimateOptions& options) {
    return options.directions == Directions::face;
}

Vec3 direction(const BaseMesh& base, std::int32_t face, int k) {
    return base.face_directions.empty() ? base.directions[base.faces[face][k]] : base.face_directions[face];
}

BaseTriangle triangle(const BaseMesh& base, std::int32_t f) {
    BaseTriangle result;
    for (int k = 0; k < 3; ++k) {
        result.v[k] = base.positions[base.faces[f][k]];
        result.d[k] = direction(base, f, k);
    }
    return result;
}

void check_arrays(const Scan& scan, const DecimateOptions& options, const DecimateResult& result) {
    const BaseMesh& base = result.base;
    EXPECT_EQ(base.float32, scan.float32);
    EXPECT_EQ(base.scan_vertex.size(), base.positions.size());
    EXPECT_EQ(base.ranges.size(), base.faces.size());
    EXPECT_EQ(base.directions.size(), has_face_directions(options) ? 0 : base.positions.size());
    EXPECT_EQ(base.face_directions.size(), has_face_directions(options) ? base.faces.size() : 0);
    EXPECT_EQ(result.correspondence.base_face.size(), scan.positions.size());
    EXPECT_EQ(result.correspondence.alpha.size(), scan.positions.size());
    EXPECT_EQ(result.correspondence.t.size(), scan.positions.size());
}

void check_stored_numbers(const BaseMesh& base) {
    if (base.float32) {
        EXPECT_TRUE(
            std::all_of(base.positions.begin(), base.positions.end(), [](const Vec3& p) { return is_float32(p); }));
    }
    for (const std::vector<Vec3>* directions : {&base.directions, &base.face_directions}) {
        for (const Vec3& d : *directions) {
            EXPECT_TRUE(is_float32(d)) << d.transpose();
            EXPECT_NEAR(d.norm(), 1, unit_error);
        }
    }
    for (const Range& range : base.ranges) {
        EXPECT_TRUE(is_float32(range.lo) && is_float32(range.hi)) << range.lo << ' ' << range.hi;
        EXPECT_LE(range.lo, range.hi);
    }
}

void check_kept_vertices(const Scan& scan, const BaseMesh& base) {
    std::set<std::int32_t> claimed;
    for (std::size_t v = 0; v < base.positions.size(); ++v) {
        const std::int32_t kept = base.scan_vertex[v];
        if (kept >= 0) {
            EXPECT_TRUE(claimed.insert(kept).second) << "scan vertex " << kept << " is kept twice";
            EXPECT_EQ(base.positions[v], scan.positions[kept]);
        }
    }
}

/// Whether the face is the scan face that is represented by itself.
bool is_frozen(const BaseMesh& base, std::int32_t f) {
    const Triangle& corners = base.faces[f];
    return base.ranges[f].lo == 0 && base.ranges[f].hi == 0 &&
           std::all_of(corners.begin(), corners.end(), [&](std::int32_t v) { return base.scan_vertex[v] >= 0; });
}

void check_places(const Scan& scan, const DecimateResult& result) {
    std::vector<bool> used(scan.positions.size(), false);
    for (const Triangle& face : scan.faces) {
        for (const std::int32_t v : face) {
            used[v] = true;
        }
    }
    const double error = place_error * bounding_box_diagonal(scan);
    for (std::size_t v = 0; v < scan.positions.size(); ++v) {
        const std::int32_t face = result.correspondence.base_face[v];
        ASSERT_EQ(face >= 0, used[v]) << "scan vertex " << v;
        if (!used[v]) {
            continue;
        }
        ASSERT_LT(face, static_cast<std::int32_t>(result.base.faces.size()));
        const BaseTriangle base = triangle(result.base, face);
        const Vec3& alpha = result.correspondence.alpha[v];
        const double t = result.correspondence.t[v];
        const Vec3 reached = alpha[0] * base.corner(0, t) + alpha[1] * base.corner(1, t) + alpha[2] * base.corner(2, t);
        EXPECT_LE((reached - scan.positions[v]).norm(), error) << "scan vertex " << v;
        EXPECT_NEAR(alpha.sum(), 1, alpha_error);
        EXPECT_GE(alpha.minCoeff(), -alpha_error) << "scan vertex " << v;
        EXPECT_GE(t, result.base.ranges[face].lo) << "scan vertex " << v;
        EXPECT_LE(t, result.base.ranges[face].hi) << "scan vertex " << v;
    }
}

void check_jacobian(const BaseMesh& base) {
    for (std::int32_t f = 0; f < static_cast<std::int32_t>(base.faces.size()); ++f) {
        if (is_frozen(base, f)) {
            continue;
        }
        const BaseTriangle at = triangle(base, f);
        const Range range = base.ranges[f];
        for (const double t : {range.lo, (range.lo + range.hi) / 2, range.hi}) {
            const Vec3 normal = (at.corner(1, t) - at.corner(0, t)).cross(at.corner(2, t) - at.corner(0, t));
            for (const Vec3& d : at.d) {
                EXPECT_GT(normal.dot(d), 0) << "base face " << f << " at t = " << t;
            }
        }
    }
}

using EdgeSet = std::set<std::pair<std::int32_t, std::int32_t>>;

/// The border edges, named by numbers[v] of their ends, in the direction of their faces.
EdgeSet border_edges(const std::vector<Triangle>& faces, const std::vector<std::int32_t>& numbers) {
    EdgeSet edges;
    for (const Triangle& face : faces) {
        for (int k = 0; k < 3; ++k) {
            edges.insert({face[k], face[(k + 1) % 3]});
        }
    }
    EdgeSet border;
    for (const auto& [a, b] : edges) {
        if (!edges.contains({b, a})) {
            border.insert({numbers[a], numbers[b]});
        }
    }
    return border;
}

void check_topology(const Scan& scan, const DecimateOptions& options, const BaseMesh& base) {
    const Inspection of_scan = inspect(scan);
    const Inspection of_base = inspect({base.positions, base.faces, base.float32});
    EXPECT_EQ(of_base.defects.text(), "");
    EXPECT_EQ(of_base.topology.unused_vertices, 0);
    EXPECT_EQ(of_base.topology.components, of_scan.topology.components);
    EXPECT_EQ(of_base.topology.boundary_loops, of_scan.topology.boundary_loops);
    EXPECT_EQ(of_base.topology.euler_characteristic, of_scan.topology.euler_characteristic);
    if (options.boundary == Boundary::lock) {
        std::vector<std::int32_t> same(scan.positions.size());
        for (std::size_t v = 0; v < same.size(); ++v) {
            same[v] = static_cast<std::int32_t>(v);
        }
        EXPECT_EQ(border_edges(base.faces, base.scan_vertex), border_edges(scan.faces, same));
    }
}

} // namespace

void deep_check(const Scan& scan, const DecimateOptions& options, const DecimateResult& result) {
    check_arrays(scan, options, result);
    if (testing::Test::HasFailure()) {
        return; // the other checks index by what was just found wrong
    }
    check_stored_numbers(result.base);
    check_kept_vertices(scan, result.base);
    check_places(scan, result);
    check_jacobian(result.base);
    check_topology(scan, options, result.base);
    const VerifyResult verified = verify(result.base, scan);
    for (std::size_t kind = 0; kind < violation_count; ++kind) {
        EXPECT_EQ(verified.violations[kind], 0) << name(static_cast<Violation>(kind));
    }
    EXPECT_TRUE(verified.certified());
}

} // namespace foldless::test
