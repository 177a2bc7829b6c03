#include <foldless/decimate/fan_order.h>

#include <algorithm>
#include <cassert>

namespace foldless {

Verdict FanOrder::reset(std::int32_t v, PatchedSurface& surface, const Scan& scan, const ScanTopology& topology) {
    vertex_ = v;
    fan_ = &surface.fan(v);
    look_along_spokes(surface);
    const std::int32_t scan_vertex = surface.vertex(v).scan_vertex;
    Verdict verdict = base_turns_once(surface);
    if (verdict == Verdict::accepted) {
        verdict = sort_edges(scan_vertex, surface, scan, topology);
    }
    return verdict == Verdict::accepted ? goes_round_once(scan_vertex, scan, topology) : verdict;
}

void FanOrder::look_along_spokes(const PatchedSurface& surface) {
    const BaseVertex& vertex = surface.vertex(vertex_);
    const ViewAlong view(vertex.direction);
    spokes_.clear();
    for (const std::int32_t spoke : fan_->spokes) {
        const BaseVertex& end = surface.vertex(spoke);
        spokes_.push_back({end.scan_vertex, view.see(end.position - vertex.position)});
    }
}

Verdict FanOrder::sort_edges(std::int32_t scan_vertex, const PatchedSurface& surface, const Scan& scan,
                             const ScanTopology& topology) {
    edges_.clear();
    const Vec3& centre = scan.positions[scan_vertex];
    const ViewAlong view(surface.vertex(vertex_).direction);
    for (const std::int32_t f : topology.faces_around(scan_vertex)) {
        const Triangle& face = scan.faces[f];
        const int k = face[0] == scan_vertex ? 0 : face[1] == scan_vertex ? 1 : 2;
        // Every edge is the first of one face, but for the last at a border.
        const std::int32_t first = face[(k + 1) % 3];
        const std::int32_t second = face[(k + 2) % 3];
        Verdict verdict = add_edge(first, view.see(scan.positions[first] - centre), surface);
        if (verdict == Verdict::accepted && topology.border_successor(second) == scan_vertex) {
            verdict = add_edge(second, view.see(scan.positions[second] - centre), surface);
        }
        if (verdict != Verdict::accepted) {
            return verdict;
        }
    }
    return Verdict::accepted;
}

Verdict FanOrder::add_edge(std::int32_t neighbour, const ViewAlong::Seen& edge, const PatchedSurface& surface) {
    const auto is_spoke = [&](const Spoke& spoke) { return spoke.scan_vertex == neighbour; };
    const auto spoke = std::find_if(spokes_.begin(), spokes_.end(), is_spoke);
    if (spoke != spokes_.end()) {
        edges_.push_back({neighbour, static_cast<int>(2 * (spoke - spokes_.begin()))});
        return Verdict::accepted;
    }
    int cell = 0;
    const Verdict verdict = find_cell(edge, surface, cell);
    if (verdict == Verdict::accepted) {
        edges_.push_back({neighbour, 2 * cell + 1});
    }
    return verdict;
}

Verdict FanOrder::base_turns_once(const PatchedSurface& surface) const {
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
        return no_sector_holds(0, 1, fan_->closed ? n - 1 : n);
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
        const Verdict verdict = no_sector_holds(c, c + 1, last);
        if (verdict != Verdict::accepted) {
            return verdict;
        }
    }
    return Verdict::accepted;
}

Verdict FanOrder::no_sector_holds(std::size_t spoke, std::size_t first, std::size_t last) const {
    const ViewAlong::Seen& edge = spokes_[spoke].seen;
    for (std::size_t c = first; c < last; ++c) {
        const Sign from_right = turn(spokes_[c % spokes_.size()].seen, edge);
        if (from_right == Sign::negative) {
            continue;
        }
        const Sign to_left = turn(edge, spokes_[(c + 1) % spokes_.size()].seen);
        if (from_right == Sign::positive && to_left == Sign::positive) {
            return Verdict::jacobian;
        }
        if (to_left != Sign::negative) {
            return Verdict::undecided;
        }
    }
    return Verdict::accepted;
}

Verdict FanOrder::find_cell(const ViewAlong::Seen& edge, const PatchedSurface& surface, int& cell) const {
    bool undecided = false;
    for (std::size_t c = 0; c < fan_->cells.size(); ++c) {
        const Sign from_right = turn(spokes_[c].seen, edge);
        if (from_right == Sign::negative) {
            continue;
        }
        const Sign to_left = turn(edge, spokes_[(c + 1) % spokes_.size()].seen);
        if (from_right == Sign::positive && to_left == Sign::positive) {
            cell = static_cast<int>(c);
            return surface.cell(fan_->cells[c]).impassable ? Verdict::no_preimage : Verdict::accepted;
        }
        undecided = undecided || to_left != Sign::negative;
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
