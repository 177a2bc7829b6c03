/// \file
/// Trimmed borders: the images of the scan's borders on the base mesh.
#pragma once

#include <foldless/verify/degree.h>
#include <foldless/verify/face_checks.h>
#include <foldless/verify/findings.h>
#include <foldless/verify/scan_image.h>
#include <foldless/verify/stages.h>

#include <foldless/predicates/line_pieces.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace foldless::verification {

/// Where a border is not locked, the scan covers a part of the base mesh, and discs of different scan faces could
/// overlap. They do not if (docs/certificate.md, T1 to T3)
///  - the images of the border edges of the moving scan meet at their common vertices only, and
///  - of each loop one point is covered by its own scan face only.
/// `overlap` where doubles with bounds on their rounding cannot show that. Components of the base mesh that hold a
/// border curve are then covered once at most, and settled.
class BorderCurves {
public:
    BorderCurves(const Correspondents& all, const Meshes& meshes);

    void check(const Meetings& meetings, Stages& stages, double share, Findings& findings) const;
    void settle(Degree& degree) const;

private:
    /// A side of a moving scan face beyond which nothing moves.
    struct BorderEdge {
        std::array<std::int32_t, 2> ends;
        std::int32_t scan_face;
        bool is_outermost; ///< it is a base edge, and nothing moves on its other side there either
    };
    /// The image of a border edge on one base face.
    struct Arc {
        std::int32_t base_face;
        std::int32_t edge;
        std::array<std::int32_t, 2> vertices; ///< scan vertices at its ends, or -1 on a wall
        ImageArc image;
    };

    void add_edge(std::int32_t scan_face, int k);
    void add_along_base_edge(const BorderEdge& edge);
    void add_traced(const BorderEdge& edge);
    void add(const ScanLine& line, const LinePiece& piece);
    void sort();

    [[nodiscard]] std::span<const Arc> arcs_on(std::int32_t base_face) const;
    [[nodiscard]] bool may_meet(const Arc& a, const Arc& b) const;
    void check_face(std::int32_t base_face, Findings& findings) const;
    void check_wall(std::int32_t base_face, int k, Findings& findings) const;
    void check_pillars(Findings& findings) const;
    void check_loops(const Meetings& meetings, Findings& findings) const;
    [[nodiscard]] bool has_witness(const std::vector<std::size_t>& arcs, const Meetings& meetings) const;
    [[nodiscard]] bool is_covered_once(const Arc& arc, double s, const Meetings& meetings) const;
    void report(const Arc& arc, Findings& findings) const;

    const Correspondents& all_;
    const Meshes& meshes_;
    std::vector<BorderEdge> edges_;
    std::vector<Arc> arcs_;              ///< by base face, then by the lower bound of alpha_0
    std::vector<std::int32_t> faces_;    ///< those that hold arcs, ascending
    std::vector<std::size_t> first_arc_; ///< of each of them, and the end
};

} // namespace foldless::verification
