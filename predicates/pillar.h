/// \file
/// The pillar of a base vertex, all v + t d, against a triangle of the scan: condition P of docs/certificate.md. All
/// signs are rational, and exact.
#pragma once

#include <foldless/predicates/displacement.h>
#include <foldless/predicates/sign.h>
#include <foldless/predicates/vector.h>
#include <foldless/predicates/view_along.h>

namespace foldless {

/// Whether the pillar passes through the inside of the scan triangle with m = d.n > 0: positive if so, zero if it
/// passes through its border, else negative. Finite input is assumed.
[[nodiscard]] Sign pierces(const DisplacedVertex& vertex, const ScanTriangle& triangle);

/// Whether it meets the plane of the triangle at a displacement within the range, ends included. \pre d.n > 0
[[nodiscard]] bool meets_plane_within(const DisplacedVertex& vertex, const ScanTriangle& triangle, Range range);

/// Bounds of the displacement t = -l/m where it meets the plane; infinite if rounding hides m. \pre d.n > 0
[[nodiscard]] Range displacement_at_plane(const DisplacedVertex& vertex, const ScanTriangle& triangle);

/// Which way round a scan edge that leaves the point of the pillar at displacement t follows the base edge from there
/// to `end`, seen along the direction of the vertex: the sign of d.((a_end - a)(t) x (to - from)). Exact.
[[nodiscard]] Sign turn_from_base_edge(const DisplacedVertex& vertex, const DisplacedVertex& end, const Displacement& t,
                                       const ScanLine& scan_edge);

/// Where such an edge goes that starts exactly along the base edge to the next corner, seen so: positive into the
/// triangle, negative to the other side of the wall, which may curve; zero along the wall. Exact.
[[nodiscard]] Sign leaves_wall_into(const BaseTriangle& triangle, int corner, const Displacement& t,
                                    const ScanLine& scan_edge);

} // namespace foldless
