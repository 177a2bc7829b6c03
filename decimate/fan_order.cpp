#include <foldless/decimate/fan_order.h>

#include <foldless/predicates/pillar.h>
#include <foldless/predicates/scan_normal.h>

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
    centre_ = surface.vertex(vertex_).position;
    direction_ = surface.vertex(vertex_).direction;
    const ViewAlong view(direction_);
    spokes_.clear();
    for (const std::int32_t spoke : fan_->spokes) {
        const BaseVertex end = surface.vertex(spoke);
        spokes_.push_back({end.scan_vertex, {end.position, view.see(end.position - centre_)}});
    }
}

Sign FanOrder::follows(const Sighting& a, const Sighting& b) const {
    const Sign sign = turn(a.seen, b.seen);
    return sign == Sign::undecided ? seen_along(direction_, {centre_, a.end, b.end}) : sign;
}

Verdict FanOrder::sort_edges(std::int32_t scan_vertex, const PatchedSurface& surface, const Scan& scan,
                             const ScanTopology& topology) {
    edges_.clear();
    const ViewAlong view(direction_);
    const auto sighting = [&](std::int32_t v) {
        return Sighting{scan.positions[v], view.see(scan.positions[v] - centre_)};
    };
    for (const std::int32_t f : topology.faces_around(scan_vertex)) {
        const Triangle& face = scan.faces[f];
        const int k = face[0] == scan_vertex ? 0 : face[1] == scan_vertex ? 1 : 2;
        // Every edge is the first of one face, but for the last at a border.
        const std::int32_t first = face[(k + 1) % 3];
        const std::int32_t second = face[(k + 2) % 3];
        Verdict verdict = add_edge(first, sighting(first), surface);
        if (verdict == Verdict::accepted && topology.border_successor(second) == scan_vertex) {
            verdict = add_edge(second, sighting(second), surface);
        }
        if (verdict != Verdict::accepted) {
            return verdict;
        }
    }
    return Verdict::accepted;
}

Verdict FanOrder::add_edge(std::int32_t neighbour, const Sighting& edge, const PatchedSurface& surface) {
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
    const Sighting& edge = spokes_[spoke].sighting;
    for (std::size_t c = first; c < last; ++c) {
        const bool behind_right = follows(spokes_[c % spokes_.size()].sighting, edge) == Sign::negative;
        if (!behind_right && follows(edge, spokes_[(c + 1) % spokes_.size()].sighting) != Sign::negative) {
            return Verdict::jacobian; // within the sector, or along one of its sides
        }
    }
    return Verdict::accepted;
}

Verdict FanOrder::find_cell(const Sighting& edge, const PatchedSurface& surface, int& cell) const {
    for (std::size_t c = 0; c < fan_->cells.size(); ++c) {
        if (surface.cell(fan_->cells[c]).impassable) {
            continue; // perhaps seen from behind: it then covers others
        }
        const Sign from_right = follows(spokes_[c].sighting, edge);
        if (from_right == Sign::negative ||
            follows(edge, spokes_[(c + 1) % spokes_.size()].sighting) != Sign::positive) {
            continue;
        }
        if (from_right == Sign::positive) {
            cell = static_cast<int>(c);
            return Verdict::accepted;
        }
        return find_cell_along(c, edge, surface, cell);
    }
    return Verdict::no_preimage;
}

/// An edge that is seen along the base edge to spokes[c].
Verdict FanOrder::find_cell_along(std::size_t c, const Sighting& edge, const PatchedSurface& surface, int& cell) const {
    const int left = fan_->cells[c];
    const Sign into_left = leaves_wall_into(surface.cell(left).triangle, surface.corner_of(left, vertex_),
                                            Displacement(), {&centre_, &edge.end});
    if (into_left == Sign::positive) {
        cell = static_cast<int>(c);
        return Verdict::accepted;
    }
    if (c == 0 && !fan_->closed) {
        return Verdict::tie;
    }
    const std::size_t right = (c + fan_->cells.size() - 1) % fan_->cells.size();
    const bool is_right = into_left == Sign::negative || fan_->cells[right] < left;
    cell = static_cast<int>(is_right ? right : c);
    return surface.cell(fan_->cells[right]).impassable ? Verdict::tie : Verdict::accepted;
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
