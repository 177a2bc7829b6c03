#include <foldless/verify/association.h>

#include <foldless/verify/edge_trace.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace foldless::verification {
namespace {

bool share_face(const std::vector<Foothold>& a, const std::vector<Foothold>& b) {
    return std::any_of(a.begin(), a.end(), [&](const Foothold& x) {
        return std::any_of(b.begin(), b.end(), [&](const Foothold& y) { return x.face == y.face; });
    });
}

void add_vertex_violation(Findings& findings, Violation violation, std::int32_t vertex, const Vec3& position) {
    findings.add({.violation = violation, .scan_vertex = vertex, .position = position});
}

} // namespace

bool Associator::is_used(std::int32_t vertex) const {
    const auto faces = scan_adjacency_.faces_around(vertex);
    return std::any_of(faces.begin(), faces.end(), [&](std::int32_t f) { return !base_.scan_face_is_frozen(f); });
}

Place Associator::locate_kept(std::int32_t vertex, Findings& findings) const {
    const std::int32_t base_vertex = kept_.base_of[vertex];
    std::vector<Foothold> around;
    footholds_at(base_, base_vertex, around);
    const bool in_ranges = std::all_of(around.begin(), around.end(), [&](const Foothold& foothold) {
        return within(base_.face(foothold.face).range, 0.0, 0.0) == Sign::positive;
    });
    if (around.empty() || !in_ranges) {
        add_vertex_violation(findings, Violation::no_preimage, vertex, scan_.positions[vertex]);
        return {};
    }
    return {.kept = base_vertex};
}

/// Finds the place of a vertex if it has one; true if it has several.
bool Associator::locate_vertex(std::int32_t vertex, Place& place, Findings& findings) const {
    if (!is_used(vertex)) {
        return false;
    }
    if (kept_.base_of[vertex] >= 0) {
        place = locate_kept(vertex, findings);
        return false;
    }
    const Vec3& q = scan_.positions[vertex];
    const Located located = locate(base_, index_, q);
    switch (located.multiplicity) {
    case Multiplicity::none: add_vertex_violation(findings, Violation::no_preimage, vertex, q); return false;
    case Multiplicity::undecided: add_vertex_violation(findings, Violation::undecided, vertex, q); return false;
    case Multiplicity::several: return true;
    case Multiplicity::one: place = located.places.front(); return false;
    }
    return false;
}

Association Associator::associate(Stages& stages, double share, Findings& findings) const {
    const std::size_t vertices = scan_.positions.size();
    Association association{std::vector<Place>(vertices)};
    std::vector<std::uint8_t> has_several(vertices, 0); // no vector<bool>, whose elements share bytes between threads
    stages.for_each(vertices, share, [&](std::size_t v) {
        has_several[v] = locate_vertex(static_cast<std::int32_t>(v), association.places[v], findings) ? 1 : 0;
    });
    std::vector<std::int32_t> several;
    for (std::size_t v = 0; v < vertices; ++v) {
        if (has_several[v] != 0) {
            several.push_back(static_cast<std::int32_t>(v));
        }
    }
    resolve(several, association);
    for (const std::int32_t vertex : several) {
        if (has_another_nearby(vertex, association.places[vertex])) {
            add_vertex_violation(findings, Violation::several_preimages, vertex, scan_.positions[vertex]);
        } else {
            ++association.ambiguous_vertices;
        }
    }
    return association;
}

bool Associator::has_another_nearby(std::int32_t vertex, const Place& place) const {
    const Located located = locate(base_, index_, scan_.positions[vertex]);
    return std::any_of(located.places.begin(), located.places.end(), [&](const Place& other) {
        return other.in.face != place.in.face && are_adjacent(base_, other.in.face, place.in.face);
    });
}

/// The one of several places to which the edge leads from the neighbour, whose place is known.
Place Associator::reached_from(std::int32_t neighbour, std::int32_t vertex, const Association& association,
                               const std::vector<Place>& candidates) const {
    std::vector<Foothold> starts;
    footholds(base_, association.places[neighbour], starts);
    const Line line{scan_.positions[neighbour], scan_.positions[vertex]};
    for (const Place& candidate : candidates) {
        std::vector<Foothold> ends;
        footholds(base_, candidate, ends);
        const bool leads_there = base_.constant_directions()
                                     ? share_face(starts, ends)
                                     : trace(base_, line, starts, ends).outcome == Trace::Outcome::followed;
        if (leads_there) {
            return candidate;
        }
    }
    return {};
}

