/// \file
/// The image of scan triangles on the base mesh: which faces they meet, and where a point of them lies.
#pragma once

#include <foldless/verify/association.h>
#include <foldless/verify/edge_trace.h>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace foldless::verification {

/// Values of ScanImage::home that are no base face.
inline constexpr std::int32_t spans_faces = -1; ///< the image meets several base faces
inline constexpr std::int32_t no_image = -2;    ///< frozen, or a corner has no place

/// What is known of the image of every scan face.
struct ScanImage {
    std::vector<std::int32_t> home; ///< the one base face in which the image lies, or one of the values above
    /// (base face, scan face) for every base face that the image of a scan face may meet, ascending.
    std::vector<std::pair<std::int32_t, std::int32_t>> meets;
};

/// A point inside a scan triangle: (1 - u - v) q0 + u q1 + v q2, and a bound on the rounding of each coordinate.
struct ScanPoint {
    Vec3 position;
    double error;
};
[[nodiscard]] ScanPoint point_of(const ScanTriangle& triangle, double u, double v);

/// Where the line through v along d leaves the triangle through its front, border included; in plain doubles.
[[nodiscard]] std::optional<ScanPoint> pierced_at(const Vec3& v, const Vec3& d, const ScanTriangle& triangle);

/// What every check of the scan reads.
struct Correspondents {
    const BaseFaces& base;
    const Scan& scan;
    const Association& association;

    [[nodiscard]] ScanTriangle triangle(std::int32_t scan_face) const;
    [[nodiscard]] bool has_places(std::int32_t scan_face) const {
        return place(scan_face, 0).exists() && place(scan_face, 1).exists() && place(scan_face, 2).exists();
    }
    [[nodiscard]] const Place& place(std::int32_t scan_face, int corner) const {
        return association.places[scan.faces[scan_face][corner]];
    }
};

/// The place of a point of a scan triangle whose corners have places: in the triangle's one base face, or else where
/// the straight line from a corner leads; with constant face directions in a face of a corner.
struct Lifted {
    std::optional<FacePlace> place;
    bool undecided = false; ///< there is none because rounding hides it
};
[[nodiscard]] Lifted lift(const Correspondents& all, std::int32_t scan_face, std::int32_t home, const ScanPoint& point);

/// Whether both ends of a scan edge are kept and it is an edge of the base mesh: such an edge represents itself.
[[nodiscard]] bool is_base_edge(const BaseFaces& base, const Place& a, const Place& b);

} // namespace foldless::verification
