/// \file
/// What the scan is like at a point of its surface.
#pragma once

#include <foldless/bake/face_raster.h>

#include <foldless/io/scan.h>

#include <Eigen/Core>

#include <vector>

namespace foldless {

/// The scan with what is interpolated on its surface: linear on each face, by exact places, not between texels.
class ScanSurface {
public:
    /// Normals of vertices are those of the faces around, weighted by angle. (Thuermer and Wuethrich 1998) Refers to
    /// the scan. Time and memory O(n), 12 bytes a vertex.
    /// \param vertex_colours one per vertex, or empty: no colours. Refers to them.
    ScanSurface(const Scan& scan, const std::vector<Eigen::Vector3f>& vertex_colours);

    [[nodiscard]] const Scan& scan() const { return *scan_; }
    [[nodiscard]] ScanTriangle triangle(std::int32_t face) const;
    [[nodiscard]] bool has_colours() const { return !colours_->empty(); }

    /// The interpolated normal, of length 1; that of the face where it vanishes. \pre the point exists
    [[nodiscard]] Eigen::Vector3f normal(const ScanPoint& point) const;
    /// The interpolated colour. \pre has_colours()
    [[nodiscard]] Eigen::Vector3f colour(const ScanPoint& point) const;

private:
    [[nodiscard]] Eigen::Vector3f interpolated(const std::vector<Eigen::Vector3f>& values,
                                               const ScanPoint& point) const;

    const Scan* scan_;
    const std::vector<Eigen::Vector3f>* colours_;
    std::vector<Eigen::Vector3f> normals_;
};

} // namespace foldless
