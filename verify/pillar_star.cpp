#include <foldless/verify/pillar_star.h>

#include <foldless/verify/place.h>
#include <foldless/verify/winding.h>

#include <foldless/predicates/pillar.h>

#include <algorithm>
#include <cassert>

namespace foldless::verification {

std::optional<PillarStar> PillarStar::make(const BaseFaces& base, const Meshes& meshes, const OnPillar& vertex) {
    PillarStar star(base, meshes, vertex);
    return star.place_edges() ? std::optional(std::move(star)) : std::nullopt;
}

bool PillarStar::place_edges() {
    const auto base_moves = [&](std::int32_t face) { return base_->is_moving(face); };
    for (Fan& fan : base_->adjacency().fans(vertex_.base_vertex, base_moves)) {
        std::vector<std::int32_t> spokes = base_->adjacency().spokes(vertex_.base_vertex, fan);
        sectors_.push_back({std::move(fan), std::move(spokes)});
    }
    const auto scan_moves = [&](std::int32_t face) { return !base_->scan_face_is_frozen(face); };
    const std::vector<Fan> scan_fans = meshes_->scan_adjacency.fans(vertex_.scan_vertex, scan_moves);
    return std::all_of(scan_fans.begin(), scan_fans.end(), [&](const Fan& fan) { return place_fan(fan); });
}

/// Fans between frozen faces may lie over each other, seen along the direction. The right one is that which has the
/// fan's end edges, which are base edges.
bool PillarStar::place_fan(const Fan& scan_fan) {
    if (!scan_turns_once(scan_fan)) {
        return false;
    }
    for (std::size_t s = 0; s < sectors_.size(); ++s) {
        const std::size_t known = edges_.size();
        if (place_in(static_cast<int>(s), scan_fan)) {
            return true;
        }
        edges_.resize(known);
    }
    return false;
}

bool PillarStar::scan_turns_once(const Fan& scan_fan) const {
    const Vec3& centre = meshes_->scan.positions[vertex_.scan_vertex];
    Star star{{centre, base_->mesh().directions[vertex_.base_vertex]}, {}, scan_fan.closed};
    for (const std::int32_t spoke : meshes_->scan_adjacency.spokes(vertex_.scan_vertex, scan_fan)) {
        star.ends.push_back({meshes_->scan.positions[spoke], Vec3::Zero()});
    }
    return goes_round_once(star);
}

bool PillarStar::place_in(int sectors, const Fan& scan_fan) {
    for (const std::int32_t neighbour : meshes_->scan_adjacency.spokes(vertex_.scan_vertex, scan_fan)) {
        const std::optional<int> position = position_in(sectors, neighbour);
        if (!position) {
            return false;
        }
        edges_.push_back({neighbour, sectors, *position});
    }
    return go_round_once(sectors, scan_fan);
}

Sign PillarStar::turn_to_scan(std::int32_t spoke, std::int32_t neighbour) const {
    const BaseMesh& mesh = base_->mesh();
    const std::vector<Vec3>& positions = meshes_->scan.positions;
    return turn_from_base_edge({mesh.positions[vertex_.base_vertex], mesh.directions[vertex_.base_vertex]},
                               {mesh.positions[spoke], mesh.directions[spoke]}, vertex_.t,
                               {&positions[vertex_.scan_vertex], &positions[neighbour]});
}

std::optional<int> PillarStar::position_in(int sectors, std::int32_t neighbour) const {
    const Sectors& in = sectors_[sectors];
    const std::int32_t kept = base_->is_kept(vertex_.base_vertex) ? meshes_->kept.base_of[neighbour] : -1;
    const bool is_base_edge = kept >= 0 && (base_->adjacency().face_with(vertex_.base_vertex, kept) >= 0 ||
                                            base_->adjacency().face_with(kept, vertex_.base_vertex) >= 0);
    if (is_base_edge) {
        const auto spoke = std::find(in.spokes.begin(), in.spokes.end(), kept);
        return spoke == in.spokes.end() ? std::nullopt
                                        : std::optional(static_cast<int>(2 * (spoke - in.spokes.begin())));
    }
    // A sector turns by less than half a turn: the edge is inside if it is left of the first side and right of the
    // second, and along the first side if it has no turn from that but is right of the second.
    for (std::size_t c = 0; c < in.fan.faces.size(); ++c) {
        const Sign from_first = turn_to_scan(in.spokes[c], neighbour);
        if (from_first == Sign::negative ||
            turn_to_scan(in.spokes[(c + 1) % in.spokes.size()], neighbour) != Sign::negative) {
            continue;
        }
        return from_first == Sign::positive ? std::optional(static_cast<int>(2 * c + 1))
                                            : position_along(sectors, c, neighbour);
    }
    return std::nullopt;
}

/// The position of an edge seen along a base edge.
std::optional<int> PillarStar::position_along(int sectors, std::size_t spoke, std::int32_t neighbour) const {
    const Sectors& in = sectors_[sectors];
    const MovingFace& left = base_->face(in.fan.faces[spoke]);
    const std::vector<Vec3>& positions = meshes_->scan.positions;
    const Sign into_left = leaves_wall_into(left.triangle, corner_of(left.corners, vertex_.base_vertex), vertex_.t,
                                            {&positions[vertex_.scan_vertex], &positions[neighbour]});
    if (into_left == Sign::positive) {
        return static_cast<int>(2 * spoke + 1);
    }
    if (spoke == 0 && !in.fan.closed) {
        return std::nullopt;
    }
    const std::size_t right = (spoke + in.fan.faces.size() - 1) % in.fan.faces.size();
    const bool is_right = into_left == Sign::negative || in.fan.faces[right] < in.fan.faces[spoke];
    return static_cast<int>(2 * (is_right ? right : spoke) + 1);
}

int PillarStar::steps(const Sectors& sectors, int from, int to) const {
    const int around = static_cast<int>(2 * sectors.fan.faces.size());
    return sectors.fan.closed ? (to - from + around) % around : to - from;
}

/// Each scan face goes forward by the shorter way round (N.n > 0 at the vertex), all of them once around or less.
bool PillarStar::go_round_once(int sectors, const Fan& scan_fan) const {
    const Sectors& in = sectors_[sectors];
    int total = 0;
    for (const std::int32_t f : scan_fan.faces) {
        const Triangle& face = meshes_->scan.faces[f];
        const int k = corner_of(face, vertex_.scan_vertex);
        const int forward = steps(in, edge(face[(k + 1) % 3]).position, edge(face[(k + 2) % 3]).position);
        if (forward < 0) {
            return false;
        }
        total += forward;
    }
    const int around = static_cast<int>(2 * in.fan.faces.size());
    return in.fan.closed && scan_fan.closed ? total == around : total <= around;
}

const PillarStar::Edge& PillarStar::edge(std::int32_t neighbour) const {
    const auto found =
        std::find_if(edges_.begin(), edges_.end(), [&](const Edge& e) { return e.neighbour == neighbour; });
    assert(found != edges_.end());
    return *found;
}

std::int32_t PillarStar::start_face(std::int32_t neighbour) const {
    const Edge& at = edge(neighbour);
    return sectors_[at.sectors].fan.faces[at.position / 2];
}

void PillarStar::between(std::int32_t first, std::int32_t second, std::vector<std::int32_t>& spokes,
                         std::vector<std::int32_t>& faces) const {
    const Edge& from = edge(first);
    const Sectors& in = sectors_[from.sectors];
    const int forward = steps(in, from.position, edge(second).position);
    for (int step = 0; step <= forward; ++step) {
        const int position = from.position + step;
        const auto index = static_cast<std::size_t>(position / 2);
        if (position % 2 != 0) {
            faces.push_back(in.fan.faces[index % in.fan.faces.size()]);
        } else if (step > 0 && step < forward) {
            spokes.push_back(in.spokes[index % in.spokes.size()]);
        }
    }
}

} // namespace foldless::verification
