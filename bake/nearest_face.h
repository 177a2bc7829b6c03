/// \file
/// The face of a surface that is nearest to a given point.
#pragma once

#include <foldless/bake/embree_scene.h>
#include <foldless/bake/triangle_distance.h>
#include <foldless/io/scan.h>

#include <vector>

namespace foldless::distances {

/// A triangle mesh with all coordinates of its faces in [-1, 1], so that float32 boxes around faces have one known
/// error.
struct Surface {
    std::vector<Vec3> positions;
    const std::vector<Triangle>& faces;

    [[nodiscard]] ScanTriangle corners(std::int32_t face) const {
        const Triangle& vertices = faces[face];
        return {positions[vertices[0]], positions[vertices[1]], positions[vertices[2]]};
    }
};

/// A face and its point nearest to what was asked for.
struct NearestOnFace {
    std::int32_t face;
    NearestPoint nearest;
};

/// A hierarchy of boxes around the faces of a surface, by Embree. Its boxes are float32 and only say which faces to
/// look at; the distances are those of nearest_point(), in doubles.
class NearestFace {
public:
    /// Time O(n log n), on the threads of the arena in which it is called. \pre there are faces, and `surface` outlives
    /// this
    /// \throws std::bad_alloc, or std::runtime_error where Embree cannot run
    explicit NearestFace(const Surface& surface);

    /// The face with the least distance, as computed; of several the first. `guess` is any face; the nearer, the
    /// faster. It does not change the answer. Any number of threads may ask. \pre the coordinates are in [-1, 1]
    [[nodiscard]] NearestOnFace nearest(const Vec3& query, std::int32_t guess) const;

    /// The point of that face nearest to the query.
    [[nodiscard]] NearestPoint nearest_on(std::int32_t face, const Vec3& query) const {
        return nearest_point(query, surface_.corners(face));
    }

private:
    const Surface& surface_;
    EmbreeDevice device_;
    EmbreeScene scene_;
};

} // namespace foldless::distances
