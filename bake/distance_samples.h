/// \file
/// Distances at the vertices of a surface and at points of its faces: a mean, and where the maximum may be.
#pragma once

#include <foldless/bake/block_loop.h>
#include <foldless/bake/nearest_face.h>

#include <array>
#include <cstdint>
#include <vector>

namespace foldless::distances {

/// A point of the one surface, and the face of the other that is nearest to it.
struct Sample {
    Vec3 position = Vec3::Zero();
    double distance = -1.0; ///< below every distance: no sample yet
    std::int32_t face = 0;
};

[[nodiscard]] Sample sample(const NearestFace& other, const Vec3& position, std::int32_t guess);

using SampledTriangle = std::array<Sample, 3>;

/// No corner of the triangle is further from the face, so no point of the triangle is: the distance to a convex set is
/// a convex function, which is largest at a corner. Gives up with something above `enough` where the answer is.
[[nodiscard]] double distance_to_face(const SampledTriangle& triangle, const NearestFace& other, std::int32_t face,
                                      double enough);

/// No point of the triangle is further from the other surface: the least for the faces nearest to its corners.
[[nodiscard]] double upper_bound(const SampledTriangle& triangle, const NearestFace& other);

/// What is known of a surface after each of its faces was looked at once.
struct SampledSurface {
    std::vector<Sample> vertices; ///< no distance at those without faces
    std::vector<double> upper;    ///< for each face: no point of it is further from the other surface
    Sample furthest;              ///< of all samples
    double area = 0.0;
    double integral = 0.0; ///< of the squared distance

    /// The corners of a face.
    [[nodiscard]] SampledTriangle corners(const Triangle& face) const {
        return {vertices[face[0]], vertices[face[1]], vertices[face[2]]};
    }
};

/// Samples the surface, `share` of all work. Expected time O((F + vertices) log f).
[[nodiscard]] SampledSurface sampled(const Surface& surface, const NearestFace& other, BlockLoop& loop, double share);

} // namespace foldless::distances
