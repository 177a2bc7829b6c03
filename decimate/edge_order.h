/// \file
/// Which edges enter the queue, when the decimation starts and after each collapse.
#pragma once

#include <foldless/decimate/base_surface.h>
#include <foldless/decimate/collapse.h>
#include <foldless/decimate/edge_queue.h>

#include <cstdint>
#include <vector>

namespace foldless {

/// A queue of every edge of the base mesh, which must outlive it.
[[nodiscard]] EdgeQueue all_edges(const BaseSurface& base);

/// The edges that the collapse changes or takes away: those around the vertex that goes, and around the one that stays
/// if that moves.
void edges_changed_by(const BaseSurface& base, const Collapse& collapse, Extent extent,
                      std::vector<std::int32_t>& edges);

/// After the collapse: enters those edges with their new lengths, takes out those that are gone, and wakes all edges in
/// the neighbourhood of the vertex that stayed.
void requeue(const BaseSurface& base, std::int32_t stays, const std::vector<std::int32_t>& changed, EdgeQueue& queue);

} // namespace foldless
