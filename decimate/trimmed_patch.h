/// \file
/// Condition T1 of docs/certificate.md on a patch: the images of trimmed borders do not meet.
#pragma once

#include <foldless/decimate/patch_image.h>
#include <foldless/decimate/patched_surface.h>
#include <foldless/decimate/scan_topology.h>
#include <foldless/decimate/verdict.h>
#include <foldless/io/scan.h>
#include <foldless/predicates/border_arcs.h>

#include <array>
#include <cstdint>
#include <vector>

namespace foldless {

class TrimmedPatch {
public:
    TrimmedPatch(const Scan& scan, const ScanTopology& topology) : scan_(&scan), topology_(&topology) {}

    /// `overlap` unless the images of the border edges of these scan faces certainly meet at common vertices only, on
    /// each new cell and at its walls; else what refuses to follow one.
    [[nodiscard]] Verdict test(PatchedSurface& surface, PatchImage& image, const std::vector<std::int32_t>& scan_faces);

private:
    [[nodiscard]] Verdict add(const BorderEdge& edge, PatchImage& image);
    void add_traced(const BorderEdge& edge, const std::array<TraceEnd, 2>& ends);
    void add_base_edge(const BorderEdge& edge, const Corner& from, const Corner& to);
    void add_piece(const BorderEdge& edge, const LinePiece& piece);
    [[nodiscard]] bool are_all_apart() const;

    const Scan* scan_;
    const ScanTopology* topology_;
    PatchedSurface* surface_ = nullptr;
    std::vector<BorderArc> arcs_;
    std::vector<TraceCrossing> crossings_; ///< of one edge
};

} // namespace foldless
