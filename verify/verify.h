/// \file
/// Proves from the two meshes alone that a base mesh represents a scan. Knows nothing of how the base mesh came to be.
#pragma once

#include <foldless/io/base_mesh.h>
#include <foldless/io/scan.h>
#include <foldless/predicates/sign_counts.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace foldless {

enum class Violation {
    topology,          ///< components, borders or Euler characteristic differ, or the base mesh is no manifold
    kept_vertex,       ///< a vertex that says it is a scan vertex is not
    border,            ///< a border edge of a locked border is not one of the other mesh
    jacobian,          ///< J is not positive on a prismoid over the range of its face
    no_preimage,       ///< a scan vertex has no place on the base mesh
    several_preimages, ///< a scan vertex has two places on neighbouring faces
    normal_condition,  ///< N.n > 0 fails at a scan vertex, or where a scan edge crosses a wall
    orientation,       ///< the scan does not go round once at a kept vertex, in the order of the base faces
    trace,             ///< an edge of the scan cannot be followed across the base mesh
    interior_sample,   ///< a point inside a scan triangle has no place, or N.n <= 0 there
    base_ray,          ///< the ray from a base point does not meet the scan front-facing within the range
    pillar,            ///< the base vertices inside a scan triangle do not fit the walls that its border crosses
    degree,            ///< a component of the base mesh is covered twice, or not at all
    overlap,           ///< images of trimmed borders meet, or lie over the scan, or rounding hides that they do not
};

inline constexpr std::size_t violation_count = static_cast<std::size_t>(Violation::overlap) + 1;

/// What a verification without violations proves. (docs/certificate.md)
enum class Level {
    vertices, ///< the places of the scan vertices, and samples between them
    surface,  ///< the whole continuous surface, in exact arithmetic
};

/// The word of the report.
[[nodiscard]] std::string_view name(Level level);

/// The stable snake_case word of the report.
[[nodiscard]] std::string_view name(Violation violation);

/// A violation and where it is. An index that does not apply is -1. Of what is found on the scan, the base face is that
/// of the place of the vertex, or the one that is left where an edge crosses a wall.
struct LocatedViolation {
    Violation violation;
    std::int32_t scan_vertex = -1;
    std::int32_t scan_face = -1;
    std::int32_t base_face = -1;
    Vec3 position = Vec3::Zero();
};

struct VerifyOptions {
    int samples_per_face = 3;             ///< interior samples of every scan face
    int rays_per_face = 64;               ///< rays from every moving base face
    std::optional<int> threads;           ///< no value: all cores
    std::function<bool(double)> progress; ///< called with the share done, 0 to 1; false asks to stop
};

struct VerifyResult {
    bool cancelled = false;
    Level level = Level::vertices;                         ///< of what was asked: surface with vertex directions
    SignCounts signs;                                      ///< how they were decided
    std::array<std::size_t, violation_count> violations{}; ///< counts, indexed by Violation
    std::vector<LocatedViolation> located;                 ///< the first ones of each kind, a few, in a fixed order
    std::size_t ambiguous_vertices = 0; ///< scan vertices that non-adjacent faces reach too within their ranges
    std::size_t frozen_faces = 0;       ///< base faces that are scan faces with range [0, 0]
    double uncovered_fraction = 0.0;    ///< share of the base area to which nothing of the scan maps, by the rays
    bool ranges_computed = false;       ///< the base mesh had none
    double min_displacement = 0.0;      ///< signed t |d| over the scan vertices, model units
    double max_displacement = 0.0;
    double rms_displacement = 0.0;

    [[nodiscard]] std::size_t violation_total() const;
    [[nodiscard]] bool certified() const { return !cancelled && violation_total() == 0; }
};

/// Re-derives everything from nothing: topology, the place of every scan vertex, the lift of every scan edge, what is
/// inside every scan triangle, and how often the base mesh is covered; all of it exactly (theorems B and C of
/// docs/certificate.md). With constant face directions samples stand for what is not proven.
///
/// Several calls may run at once, on threads of the caller or inside loops of TBB. What the progress callback throws
/// comes out of the call.
///
/// \throws RefusedMesh if either mesh has a defect (see io/defects.h) or the base mesh has no directions, a
/// direction or range that is not finite, a range that ends before it begins, or arrays of wrong lengths.
/// \throws std::invalid_argument for less than one thread or ray, or a negative number of samples.
/// Expected time O((F + f) log f) for F scan and f base faces.
[[nodiscard]] VerifyResult verify(const BaseMesh& base, const Scan& scan, const VerifyOptions& options = {});

} // namespace foldless
