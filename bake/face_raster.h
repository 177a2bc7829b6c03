/// \file
/// Which point of the scan belongs to each sample of a base face.
#pragma once

#include <foldless/bake/sample_lattice.h>

#include <foldless/io/scan.h>
#include <foldless/predicates/vector.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foldless {

/// The point of the scan that a sample is displaced to.
struct ScanPoint {
    std::int32_t face = -1; ///< of the scan; -1: the sample is displaced to nothing
    double t = 0.0;         ///< in units of the interpolated direction, within the range
    double u = 0.0;         ///< barycentric coordinate of corner 1 of the face
    double v = 0.0;         ///< barycentric coordinate of corner 2

    [[nodiscard]] bool exists() const { return face >= 0; }
};

/// The samples of one base face.
struct FaceSamples {
    SampleLattice lattice;
    Range range;                   ///< of the displacements
    std::vector<ScanPoint> points; ///< at index(i, j); those outside the triangle do not count
    std::size_t contested = 0;     ///< samples to which two faces at different displacements laid claim

    /// Nothing is covered yet.
    FaceSamples(const SampleLattice& samples, Range displacements)
        : lattice(samples), range(displacements),
          points(static_cast<std::size_t>(samples.columns + 1) * static_cast<std::size_t>(samples.rows + 1)) {}

    [[nodiscard]] std::size_t index(int i, int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(lattice.columns + 1) +
               static_cast<std::size_t>(i);
    }
    /// The weights of the sample with an index.
    [[nodiscard]] auto weights(std::size_t sample) const {
        const auto width = static_cast<std::size_t>(lattice.columns + 1);
        return lattice.weights(static_cast<int>(sample % width), static_cast<int>(sample / width));
    }
    [[nodiscard]] const ScanPoint& at(int i, int j) const { return points[index(i, j)]; }
    [[nodiscard]] ScanPoint& at(int i, int j) { return points[index(i, j)]; }
};

/// Baking is rasterisation (Maggiordomo et al. 2023, section 5.1), without an edge being replaced by a straight one: a
/// scan face owns the samples whose line along the interpolated direction passes through it from behind, at a
/// displacement in the range; on which side of an edge a line passes is a sign that is computed exactly, and the same
/// for both faces of the edge. A line that meets an edge or a vertex belongs to the lowest face there. So over faces
/// whose images cover the base face once, each sample gets one point, whatever its place.
///
/// Where several faces at different displacements lay claim to a sample, the one at the least |t| has it. Over a base
/// mesh that is certified, and the scan faces that its map gives, that does not happen.
///
/// \param over scan faces, ascending
/// Time: that of all samples, and for each scan face over the base face of the samples in its box.
[[nodiscard]] FaceSamples rasterise(const BaseTriangle& triangle, Range range, const Scan& scan,
                                    std::span<const std::int32_t> over, const SampleLattice& lattice);

} // namespace foldless
