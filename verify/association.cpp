#include <foldless/verify/association.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace foldless::verification {

// --- Association -----------------------------------------------------------------------------------------------------

Association::Association(const BaseFaces& base, const Meshes& meshes)
    : base_(&base), meshes_(&meshes), places_(meshes.scan.positions.size()),
      star_of_(meshes.scan.positions.size(), -1) {}

const PillarStar* Association::star(std::int32_t vertex) const {
    return star_of_[vertex] < 0 ? nullptr : &stars_[star_of_[vertex]];
}

bool Association::set(std::int32_t vertex, const Place& place) {
    if (place.pillar >= 0 && !base_->constant_directions()) {
        std::optional<PillarStar> star = PillarStar::make(*base_, *meshes_, {vertex, place.pillar, place.at.t});
        if (!star) {
            return false;
        }
        star_of_[vertex] = static_cast<std::int32_t>(stars_.size());
        stars_.push_back(std::move(*star));
    }
    places_[vertex] = place;
    return true;
}

bool Association::is_base_edge(std::int32_t a, std::int32_t b) const {
    const std::int32_t i = meshes_->kept.base_of[a];
    const std::int32_t j = meshes_->kept.base_of[b];
    return i >= 0 && j >= 0 && (base_->adjacency().face_with(i, j) >= 0 || base_->adjacency().face_with(j, i) >= 0);
}

FacePosition Association::start(std::int32_t a, std::int32_t b) const {
    const Place& place = places_[a];
    const PillarStar* const around = star(a);
    if (around == nullptr) {
        return {place.face, place.at};
    }
    const std::int32_t face = around->start_face(b);
    return {face, on_pillar(*base_, face, place.pillar, place.at.t)};
}

std::optional<std::vector<WallCrossing>> Association::follow(std::int32_t a, std::int32_t b) const {
    const std::vector<Vec3>& positions = meshes_->scan.positions;
    return trace(*base_, {&positions[a], &positions[b]}, start(a, b), start(b, a));
}

// --- Associator ------------------------------------------------------------------------------------------------------

bool Associator::is_used(std::int32_t vertex) const {
    const auto faces = scan_adjacency_.faces_around(vertex);
    return std::any_of(faces.begin(), faces.end(), [&](std::int32_t f) { return !base_.scan_face_is_frozen(f); });
}

Associator::Answer Associator::locate_kept(std::int32_t base_vertex) const {
    std::int32_t lowest = -1;
    bool in_ranges = true;
    for (const std::int32_t face : base_.adjacency().faces_around(base_vertex)) {
        if (base_.is_moving(face)) {
            lowest = lowest < 0 ? face : lowest;
            in_ranges = in_ranges && within(Displacement(), base_.face(face).range) != Sign::negative;
        }
    }
    if (lowest < 0 || !in_ranges) {
        return {{}, false, Violation::no_preimage};
    }
    return {{lowest, on_pillar(base_, lowest, base_vertex, Displacement()), base_vertex}, false, std::nullopt};
}

Associator::Answer Associator::locate_vertex(std::int32_t vertex) const {
    if (!is_used(vertex)) {
        return {};
    }
    if (meshes_.kept.base_of[vertex] >= 0) {
        return locate_kept(meshes_.kept.base_of[vertex]);
    }
    const Located located = locate(base_, index_, scan_.positions[vertex]);
    if (located.places.empty()) {
        return {{}, false, located.on_open_wall ? Violation::border : Violation::no_preimage};
    }
    if (located.places.size() > 1) {
        return {{}, true, std::nullopt};
    }
    // The pillar of a kept vertex belongs to that vertex alone.
    const Place& place = located.places.front();
    const bool taken = place.pillar >= 0 && base_.is_kept(place.pillar);
    return taken ? Answer{{}, false, Violation::kept_vertex} : Answer{place, false, std::nullopt};
}

