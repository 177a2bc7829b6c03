/// \file
/// The scan back from a base mesh and its displacements.
#pragma once

#include <foldless/io/base_mesh.h>
#include <foldless/io/scan.h>
#include <foldless/predicates/vector.h>

#include <cstdint>
#include <functional>
#include <optional>

namespace foldless {

/// What a map has for a point of a base face.
struct MapValue {
    double t = 0.0;        ///< displacement; extrapolated where nothing of the scan is
    double coverage = 1.0; ///< at least one half where something of the scan is, less than that elsewhere
};

/// The value at the point `alpha` of a base face. Called from many threads.
using MapValueAt = std::function<MapValue(std::int32_t face, const Vec3& alpha)>;

struct ReconstructOptions {
    int level = 4;              ///< each base face becomes 4^level faces; 0 to max_level
    std::optional<int> threads; ///< no value: all cores

    static constexpr int max_level = 12;
};

/// Cuts every base face into 4^level and displaces the vertices: x = X + t d with the interpolated direction.
/// (Collins and Hilton 2002, figure 6) A vertex on a base edge or at a base vertex is there once, displaced by the map
/// of the lowest face around it, so that the surface is as tight as the base mesh. Faces that reach beyond what is
/// covered are cut off where the coverage along their edges falls below one half, once for both faces of an edge.
///
/// \throws std::invalid_argument for a level out of bounds, constant face directions or less than one thread;
/// std::length_error if the indices would exceed 32 bits.
/// Time and memory O(f 4^level).
[[nodiscard]] Scan reconstruct(const BaseMesh& base, const MapValueAt& value_at,
                               const ReconstructOptions& options = {});

} // namespace foldless
