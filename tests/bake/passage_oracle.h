/// \file
/// Which scan faces the line of a sample passes through: an answer in rational arithmetic that shares no code and no
/// formula with the library, and asks every face.
#pragma once

#include <foldless/bake/sample_lattice.h>

#include <foldless/io/scan.h>
#include <foldless/predicates/vector.h>

#include <cstdint>
#include <vector>

namespace foldless::oracle {

struct PassedFace {
    std::int32_t face;
    double t; ///< in units of the direction, rounded
    double u; ///< barycentric coordinate of corner 1 of the face, rounded
    double v; ///< of corner 2
};

/// The faces of the scan that the line passes through from behind, borders included, at a displacement in the range,
/// ascending. The ray-triangle test of Moeller and Trumbore 1997 in exact numbers. \pre the sample lies in the lattice
[[nodiscard]] std::vector<PassedFace> passed_faces(const BaseTriangle& triangle, const SampleLattice& lattice, int i,
                                                   int j, const Scan& scan, Range range);

} // namespace foldless::oracle
