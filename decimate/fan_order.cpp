#include <foldless/decimate/fan_order.h>

#include <algorithm>
#include <cassert>

namespace foldless {

Verdict FanOrder::reset(std::int32_t v, PatchedSurface& surface, const Scan& scan, const ScanTopology& topology) {
    vertex_ = v;
    edges_.clear();
    fan_ = &surface.fan(v);
    spoke_scan_vertices_.clear();
    for (const std::int32_t spoke : fan_->spokes) {
        spoke_scan_vertices_.push_back(surface.vertex(spoke).scan_vertex);
    }
    const Verdict turns = base_turns_once(surface);
    if (turns != Verdict::accepted) {
        return turns;
    }
    const std::int32_t scan_vertex = surface.vertex(v).scan_vertex;
    for (const std::int32_t f : topology.faces_around(scan_vertex)) {
        const Triangle& face = scan.faces[f];
        const int k = face[0] == scan_vertex ? 0 : face[1] == scan_vertex ? 1 : 2;
        // Every edge is the first of one face, but for the last at a border.
        const std::int32_t first = face[(k + 1) % 3];
        const std::int32_t second = face[(k + 2) % 3];
        Verdict verdict = add_edge(first, surface, scan);
        if (verdict == Verdict::accepted && topology.border_successor(second) == scan_vertex) {
            verdict = add_edge(second, surface, scan);
        }
        if (verdict != Verdict::accepted) {
            return verdict;
        }
    }
    return goes_round_once(scan_vertex, scan, topology);
}

Verdict FanOrder::add_edge(std::int32_t neighbour, PatchedSurface& surface, const Scan& scan) {
    int position = 0;
    const Verdict verdict = find_position(neighbour, surface, scan, position);
    if (verdict == Verdict::accepted) {
        edges_.push_back({neighbour, position});
    }
    return verdict;
}

Verdict FanOrder::base_turns_once(PatchedSurface& surface) const {
    // Each sector of a moving cell turns by less than half a turn (J > 0), so a run of them turns by a full turn or
    // more exactly if a later sector holds the direction of its first edge again. In a cycle the last sector ends
    // there.
    const std::size_t n = fan_->cells.size();
    const auto impassable = [&](std::size_t c) { return surface.cell(fan_->cells[c % n]).impassable; };
    std::size_t start = 0;
    while (start < n && !impassable(start)) {
        ++start;
    }
    if (start == n) {
        return no_sector_holds(0, 1, fan_->closed ? n - 1 : n, surface);
    }
    // Runs between impassable cells: from each moving cell that follows one (or the beginning of an open fan).
    for (std::size_t c = 0; c < n; ++c) {
        const bool first = fan_->closed ? impassable(c + n - 1) : c == 0 || impassable(c - 1);
        if (impassable(c) || !first) {
            continue;
        }
        std::size_t last = c + 1;
        while (!impassable(last) && (fan_->closed || last < n)) {
            ++last;
        }
        const Verdict verdict = no_sector_holds(c, c + 1, last, surface);
        if (verdict != Verdict::accepted) {
            return verdict;
        }
    }
    return Verdict::accepted;
}

Verdict FanOrder::no_sector_holds(std::size_t spoke, std::size_t first, std::size_t last,
                                  PatchedSurface& surface) const {
    const Vec3 e = surface.vertex(fan_->spokes[spoke]).position - surface.vertex(vertex_).position;
    for (std::size_t c = first; c < last; ++c) {
        const int cell = fan_->cells[c % fan_->cells.size()];
        const int k = surface.corner_of(cell, vertex_);
        const Sign right = surface.cell(cell).wall((k + 2) % 3).passes_at_corner(e, 0);
        if (right == Sign::positive) {
            continue;
        }
        const Sign left = surface.cell(cell).wall((k + 1) % 3).passes_at_corner(e, 1);
        if (right == Sign::negative && left == Sign::negative) {
            return Verdict::jacobian;
        }
        if (left != Sign::positive) {
            return Verdict::undecided;
        }
    }
    return Verdict::accepted;
}

Verdict FanOrder::find_position(std::int32_t neighbour, PatchedSurface& surface, const Scan& scan, int& out) const {
    const auto spoke = std::find(spoke_scan_vertices_.begin(), spoke_scan_vertices_.end(), neighbour);
    if (spoke != spoke_scan_vertices_.end()) {
        out = static_cast<int>(2 * (spoke - spoke_scan_vertices_.begin()));
        return Verdict::accepted;
    }
    const Vec3 e = scan.positions[neighbour] - surface.vertex(vertex_).position;
    bool undecided = false;
    for (std::size_t c = 0; c < fan_->cells.size(); ++c) {
        const Cell& cell = surface.cell(fan_->cells[c]);
        const int k = surface.corner_of(fan_->cells[c], vertex_);
        // The wall opposite corner k + 2 runs from k to k + 1, so corner k is at its lambda = 0; the one opposite k + 1
        // runs from k + 2 to k, so corner k is at lambda = 1.
        const Sign right = cell.wall((k + 2) % 3).passes_at_corner(e, 0);
        if (right == Sign::positive) {
            continue;
        }
        const Sign left = cell.wall((k + 1) % 3).passes_at_corner(e, 1);
        if (right == Sign::negative && left == Sign::negative) {
            out = static_cast<int>(2 * c + 1);
            return cell.impassable ? Verdict::no_preimage : Verdict::accepted;
        }
        undecided = undecided || left != Sign::positive;
    }
    return undecided ? Verdict::undecided : Verdict::no_preimage;
}

int FanOrder::position(std::int32_t neighbour) const {
    const auto found =
        std::find_if(edges_.begin(), edges_.end(), [&](const Edge& e) { return e.neighbour == neighbour; });
    assert(found != edges_.end());
    return found->position;
}

int FanOrder::steps(int from, int to) const {
    const int around = static_cast<int>(2 * fan_->cells.size());
    return fan_->closed ? (to - from + around) % around : to - from;
}

Verdict FanOrder::goes_round_once(std::int32_t scan_vertex, const Scan& scan, const ScanTopology& topology) const {
    // Each scan face turns by less than half a turn (N.n > 0 at the kept vertex), so its steps are those of the shorter
    // way round from its first edge to its second; they add up to one turn for each time that the scan goes round.
    int total = 0;
    for (const std::int32_t f : topology.faces_around(scan_vertex)) {
        const Triangle& face = scan.faces[f];
        const int k = static_cast<int>(std::find(face.begin(), face.end(), scan_vertex) - face.begin());
        const int forward = steps(position(face[(k + 1) % 3]), position(face[(k + 2) % 3]));
        if (forward < 0) {
            return Verdict::orientation;
        }
        total += forward;
    }
    const int around = static_cast<int>(2 * fan_->cells.size());
    const bool scan_closed = topology.border_successor(scan_vertex) < 0;
    if (fan_->closed && scan_closed) {
        return total == around ? Verdict::accepted : Verdict::orientation;
    }
    return total <= around ? Verdict::accepted : Verdict::orientation;
}

} // namespace foldless