Association Associator::associate(Stages& stages, double share, Findings& findings) const {
    const std::size_t vertices = scan_.positions.size();
    std::vector<Answer> answers(vertices);
    stages.for_each(vertices, share, [&](std::size_t v) { answers[v] = locate_vertex(static_cast<std::int32_t>(v)); });
    Association association(base_, meshes_);
    const auto report = [&](std::int32_t vertex, Violation violation, const Place& place) {
        findings.add({.violation = violation,
                      .scan_vertex = vertex,
                      .base_face = place.face,
                      .position = scan_.positions[vertex]});
    };
    std::vector<std::int32_t> several;
    for (std::size_t v = 0; v < vertices; ++v) {
        const auto vertex = static_cast<std::int32_t>(v);
        const Answer& answer = answers[v];
        if (answer.violation) {
            report(vertex, *answer.violation, answer.place);
        } else if (answer.several) {
            several.push_back(vertex);
        } else if (answer.place.exists() && !association.set(vertex, answer.place)) {
            report(vertex, Violation::orientation, answer.place);
        }
    }
    resolve(several, association);
    for (const std::int32_t vertex : several) {
        const Place& place = association.place(vertex);
        if (!place.exists()) {
            report(vertex, Violation::orientation, place);
        } else if (has_another_nearby(vertex, place)) {
            report(vertex, Violation::several_preimages, place);
        } else {
            ++association.ambiguous_vertices;
        }
    }
    return association;
}

bool Associator::has_another_nearby(std::int32_t vertex, const Place& place) const {
    const Located located = locate(base_, index_, scan_.positions[vertex]);
    return std::any_of(located.places.begin(), located.places.end(), [&](const Place& other) {
        return other.face != place.face && are_adjacent(base_, other.face, place.face);
    });
}

std::vector<std::int32_t> Associator::placed_neighbours(std::int32_t vertex, const Association& association) const {
    std::vector<std::int32_t> result;
    for (const std::int32_t face : scan_adjacency_.faces_around(vertex)) {
        for (const std::int32_t neighbour : scan_.faces[face]) {
            if (neighbour != vertex && association.has_place(neighbour)) {
                result.push_back(neighbour);
            }
        }
    }
    return result;
}

/// The place to which an edge leads from a neighbour whose place is known. With constant face directions the two share
/// a face.
Place Associator::continued(std::int32_t vertex, const Association& association) const {
    const std::vector<std::int32_t> neighbours = placed_neighbours(vertex, association);
    if (neighbours.empty()) {
        return {};
    }
    const std::vector<Place> candidates = locate(base_, index_, scan_.positions[vertex]).places;
    for (const std::int32_t neighbour : neighbours) {
        for (const Place& candidate : candidates) {
            if (base_.constant_directions()) {
                if (candidate.face == association.place(neighbour).face) {
                    return candidate;
                }
                continue;
            }
            if (candidate.pillar >= 0) {
                continue; // no way to tell in which face its edges start; other vertices decide
            }
            const ScanLine line{&scan_.positions[neighbour], &scan_.positions[vertex]};
            if (trace(base_, line, association.start(neighbour, vertex), {candidate.face, candidate.at})) {
                return candidate;
            }
        }
    }
    return {};
}

/// Gives places to the open vertices that continue those of their neighbours, in rounds, and takes them out: a round
/// reads only what the rounds before it found, so the order within a round does not matter.
void Associator::continue_from_neighbours(std::vector<std::int32_t>& open, Association& association) const {
    bool goes_on = !open.empty();
    while (goes_on) {
        std::vector<Place> found(open.size());
        tbb::parallel_for(std::size_t(0), open.size(),
                          [&](std::size_t i) { found[i] = continued(open[i], association); });
        goes_on = false;
        for (std::size_t i = 0; i < open.size(); ++i) {
            goes_on = (found[i].exists() && association.set(open[i], found[i])) || goes_on;
        }
        std::erase_if(open, [&](std::int32_t vertex) { return association.has_place(vertex); });
    }
}

