/// \file
/// The decimation loop without the validator: the yardstick for what the guarantee costs.
#pragma once

#include <foldless/decimate/decimate.h>
#include <foldless/io/scan.h>

#include <cstddef>

namespace foldless {

struct UnguardedResult {
    std::size_t faces = 0; ///< of the base mesh at the end
    std::size_t attempted = 0;
    std::size_t accepted = 0;
    double setup_cpu_seconds = 0.0;
    double decimate_cpu_seconds = 0.0;
};

/// Collapses edges as decimate() does, in the same order, with the same placements and the same guards of topology and
/// shape; but there are no displacement directions, no validator and no places of scan vertices, and no faces are
/// frozen. The result is timed and thrown away. Of the options only `target_faces`, `placement`, `boundary` and
/// `edge_valence_limit` apply.
/// \throws RefusedMesh as decimate()
[[nodiscard]] UnguardedResult unguarded_decimate(const Scan& scan, const DecimateOptions& options);

} // namespace foldless
