/// \file
/// Makes a mesh with defects one that can be decimated. Never done unless asked for: what it changes is no longer the
/// scan that was measured.
#pragma once

#include <foldless/io/errors.h>
#include <foldless/io/scan.h>
#include <foldless/repair/repair_counts.h>

#include <cstddef>

namespace foldless {

struct RepairOptions {
    std::size_t min_component_faces = 1; ///< components of fewer faces are dropped; 1: none is
    bool drop_unserved = false; ///< drop the faces around vertices whose faces no direction sees all from the front
};

struct RepairResult {
    Scan scan;           ///< without defects
    RepairCounts counts; ///< what was done
};

/// Repairs what inspect() counts as defects, in this order (docs/algorithm.md says why each step is right):
///
/// * drops faces without three different vertices of the mesh, with a corner that is not finite, or of zero area, and
///   each face whose three vertices an earlier one has; the earlier one, too, where the surface closes without it;
/// * turns faces over until those at an edge of two faces agree, as few as make each part agree. A part that agrees is
///   left as it is, inside out or not; edges at which a one-sided part cannot agree are cut open;
/// * takes edges of three or more faces apart: two faces that continue each other best stay together, where that
///   leaves a manifold, the others get a border. Each further fan of a vertex gets a copy of it;
/// * if asked for, drops the faces around unserved vertices, and components of few faces;
/// * drops vertices that no face uses.
///
/// The faces that are left keep their order, those that were not turned over the order of their corners, and those that
/// were the first corner. Positions keep their bits; copies of vertices come after the others. A mesh that needs
/// nothing comes out as it is, and the result of a repair needs nothing. The same input gives the same result in every
/// run.
///
/// \throws RefusedMesh if there is no face, or none is left. Time O(n log n), with drop_unserved for each of a
/// few rounds; memory O(n).
[[nodiscard]] RepairResult repair(Scan scan, const RepairOptions& options = {});

} // namespace foldless
