#include <foldless/repair/repair.h>

#include <foldless/io/float32.h>
#include <foldless/repair/agreement.h>
#include <foldless/repair/bad_faces.h>
#include <foldless/repair/dropping.h>
#include <foldless/repair/duplicate_faces.h>
#include <foldless/repair/separation.h>
#include <foldless/repair/small_components.h>
#include <foldless/repair/thin_walls.h>
#include <foldless/repair/unserved_stars.h>

#include <fmt/format.h>

#include <utility>

namespace foldless {

RepairResult repair(Scan scan, const RepairOptions& options) {
    if (scan.faces.empty()) {
        throw RefusedMesh("no faces");
    }
    RepairCounts counts;
    drop_bad_faces(scan, counts);
    drop_thin_walls(scan, drop_duplicate_faces(scan, counts), counts);
    turn_faces(scan, counts);
    separate_fans(scan, counts);
    // What is dropped around a spike may leave bow-ties. Splitting them takes faces from a vertex, so that those that
    // were served still are, but for rounding; each round drops a face, which ends the loop.
    while (options.drop_unserved && drop_unserved_stars(scan, counts)) {
        separate_fans(scan, counts);
    }
    drop_small_components(scan, options.min_component_faces, counts);
    drop_unused_vertices(scan, counts);
    if (scan.faces.empty()) {
        throw RefusedMesh(fmt::format("no face is left by the repair: {}", counts.text()));
    }
    scan.float32 = all_float32(scan.positions);
    return {std::move(scan), counts};
}

} // namespace foldless
