/// \file
/// A scan with what is derived from it once.
#pragma once

#include <foldless/decimate/scan_topology.h>
#include <foldless/io/scan.h>
#include <foldless/predicates/coarse_normal.h>
#include <foldless/predicates/scan_normal.h>

#include <cstdint>
#include <vector>

namespace foldless {

/// Incidences and normals. Never changes, so that any number of threads may ask it.
class PreparedScan {
public:
    /// The scan must be free of defects, and outlive this. Linear time, the normals on all threads.
    explicit PreparedScan(const Scan& scan);

    [[nodiscard]] const Scan& scan() const { return *scan_; }
    [[nodiscard]] const ScanTopology& topology() const { return topology_; }
    /// The normal of a scan face, coarsely, but with a bound on its error.
    [[nodiscard]] ScanNormal normal(std::int32_t face) const { return normals_[face].value(); }
    /// The same to the last digits, of unit length; zero if the face has no area.
    [[nodiscard]] Vec3 unit_normal(std::int32_t face) const { return ScanNormal(triangle(face)).normalised().value(); }

    /// The positions of the corners of a face.
    [[nodiscard]] ScanTriangle triangle(std::int32_t face) const {
        const Triangle& corners = scan_->faces[face];
        return {scan_->positions[corners[0]], scan_->positions[corners[1]], scan_->positions[corners[2]]};
    }

private:
    const Scan* scan_;
    ScanTopology topology_;
    std::vector<CoarseNormal> normals_; ///< per face
};

} // namespace foldless