std::vector<std::int32_t> Associator::placed_neighbours(std::int32_t vertex, const Association& association) const {
    std::vector<std::int32_t> result;
    for (const std::int32_t face : scan_adjacency_.faces_around(vertex)) {
        for (const std::int32_t neighbour : scan_.faces[face]) {
            if (neighbour != vertex && association.places[neighbour].exists()) {
                result.push_back(neighbour);
            }
        }
    }
    return result;
}

Place Associator::continued(std::int32_t vertex, const Association& association) const {
    const std::vector<std::int32_t> neighbours = placed_neighbours(vertex, association);
    if (neighbours.empty()) {
        return {};
    }
    const Located located = locate(base_, index_, scan_.positions[vertex]);
    for (const std::int32_t neighbour : neighbours) {
        Place place = reached_from(neighbour, vertex, association, located.places);
        if (place.exists()) {
            return place;
        }
    }
    return {};
}

Place Associator::nearest(std::int32_t vertex) const {
    const std::vector<Place> places = locate(base_, index_, scan_.positions[vertex]).places;
    return *std::min_element(places.begin(), places.end(), [&](const Place& a, const Place& b) {
        return std::abs(displacement(base_, a)) < std::abs(displacement(base_, b));
    });
}

/// Takes from `waiting` all vertices that scan edges between waiting ones connect with `first`, and that itself.
void Associator::take_part(std::int32_t first, std::vector<bool>& waiting) const {
    const auto is_waiting = [&](std::int32_t vertex) { return waiting[vertex]; };
    std::vector<std::int32_t> front{first};
    while (!front.empty()) {
        const std::int32_t vertex = front.back();
        front.pop_back();
        waiting[vertex] = false;
        for (const std::int32_t face : scan_adjacency_.faces_around(vertex)) {
            const Triangle& corners = scan_.faces[face];
            std::copy_if(corners.begin(), corners.end(), std::back_inserter(front), is_waiting);
        }
    }
}

/// The lowest vertex of every set of `open` vertices that scan edges between them connect; `open` is ascending.
std::vector<std::int32_t> Associator::first_of_each_part(const std::vector<std::int32_t>& open) const {
    std::vector<bool> waiting(scan_.positions.size(), false);
    for (const std::int32_t vertex : open) {
        waiting[vertex] = true;
    }
    std::vector<std::int32_t> result;
    for (const std::int32_t vertex : open) {
        if (waiting[vertex]) {
            result.push_back(vertex);
            take_part(vertex, waiting);
        }
    }
    return result;
}

/// When continuity helps no further: the nearest place for every vertex to which no edge leads from the neighbours that
/// it has (its edges will be found broken), or else for the first one of each part, since one vertex fixes the lift of
/// all that it is connected with.
void Associator::break_deadlock(const std::vector<std::int32_t>& open, Association& association) const {
    std::vector<std::int32_t> stranded;
    std::copy_if(open.begin(), open.end(), std::back_inserter(stranded),
                 [&](std::int32_t vertex) { return !placed_neighbours(vertex, association).empty(); });
    for (const std::int32_t vertex : stranded.empty() ? first_of_each_part(open) : stranded) {
        association.places[vertex] = nearest(vertex);
    }
}

/// Gives every vertex with several places the one that continues those of its neighbours, in rounds: a round reads only
/// what the rounds before it found, so the order within a round does not matter.
void Associator::resolve(std::vector<std::int32_t> open, Association& association) const {
    while (!open.empty()) {
        std::vector<Place> found(open.size());
        tbb::parallel_for(std::size_t(0), open.size(),
                          [&](std::size_t i) { found[i] = continued(open[i], association); });
        for (std::size_t i = 0; i < open.size(); ++i) {
            association.places[open[i]] = found[i];
        }
        if (std::none_of(found.begin(), found.end(), [](const Place& place) { return place.exists(); })) {
            break_deadlock(open, association);
        }
        std::erase_if(open, [&](std::int32_t vertex) { return association.places[vertex].exists(); });
    }
}

} // namespace foldless::verification