void Associator::resolve(std::vector<std::int32_t> open, Association& association) const {
    continue_from_neighbours(open, association);
    while (!open.empty()) {
        const std::size_t before = open.size();
        break_deadlock(open, association);
        std::erase_if(open, [&](std::int32_t vertex) { return association.has_place(vertex); });
        continue_from_neighbours(open, association);
        if (open.size() == before) {
            return; // K fails at the rest
        }
    }
}

/// All vertices that scan edges between waiting ones connect with `first`; they wait no longer.
std::vector<std::int32_t> Associator::part_of(std::int32_t first, std::vector<std::uint8_t>& waiting) const {
    std::vector<std::int32_t> part{first};
    waiting[first] = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
        for (const std::int32_t face : scan_adjacency_.faces_around(part[i])) {
            for (const std::int32_t vertex : scan_.faces[face]) {
                if (waiting[vertex] != 0) {
                    waiting[vertex] = 0;
                    part.push_back(vertex);
                }
            }
        }
    }
    return part;
}

/// The places of a vertex, nearest first.
std::vector<Place> Associator::by_distance(std::int32_t vertex) const {
    const Vec3& q = scan_.positions[vertex];
    std::vector<Place> places = locate(base_, index_, q).places;
    std::stable_sort(places.begin(), places.end(), [&](const Place& a, const Place& b) {
        return std::abs(displacement(base_, a, q)) < std::abs(displacement(base_, b, q));
    });
    return places;
}

/// When continuity helps no further: the nearest place for every vertex to which no edge leads from the neighbours that
/// it has (its edges will be found broken), or else each part of the scan that has no place at all as a whole.
void Associator::break_deadlock(const std::vector<std::int32_t>& open, Association& association) const {
    std::vector<std::int32_t> stranded;
    std::copy_if(open.begin(), open.end(), std::back_inserter(stranded),
                 [&](std::int32_t vertex) { return !placed_neighbours(vertex, association).empty(); });
    for (const std::int32_t vertex : stranded) {
        static_cast<void>(association.set(vertex, by_distance(vertex).front()));
    }
    if (!stranded.empty()) {
        return;
    }
    std::vector<std::uint8_t> waiting(scan_.positions.size(), 0);
    for (const std::int32_t vertex : open) {
        waiting[vertex] = 1;
    }
    for (const std::int32_t vertex : open) {
        if (waiting[vertex] != 0) {
            place_part(part_of(vertex, waiting), association);
        }
    }
}

/// One vertex fixes the lift of all that it is connected with: its places are tried, nearest first.
void Associator::place_part(const std::vector<std::int32_t>& part, Association& association) const {
    const std::vector<Place> places = by_distance(part.front());
    for (const Place& seed : places) {
        Association attempt(base_, meshes_);
        if (!attempt.set(part.front(), seed)) {
            continue;
        }
        std::vector<std::int32_t> open(part.begin() + 1, part.end());
        continue_from_neighbours(open, attempt);
        const bool is_last = &seed == &places.back();
        if ((open.empty() && is_closed(part, attempt)) || is_last) {
            for (const std::int32_t vertex : part) {
                if (attempt.has_place(vertex)) {
                    static_cast<void>(association.set(vertex, attempt.place(vertex)));
                }
            }
            return;
        }
    }
}

/// Whether every edge between vertices of the part can be followed.
bool Associator::is_closed(const std::vector<std::int32_t>& part, const Association& association) const {
    const auto is_followed = [&](std::int32_t a, std::int32_t b) {
        return !association.has_place(b) || base_.constant_directions() || association.is_base_edge(a, b) ||
               association.follow(a, b).has_value();
    };
    return std::all_of(part.begin(), part.end(), [&](std::int32_t vertex) {
        const auto around = scan_adjacency_.faces_around(vertex);
        return std::all_of(around.begin(), around.end(), [&](std::int32_t face) {
            const Triangle& corners = scan_.faces[face];
            const int k = corner_of(corners, vertex);
            return is_followed(vertex, corners[(k + 1) % 3]) && is_followed(vertex, corners[(k + 2) % 3]);
        });
    });
}

} // namespace foldless::verification
