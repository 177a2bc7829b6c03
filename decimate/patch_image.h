/// \file
/// Where the vertices and edges of the scan are on a patched surface.
#pragma once

#include <foldless/decimate/edge_trace.h>
#include <foldless/decimate/fan_order.h>
#include <foldless/decimate/index_map.h>
#include <foldless/decimate/patch_ranges.h>
#include <foldless/decimate/patched_surface.h>
#include <foldless/decimate/point_location.h>
#include <foldless/decimate/scan_topology.h>
#include <foldless/decimate/trace_cache.h>
#include <foldless/decimate/verdict.h>

#include <cstdint>
#include <deque>
#include <vector>

namespace foldless {

/// A corner of a scan face.
struct Corner {
    std::int32_t scan_vertex;
    int cell;              ///< where it lies, -1 if it is kept
    const FanOrder* order; ///< the fan of a kept vertex, else null; null too with constant directions
    Lift lift;             ///< if it is not kept

    /// Whether the edge to another corner is an edge of the base mesh.
    [[nodiscard]] bool is_base_edge_to(const Corner& other) const {
        return order != nullptr && order->is_base_edge(other.scan_vertex);
    }
};

/// The place of a scan vertex on the new cells.
struct NewLift {
    std::int32_t scan_vertex;
    Lift lift;
};

/// Knows the new places of a trial, those that stay, the fans of kept vertices, and the edges that were followed.
class PatchImage {
public:
    PatchImage(const Scan& scan, const ScanTopology& topology, bool constant_directions);

    /// Nothing has a new place yet, no fan is ordered, no edge followed.
    void reset(PatchedSurface& surface, PatchRanges& ranges);

    /// Forgets the places and the traces, and gives back their room if that is much.
    void clear();

    /// Room for so many places.
    void reserve(std::size_t places);
    void add(std::int32_t scan_vertex, const Lift& lift);
    [[nodiscard]] const std::vector<NewLift>& lifts() const { return lifts_; }
    /// Into lifts(), or -1 if the vertex has no new place.
    [[nodiscard]] std::int32_t moved(std::int32_t scan_vertex) const { return moved_.find(scan_vertex); }

    /// Condition K at the kept vertices of the patch: the refusals of FanOrder::reset().
    [[nodiscard]] Verdict order_fans(const Patch& patch);

    /// Where a scan vertex is. Fails where that is on a cell that stays and cannot be told, or out of the range of a
    /// cell there; or where the fan of a kept vertex cannot be ordered.
    [[nodiscard]] Verdict find(std::int32_t scan_vertex, Corner& out);

    /// Where a corner lies in a cell that holds it.
    [[nodiscard]] PrismoidPoint point_in(int cell, const Corner& corner) const;
    /// Whether a cell holds a corner.
    [[nodiscard]] bool holds(int cell, const Corner& corner) const;
    /// Where the scan edge between two corners starts at the one. \pre it is no base edge
    [[nodiscard]] TraceEnd trace_end(const Corner& at, const Corner& other) const;

    /// Follows the scan edge between two corners and appends its crossings, in order from the smaller index: the
    /// refusals of trace_edge(). A base edge has none.
    [[nodiscard]] Verdict trace(const Corner& a, const Corner& b, std::vector<TraceCrossing>& crossings);

private:
    [[nodiscard]] Verdict find_staying(const Place& place, Corner& out);
    [[nodiscard]] Verdict order_fan(std::int32_t base_vertex, std::int32_t scan_vertex);
    [[nodiscard]] const FanOrder* order_of(std::int32_t base_vertex, std::int32_t scan_vertex);

    const Scan* scan_;
    const ScanTopology* topology_;
    bool constant_directions_;
    PatchedSurface* surface_ = nullptr;
    PatchRanges* ranges_ = nullptr;
    IndexMap moved_; ///< of scan vertices, into lifts_
    std::vector<NewLift> lifts_;
    IndexMap ordered_;            ///< of scan vertices, into orders_
    std::deque<FanOrder> orders_; ///< which stay where they are; the first orders_used_ are of this trial
    std::size_t orders_used_ = 0;
    TraceCache traces_;
};

} // namespace foldless
