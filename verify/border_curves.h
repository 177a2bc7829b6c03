/// \file
/// Trimmed borders: the images of the scan's borders on the base mesh.
#pragma once

#include <foldless/verify/degree.h>
#include <foldless/verify/face_checks.h>
#include <foldless/verify/findings.h>
#include <foldless/verify/scan_image.h>
#include <foldless/verify/stages.h>

#include <foldless/predicates/border_arcs.h>

#include <cstdint>
#include <vector>

namespace foldless::verification {

/// Where a border is not locked, the scan covers a part of the base mesh, and discs of different scan faces could
/// overlap. They do not if (docs/certificate.md, T1 to T3)
///  - the images of the border edges of the moving scan meet at their common vertices only, and
///  - of each loop one point is covered by its own scan face only; a loop is cut where more than two of its edges meet.
/// `overlap` where doubles with bounds on their rounding cannot show that. Components of the base mesh that hold a
/// border curve are then covered once at most, and settled.
class BorderCurves {
public:
    BorderCurves(const Correspondents& all, const Meshes& meshes);

    void check(const Meetings& meetings, Stages& stages, double share, Findings& findings) const;
    void settle(Degree& degree) const;

private:
    /// A side of a moving scan face beyond which nothing moves.
    struct Side {
        BorderEdge edge;
        bool is_outermost; ///< it is a base edge, and nothing moves on its other side there either
    };

    void add_side(std::int32_t scan_face, int k);
    void add_base_edge(const BorderEdge& edge);
    void add_traced(const BorderEdge& edge);
    void add(const BorderEdge& edge, const ScanLine& line, const LinePiece& piece);

    void check_face(std::int32_t base_face, Findings& findings) const;
    void check_pillars(Findings& findings) const;
    void check_chains(const Meetings& meetings, Findings& findings) const;
    [[nodiscard]] std::vector<std::uint32_t> chain_of_sides() const;
    [[nodiscard]] bool has_witness(const std::vector<const BorderArc*>& arcs, const Meetings& meetings) const;
    [[nodiscard]] bool is_covered_once(const BorderArc& arc, double s, const Meetings& meetings) const;
    void report(const BorderArc* arc, Findings& findings) const;

    const Correspondents& all_;
    const Meshes& meshes_;
    std::vector<Side> sides_;
    std::vector<BorderArc> arcs_;     ///< sorted
    std::vector<std::int32_t> faces_; ///< those that hold arcs, ascending
};

} // namespace foldless::verification
