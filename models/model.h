/// \file
/// A scan known in closed form: any vertex and any face by itself, in constant memory.
#pragma once

#include <foldless/io/scan.h>
#include <foldless/models/lattice.h>
#include <foldless/models/place.h>
#include <foldless/models/quilt.h>

#include <cstdint>
#include <variant>

namespace foldless {

using Grid = std::variant<Lattice, Quilt>;

/// What happens to the points of the surface before they are stored.
struct Finish {
    double noise = 0; ///< standard deviation along the normal, in mean edge lengths; a quarter of it along u and v
    std::uint64_t seed = 0; ///< of the noise
    bool float32 = true;    ///< round every coordinate to float32
};

/// A connectivity laid on a surface. Vertices and faces are numbered as in the file that is written of it.
class Model {
public:
    Model(Grid grid, Surface surface, const Finish& finish);

    [[nodiscard]] std::int64_t vertices() const;
    [[nodiscard]] std::int64_t faces() const;
    [[nodiscard]] bool float32() const { return finish_.float32; }
    /// Mean length of the edges before the noise, over at most 4096 faces spread evenly over the mesh; model units.
    [[nodiscard]] double mean_edge_length() const;
    /// 0 <= vertex < vertices(); exactly the numbers of the file.
    [[nodiscard]] Vec3 position(std::int64_t vertex) const;
    /// 0 <= face < faces().
    [[nodiscard]] Triangle triangle(std::int64_t face) const;

private:
    [[nodiscard]] SurfacePlace place(std::int64_t vertex) const;
    [[nodiscard]] Vec3 displacement(const SurfacePlace& place, std::int64_t vertex) const;

    Grid grid_;
    Surface surface_;
    Finish finish_;
    double amplitude_; ///< standard deviation of the noise, model units
};

/// The whole model in memory. Time and memory O(faces).
[[nodiscard]] Scan to_scan(const Model& model);

} // namespace foldless
