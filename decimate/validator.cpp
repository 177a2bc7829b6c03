#include <foldless/decimate/validator.h>

#include <foldless/io/float32.h>
#include <foldless/predicates/jacobian.h>
#include <foldless/predicates/pillar.h>
#include <foldless/predicates/prismoid_line.h>
#include <foldless/predicates/prismoid_point.h>
#include <foldless/predicates/scan_orientation.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldless {
namespace {

/// The nearest float32 not above / not below the value.
double float_below(double value) {
    const double rounded = to_float32(value);
    const float infinity = std::numeric_limits<float>::infinity();
    return rounded > value ? std::nextafter(static_cast<float>(rounded), -infinity) : rounded;
}
double float_above(double value) {
    return -float_below(-value);
}

Verdict verdict_of(Sign sign, Verdict refusal) {
    if (sign == Sign::positive) {
        return Verdict::accepted;
    }
    return sign == Sign::undecided ? Verdict::undecided : refusal;
}

ScanTriangle triangle_of(const Scan& scan, std::int32_t f) {
    const Triangle& face = scan.faces[f];
    return {scan.positions[face[0]], scan.positions[face[1]], scan.positions[face[2]]};
}

} // namespace

Validator::Validator(const BaseSurface& base, const Scan& scan, const ScanTopology& topology,
                     const ValidatorOptions& options)
    : base_(&base), scan_(&scan), topology_(&topology), options_(options), surface_(base),
      face_stamp_(scan.faces.size(), 0), moved_(scan.positions.size()), ordered_(scan.positions.size()) {
    normals_.reserve(scan.faces.size());
    for (std::size_t f = 0; f < scan.faces.size(); ++f) {
        normals_.push_back(ScanNormal(triangle_of(scan, static_cast<std::int32_t>(f))).normalised());
    }
}

const std::vector<std::int32_t>& Validator::gather(const std::vector<std::int32_t>& removed) {
    ++stamp_;
    scan_faces_.clear();
    for (const std::int32_t face : removed) {
        for (const std::int32_t f : base_->face(face).scan_faces) {
            if (face_stamp_[f] != stamp_) {
                face_stamp_[f] = stamp_;
                scan_faces_.push_back(f);
            }
        }
    }
    return scan_faces_;
}

Verdict Validator::judge(const Patch& patch) {
    surface_.reset(patch, options_.constant_directions);
    const std::size_t count = patch.added.size();
    trial_.faces.resize(count);
    for (std::size_t c = 0; c < count; ++c) {
        trial_.faces[c].scan_faces.clear();
        trial_.faces[c].is_scan_face = surface_.cell(static_cast<int>(c)).impassable;
    }
    trial_.places.clear();
    traces_.clear();
    trial_.retested = 0;
    trial_.vertices_pass = false;
    const double infinity = std::numeric_limits<double>::infinity();
    hulls_.assign(count, {infinity, -infinity});

    Verdict verdict = location_.reset(surface_, options_.uniqueness);
    if (verdict == Verdict::accepted) {
        static_cast<void>(gather(patch.removed));
        verdict = ask_witness();
    }
    if (verdict == Verdict::accepted) {
        verdict = locate_vertices(patch);
        trial_.vertices_pass = verdict == Verdict::accepted;
    }
    if (verdict == Verdict::accepted) {
        verdict = reach_kept_corners(patch);
    }
    if (verdict == Verdict::accepted) {
        find_wall_planes();
        find_cone();
    }
    if (verdict == Verdict::accepted && !options_.constant_directions) {
        verdict = order_fans(patch);
    }
    if (verdict == Verdict::accepted) {
        verdict = test_faces();
    }
    if (verdict == Verdict::accepted) {
        verdict = close_ranges();
    }
    if (verdict == Verdict::accepted) {
        verdict = test_alternatives();
    }
    if (verdict == Verdict::accepted) {
        verdict = test_frozen_walls();
    }
    if (verdict == Verdict::accepted) {
        verdict = test_faces_beside();
    }
    const bool has_free_border = options_.trimmed && !options_.constant_directions;
    return verdict == Verdict::accepted && has_free_border ? test_borders() : verdict;
}

Verdict Validator::ask_witness() {
    // The candidates for an edge, and the edges around it, tend to fail at the same scan vertex: asked first, it saves
    // asking the others. Where it is content it is asked again in its turn, so that nothing depends on it but time.
    if (witness_ < 0 || base_->place(witness_).face < 0 || !surface_.removes(base_->place(witness_).face)) {
        return Verdict::accepted;
    }
    Lift lift{};
    return find_place(witness_, lift);
}

Verdict Validator::locate_vertices(const Patch& patch) {
    lifts_.clear();
    alternatives_.clear();
    for (const std::int32_t face : patch.removed) {
        for (std::int32_t v = base_->face(face).first_vertex; v >= 0; v = base_->next_on_face(v)) {
            const Verdict verdict = locate_vertex(v);
            if (verdict != Verdict::accepted) {
                return verdict;
            }
        }
    }
    for (const PatchVertex& changed : patch.changed) {
        const bool was_there = changed.index < static_cast<std::int32_t>(base_->vertex_slots());
        const std::int32_t v = was_there ? base_->vertex(changed.index).scan_vertex : -1;
        if (v >= 0 && changed.value.scan_vertex != v) { // kept no longer
            const Verdict verdict = locate_vertex(v);
            if (verdict != Verdict::accepted) {
                return verdict;
            }
        }
    }
    return Verdict::accepted;
}

Verdict Validator::find_place(std::int32_t v, Lift& lift) {
    ++trial_.retested;
    const Verdict verdict = location_.locate(scan_->positions[v], lift);
    return verdict != Verdict::accepted || options_.constant_directions ? verdict : test_normals_at(v, lift);
}

Verdict Validator::test_normals_at(std::int32_t v, const Lift& lift) const {
    const InterpolatedDirection d(surface_.cell(lift.cell).triangle.d, lift.at.alpha, lift.at.alpha_error);
    for (const std::int32_t f : topology_->faces_around(v)) {
        Sign sign = d.sees(normals_[f]);
        if (sign == Sign::undecided) {
            const BaseTriangle& triangle = surface_.cell(lift.cell).triangle;
            const Vec3& q = scan_->positions[v];
            sign = normal_condition_at(triangle, q, lift.point(triangle, q).t, triangle_of(*scan_, f));
        }
        if (sign != Sign::positive) {
            return verdict_of(sign, Verdict::normal_condition);
        }
    }
    return Verdict::accepted;
}

Verdict Validator::locate_vertex(std::int32_t v) {
    Lift lift{};
    const Verdict verdict = find_place(v, lift);
    if (verdict != Verdict::accepted) {
        witness_ = v;
        return verdict;
    }
    for (const Lift& other : location_.alternatives()) {
        alternatives_.emplace_back(v, other);
    }
    moved_[v] = {stamp_, static_cast<std::int32_t>(lifts_.size())};
    lifts_.push_back(lift);
    trial_.places.push_back({v, lift.cell, lift.at.alpha, lift.at.t});
    const Displacement t = lift.point(surface_.cell(lift.cell).triangle, scan_->positions[v]).t;
    Verdict reached = reach(lift.cell, t);
    for (int k = 0; k < 3 && reached == Verdict::accepted; ++k) {
        const int beside = (lift.walls & wall_bit(k)) == 0 ? border : surface_.neighbour(lift.cell, k);
        reached = beside == border ? Verdict::accepted : reach(beside, t);
    }
    return reached;
}

Verdict Validator::reach_kept_corners(const Patch& patch) {
    for (std::size_t c = 0; c < patch.added.size(); ++c) {
        const std::array<bool, 3>& kept = surface_.cell(static_cast<int>(c)).kept;
        if (!trial_.faces[c].is_scan_face && (kept[0] || kept[1] || kept[2])) {
            const Verdict verdict = reach(static_cast<int>(c), Displacement());
            if (verdict != Verdict::accepted) {
                return verdict;
            }
        }
    }
    return Verdict::accepted;
}

void Validator::find_wall_planes() {
    planes_.clear();
    for (int c = 0; c < surface_.new_cells(); ++c) {
        planes_.emplace_back(surface_.cell(c).triangle, hulls_[c]);
    }
    behind_.clear();
    for (std::size_t n = 0; n < lifts_.size(); ++n) {
        behind_.push_back(planes_[lifts_[n].cell].behind(scan_->positions[trial_.places[n].scan_vertex]));
    }
}

void Validator::find_cone() {
    directions_.clear();
    for (int c = 0; c < surface_.new_cells(); ++c) {
        const std::array<Vec3, 3>& d = surface_.cell(c).triangle.d;
        directions_.insert(directions_.end(), d.begin(), d.end());
    }
    cone_ = DirectionCone(directions_);
}

Verdict Validator::order_fans(const Patch& patch) {
    orders_used_ = 0;
    for (std::size_t c = 0; c < patch.added.size(); ++c) {
        for (const std::int32_t v : patch.added[c].corners) {
            const std::int32_t scan_vertex = surface_.vertex(v).scan_vertex;
            if (scan_vertex < 0 || ordered_[scan_vertex].stamp == stamp_) {
                continue;
            }
            if (orders_used_ == orders_.size()) {
                orders_.emplace_back();
            }
            const Verdict verdict = order_fan(v, scan_vertex);
            if (verdict != Verdict::accepted) {
                return verdict;
            }
        }
    }
    return Verdict::accepted;
}

Verdict Validator::order_fan(std::int32_t base_vertex, std::int32_t scan_vertex) {
    const Verdict verdict = orders_[orders_used_].reset(base_vertex, surface_, *scan_, *topology_);
    if (verdict == Verdict::accepted) {
        ordered_[scan_vertex] = {stamp_, static_cast<std::int32_t>(orders_used_)};
        ++orders_used_;
    }
    return verdict;
}

const FanOrder* Validator::order_of(std::int32_t base_vertex, std::int32_t scan_vertex) {
    if (ordered_[scan_vertex].stamp == stamp_) {
        return &orders_[ordered_[scan_vertex].order];
    }
    // orders_ grows between faces only, so that pointers stay valid.
    const bool known = orders_used_ < orders_.size() && order_fan(base_vertex, scan_vertex) == Verdict::accepted;
    return known ? &orders_[ordered_[scan_vertex].order] : nullptr;
}

Verdict Validator::corner(std::int32_t scan_vertex, Corner& out) {
    out.scan_vertex = scan_vertex;
    out.cell = -1;
    out.order = nullptr;
    const std::int32_t n = moved(scan_vertex);
    if (n >= 0) {
        out.cell = lifts_[n].cell;
        out.lift = lifts_[n];
        return Verdict::accepted;
    }
    const Place& place = base_->place(scan_vertex);
    if (place.kept >= 0) {
        if (!options_.constant_directions) {
            out.order = order_of(place.kept, scan_vertex);
        }
        return out.order != nullptr || options_.constant_directions ? Verdict::accepted : Verdict::orientation;
    }
    out.cell = surface_.cell_of(place.face);
    const BaseTriangle& triangle = surface_.cell(out.cell).triangle;
    const Vec3& q = scan_->positions[scan_vertex];
    const std::optional<Enclosure> at = enclose(triangle, q, place.alpha, place.t);
    const std::optional<Lift> lift = at ? lift_of(out.cell, triangle, q, *at) : std::nullopt;
    if (!lift) {
        return Verdict::undecided;
    }
    // A corner on the rim of the patch was with the outer cell; now the new one is the lower.
    out.lift = in_lower_cell(surface_, *lift);
    out.cell = out.lift.cell;
    return lift->walls == 0 ? Verdict::accepted : reach(out.cell, point_in(out.cell, out).t);
}

/// Where a corner lies in a cell that holds it.
PrismoidPoint Validator::point_in(int cell, const Corner& corner) const {
    if (corner.order != nullptr) {
        return {Displacement(), walls_at_corner(surface_.corner_of(cell, corner.order->vertex()))};
    }
    return corner.lift.point(surface_.cell(cell).triangle, scan_->positions[corner.scan_vertex]);
}

void Validator::touch(int cell, std::int32_t scan_face) {
    if (cell < 0 || cell >= surface_.new_cells()) {
        return;
    }
    std::vector<std::int32_t>& faces = trial_.faces[cell].scan_faces;
    if (faces.empty() || faces.back() != scan_face) { // one scan face is tested at a time
        faces.push_back(scan_face);
    }
}

void Validator::extend_hull(int cell, Range t) {
    hulls_[cell].lo = std::min(hulls_[cell].lo, t.lo);
    hulls_[cell].hi = std::max(hulls_[cell].hi, t.hi);
}

Verdict Validator::reach(int cell, const Displacement& t) {
    if (cell < surface_.new_cells()) {
        extend_hull(cell, t.bounds());
        return Verdict::accepted;
    }
    return within(t, surface_.cell(cell).range) == Sign::negative ? Verdict::out_of_range : Verdict::accepted;
}

/// The pillar of a base vertex inside the scan face: its displacement there is in the range of all faces around it.
Verdict Validator::reach_pillar(std::int32_t vertex, const ScanTriangle& q, std::int32_t scan_face) {
    const DisplacedVertex pillar{surface_.vertex(vertex).position, surface_.vertex(vertex).direction};
    for (const int cell : surface_.fan(vertex).cells) {
        touch(cell, scan_face);
        if (cell < surface_.new_cells()) {
            extend_hull(cell, displacement_at_plane(pillar, q));
        } else if (!meets_plane_within(pillar, q, surface_.cell(cell).range)) {
            return Verdict::out_of_range;
        }
    }
    return Verdict::accepted;
}

int Validator::common_cell(const std::array<Corner, 3>& corners) const {
    int common = -1;
    for (const Corner& corner : corners) {
        if (corner.cell >= 0) {
            if (common >= 0 && common != corner.cell) {
                return -1;
            }
            common = corner.cell;
        }
    }
    // All kept: the face lies where its first edge that is no base edge starts.
    for (int k = 0; common < 0 && k < 3; ++k) {
        const std::int32_t next = corners[(k + 1) % 3].scan_vertex;
        if (!corners[k].order->is_base_edge(next)) {
            common = corners[k].order->start_cell(next);
        }
    }
    if (common < 0) { // a base triangle: counter-clockwise of the base edge to the next corner
        const int position = corners[0].order->position(corners[1].scan_vertex);
        const int cells = static_cast<int>(corners[0].order->fan().cells.size());
        common = position / 2 < cells ? corners[0].order->fan().cells[position / 2] : -1;
    }
    return common;
}

Verdict Validator::stays_in(int cell, const std::array<Corner, 3>& corners) const {
    // `undecided` here only means: not by this short way.
    Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (int k = 0; k < 3; ++k) {
        const Corner& corner = corners[k];
        const Range t = corner.order == nullptr ? point_in(cell, corner).t.bounds() : Range{0.0, 0.0};
        range.lo = std::min(range.lo, t.lo);
        range.hi = std::max(range.hi, t.hi);
        if (corner.order == nullptr) {
            continue;
        }
        if (surface_.corner_of(cell, corner.order->vertex()) < 0) {
            return Verdict::undecided;
        }
        for (const int other : {(k + 1) % 3, (k + 2) % 3}) {
            const std::int32_t neighbour = corners[other].scan_vertex;
            if (!corner.order->is_base_edge(neighbour) && corner.order->start_cell(neighbour) != cell) {
                return Verdict::undecided;
            }
        }
    }
    for (int k = 0; k < 3; ++k) {
        const Corner& a = corners[k];
        const Corner& b = corners[(k + 1) % 3];
        if (a.order != nullptr && a.order->is_base_edge(b.scan_vertex)) {
            continue;
        }
        const ScanLine line{&scan_->positions[a.scan_vertex], &scan_->positions[b.scan_vertex]};
        if (certainly_stays_in(surface_.cell(cell), *line.to - *line.from, range)) {
            continue;
        }
        const PrismoidPoint end = point_in(cell, b);
        if (follow_line(surface_.cell(cell).triangle, line, point_in(cell, a), &end).kind != Passage::Kind::ends) {
            return Verdict::undecided;
        }
    }
    return Verdict::accepted;
}

std::int32_t Validator::moved(std::int32_t scan_vertex) const {
    const Moved& moved = moved_[scan_vertex];
    return moved.stamp == stamp_ ? moved.lift : -1;
}

/// Whether all three corners lie on one new cell and behind the planes along its walls: then so does the whole face.
bool Validator::is_inside_one_cell(const std::array<std::int32_t, 3>& moved) const {
    return moved[0] >= 0 && moved[1] >= 0 && moved[2] >= 0 && lifts_[moved[0]].cell == lifts_[moved[1]].cell &&
           lifts_[moved[0]].cell == lifts_[moved[2]].cell &&
           (behind_[moved[0]] & behind_[moved[1]] & behind_[moved[2]]) == WallPlanes::all;
}

Verdict Validator::test_inside(std::int32_t scan_face, const std::array<std::int32_t, 3>& moved) {
    const int cell = lifts_[moved[0]].cell;
    touch(cell, scan_face);
    if (!options_.orientation) {
        return Verdict::accepted;
    }
    std::array<Corner, 3> corners{};
    for (int k = 0; k < 3; ++k) {
        corners[k] = {scan_->faces[scan_face][k], cell, nullptr, lifts_[moved[k]]};
    }
    return test_orientation(cell, corners);
}

Verdict Validator::test_faces() {
    // The last culprit first, as in ask_witness(). The order of the lists of scan faces depends on it, no verdict does.
    const auto witness = std::find(scan_faces_.begin(), scan_faces_.end(), face_witness_);
    if (witness != scan_faces_.end()) {
        std::iter_swap(scan_faces_.begin(), witness);
    }
    for (const std::int32_t f : scan_faces_) {
        const Verdict verdict = test_face(f);
        if (verdict != Verdict::accepted) {
            face_witness_ = f;
            return verdict;
        }
    }
    return Verdict::accepted;
}

Verdict Validator::test_face(std::int32_t scan_face) {
    const Triangle& face = scan_->faces[scan_face];
    const std::array<std::int32_t, 3> places{moved(face[0]), moved(face[1]), moved(face[2])};
    if (!options_.constant_directions && is_inside_one_cell(places)) {
        return test_inside(scan_face, places);
    }
    std::array<Corner, 3> corners{};
    for (std::size_t n = orders_.size(); n < orders_used_ + 3; ++n) {
        orders_.emplace_back();
    }
    int kept = 0;
    for (int k = 0; k < 3; ++k) {
        const Verdict found = corner(face[k], corners[k]);
        if (found != Verdict::accepted) {
            return found;
        }
        kept += corners[k].cell < 0 ? 1 : 0;
    }
    const ScanNormal& normal = normals_[scan_face];
    if (options_.constant_directions) {
        return test_constant(scan_face, corners, normal);
    }
    crossings_.clear();
    odd_.clear();
    inside_.clear();
    const int cell = common_cell(corners);
    if (cell >= 0 && surface_.cell(cell).impassable) {
        if (kept == 3) { // represented by itself
            touch(cell, scan_face);
            return Verdict::accepted;
        }
        return Verdict::no_preimage;
    }
    const ScanTriangle q = triangle_of(*scan_, scan_face);
    Verdict verdict = test_kept_corners(q, corners, normal);
    if (verdict != Verdict::accepted) {
        return verdict;
    }
    if (cell >= 0 && stays_in(cell, corners) == Verdict::accepted) {
        touch(cell, scan_face);
        return test_orientation(cell, corners);
    }
    verdict = test_spanning(q, corners, normal);
    if (verdict == Verdict::accepted && cell >= 0 && holds_corners(cell, corners)) {
        verdict = test_orientation(cell, corners); // its edges may leave the cell, its corners do not
    }
    return verdict == Verdict::accepted ? record(scan_face, q, corners) : verdict;
}

bool Validator::holds_corners(int cell, const std::array<Corner, 3>& corners) const {
    return std::all_of(corners.begin(), corners.end(), [&](const Corner& corner) {
        return corner.order == nullptr ? corner.cell == cell : surface_.corner_of(cell, corner.order->vertex()) >= 0;
    });
}

Verdict Validator::test_orientation(int cell, const std::array<Corner, 3>& corners) const {
    if (!options_.orientation || cell >= surface_.new_cells()) {
        return Verdict::accepted;
    }
    BarycentricTriangle alpha;
    std::array<double, 3> error{};
    for (int k = 0; k < 3; ++k) {
        const int corner = corners[k].order == nullptr ? -1 : surface_.corner_of(cell, corners[k].order->vertex());
        alpha[k] = corner < 0 ? corners[k].lift.at.alpha : Vec3(Vec3::Unit(corner));
        error[k] = corner < 0 ? corners[k].lift.at.alpha_error : 0.0;
    }
    Sign sign = scan_orientation(alpha, error);
    if (sign == Sign::undecided) {
        sign = scan_orientation(surface_.cell(cell).triangle, {displaced(cell, corners[0]), displaced(cell, corners[1]),
                                                               displaced(cell, corners[2])});
    }
    return verdict_of(sign, Verdict::orientation);
}

DisplacedPoint Validator::displaced(int cell, const Corner& corner) const {
    return {scan_->positions[corner.scan_vertex], point_in(cell, corner).t};
}

Verdict Validator::test_constant(std::int32_t scan_face, const std::array<Corner, 3>& corners,
                                 const ScanNormal& normal) {
    // The prismoids of neighbours with different normals leave gaps or overlap, so a scan face must lie over one face.
    // A right prism is convex: with the corners inside, the whole face is.
    for (int c = 0; c < surface_.new_cells(); ++c) {
        const bool all = std::all_of(corners.begin(), corners.end(), [&](const Corner& corner) {
            return corner.cell < 0 ? surface_.corner_of(c, base_->place(corner.scan_vertex).kept) >= 0
                                   : corner.cell == c;
        });
        if (!all) {
            continue;
        }
        // Seen along one direction, a triangle keeps its orientation exactly where N.n > 0.
        touch(c, scan_face);
        return verdict_of(normal.seen_along(surface_.cell(c).triangle.d[0]), Verdict::normal_condition);
    }
    return Verdict::no_preimage;
}

Verdict Validator::test_kept_corners(const ScanTriangle& q, const std::array<Corner, 3>& corners,
                                     const ScanNormal& normal) const {
    for (const Corner& corner : corners) {
        if (corner.order == nullptr) {
            continue;
        }
        const Vec3& direction = surface_.vertex(corner.order->vertex()).direction;
        Sign sign = normal.seen_along(direction);
        if (sign == Sign::undecided) {
            sign = seen_along(direction, q);
        }
        if (sign != Sign::positive) {
            return verdict_of(sign, Verdict::normal_condition);
        }
    }
    return Verdict::accepted;
}

/// Where the scan edge between two corners starts at the one.
TraceEnd Validator::trace_end(const Corner& at, const Corner& other) const {
    const int cell = at.order != nullptr ? at.order->start_cell(other.scan_vertex) : at.cell;
    return {&scan_->positions[at.scan_vertex], cell, point_in(cell, at)};
}

Verdict Validator::trace(const Corner& a, const Corner& b) {
    if (a.order != nullptr && a.order->is_base_edge(b.scan_vertex)) {
        return Verdict::accepted;
    }
    const Corner& low = a.scan_vertex < b.scan_vertex ? a : b;
    const Corner& high = a.scan_vertex < b.scan_vertex ? b : a;
    const auto follow = [&](std::vector<TraceCrossing>& out) {
        return trace_edge(surface_, trace_end(low, high), trace_end(high, low), out);
    };
    return traces_.trace(low.scan_vertex, high.scan_vertex, follow, crossings_);
}

Verdict Validator::test_spanning(const ScanTriangle& q, const std::array<Corner, 3>& corners,
                                 const ScanNormal& normal) {
    for (int k = 0; k < 3; ++k) {
        const Verdict verdict = trace(corners[k], corners[(k + 1) % 3]);
        if (verdict != Verdict::accepted) {
            return verdict;
        }
    }
    Verdict verdict = test_crossings(q, normal);
    return verdict == Verdict::accepted ? test_pillars(q, corners) : verdict;
}

Verdict Validator::test_crossings(const ScanTriangle& q, const ScanNormal& normal) const {
    const bool seen_by_all = cone_.sees(normal);
    for (const TraceCrossing& crossing : crossings_) {
        if (seen_by_all && std::min(crossing.from, crossing.to) < surface_.new_cells()) {
            continue;
        }
        const Sign sign = normal_condition_at_wall(surface_.cell(crossing.from).triangle,
                                                   {crossing.wall, crossing.t, crossing.line}, q);
        const Verdict verdict = verdict_of(sign, Verdict::normal_condition);
        if (verdict != Verdict::accepted) {
            return verdict;
        }
    }
    return Verdict::accepted;
}

Verdict Validator::test_pillars(const ScanTriangle& q, const std::array<Corner, 3>& corners) {
    for (const TraceCrossing& crossing : crossings_) {
        odd_.toggle(crossing.edge[0], crossing.edge[1]);
    }
    for (int k = 0; k < 3; ++k) {
        const FanOrder* order = corners[k].order;
        if (order == nullptr) {
            continue;
        }
        // Base edges strictly between the two scan edges of the face count as crossed once.
        const int from = order->position(corners[(k + 1) % 3].scan_vertex);
        const int forward = order->steps(from, order->position(corners[(k + 2) % 3].scan_vertex));
        for (int step = 1; step < forward; ++step) {
            if ((from + step) % 2 == 0) {
                const std::size_t spoke = static_cast<std::size_t>((from + step) / 2) % order->fan().spokes.size();
                odd_.toggle(order->vertex(), order->fan().spokes[spoke]);
            }
        }
    }
    return odd_.empty() ? Verdict::accepted : flood_.find(surface_, q, odd_, inside_);
}

Verdict Validator::record(std::int32_t scan_face, const ScanTriangle& q, const std::array<Corner, 3>& corners) {
    for (int k = 0; k < 3; ++k) {
        touch(corners[k].cell, scan_face);
        const bool passable =
            corners[k].order == nullptr || touch_between(*corners[k].order, corners[(k + 1) % 3].scan_vertex,
                                                         corners[(k + 2) % 3].scan_vertex, scan_face);
        if (!passable) {
            return Verdict::no_preimage;
        }
    }
    for (const TraceCrossing& crossing : crossings_) {
        for (const int cell : {crossing.from, crossing.to}) {
            touch(cell, scan_face);
            const Verdict verdict = reach(cell, crossing.t);
            if (verdict != Verdict::accepted) {
                return verdict;
            }
        }
    }
    for (const std::int32_t vertex : inside_) {
        const Verdict verdict = reach_pillar(vertex, q, scan_face);
        if (verdict != Verdict::accepted) {
            return verdict;
        }
    }
    return Verdict::accepted;
}

bool Validator::touch_between(const FanOrder& order, std::int32_t first, std::int32_t second, std::int32_t scan_face) {
    const int from = order.position(first);
    const int to = from + order.steps(from, order.position(second));
    for (int position = from + (from % 2 == 0 ? 1 : 0); position <= to; position += 2) {
        const int cell = order.fan().cells[static_cast<std::size_t>(position / 2) % order.fan().cells.size()];
        if (surface_.cell(cell).impassable) {
            return false;
        }
        touch(cell, scan_face);
    }
    return true;
}

Verdict Validator::close_ranges() {
    for (int c = 0; c < surface_.new_cells(); ++c) {
        Cell& cell = surface_.cell(c);
        Trial::NewFace& face = trial_.faces[c];
        const bool met = hulls_[c].lo <= hulls_[c].hi && !face.is_scan_face;
        face.range = met ? Range{float_below(hulls_[c].lo), float_above(hulls_[c].hi)} : Range{0.0, 0.0};
        cell.range = face.range;
        if (face.is_scan_face) {
            continue;
        }
        const Verdict verdict = verdict_of(jacobian_on(cell.triangle, face.range), Verdict::jacobian);
        if (verdict != Verdict::accepted) {
            return verdict;
        }
        if (options_.max_displacement) {
            const double longest =
                std::max({cell.triangle.d[0].norm(), cell.triangle.d[1].norm(), cell.triangle.d[2].norm()});
            if (std::max(-face.range.lo, face.range.hi) * longest > *options_.max_displacement) {
                return Verdict::max_displacement;
            }
        }
    }
    return Verdict::accepted;
}

Verdict Validator::test_alternatives() const {
    for (const auto& [vertex, lift] : alternatives_) {
        const Range range = surface_.cell(lift.cell).range;
        if (lift.at.t + lift.at.t_error >= range.lo && lift.at.t - lift.at.t_error <= range.hi) {
            return Verdict::several_preimages;
        }
    }
    return Verdict::accepted;
}

/// A scan vertex beside the patch may lie on the rim, but not where the new face there is a scan face now: the wall of
/// a frozen face has one side.
Verdict Validator::test_frozen_walls() {
    for (int c = 0; c < surface_.new_cells(); ++c) {
        for (int k = 0; k < 3 && trial_.faces[c].is_scan_face; ++k) {
            const int outer = surface_.neighbour(c, k);
            if (outer < surface_.new_cells() || surface_.cell(outer).impassable) {
                continue;
            }
            const int corner = surface_.corner_of(outer, surface_.cell(c).corners[(k + 1) % 3]);
            const Verdict verdict = test_wall(outer, (corner + 1) % 3);
            if (verdict != Verdict::accepted) {
                return verdict;
            }
        }
    }
    return Verdict::accepted;
}

Verdict Validator::test_wall(int outer, int k) const {
    constexpr double near = 1e-6; // far above the rounding of places
    const BaseTriangle& triangle = surface_.cell(outer).triangle;
    for (std::int32_t v = base_->face(surface_.cell(outer).face).first_vertex; v >= 0; v = base_->next_on_face(v)) {
        const Place& place = base_->place(v);
        if (place.alpha[k] > near) {
            continue;
        }
        const Vec3& q = scan_->positions[v];
        const std::optional<Enclosure> at = enclose(triangle, q, place.alpha, place.t);
        const std::optional<Lift> lift = at ? lift_of(outer, triangle, q, *at) : std::nullopt;
        if (!lift || (lift->walls & wall_bit(k)) != 0) {
            return lift ? Verdict::tie : Verdict::undecided;
        }
    }
    return Verdict::accepted;
}

Verdict Validator::test_faces_beside() {
    // A scan vertex on a new face must not lie in the prismoid of a face beside the patch that shares a corner, nor the
    // other way round. Few do: boxes sort out nearly all.
    surface_.cells_beside(beside_);
    for (const int outer : beside_) {
        const Verdict verdict = test_places_in(outer);
        if (verdict != Verdict::accepted) {
            return verdict;
        }
    }
    here_.clear();
    around_here_.setEmpty();
    for (int c = 0; c < surface_.new_cells(); ++c) {
        if (!trial_.faces[c].is_scan_face) {
            here_.emplace_back(surface_, c);
            around_here_.extend(here_.back().box());
        }
    }
    for (const int outer : beside_) {
        const Verdict verdict = test_vertices_of(outer);
        if (verdict != Verdict::accepted) {
            return verdict;
        }
    }
    return Verdict::accepted;
}

Verdict Validator::test_places_in(int outer) {
    const CellPlaces there(surface_, outer);
    for (std::size_t n = 0; n < lifts_.size(); ++n) {
        const Vec3& q = scan_->positions[trial_.places[n].scan_vertex];
        if (!there.may_hold(q) || !surface_.share_corner(outer, lifts_[n].cell)) {
            continue;
        }
        const Verdict verdict = there.lacks(q, lifts_[n]);
        if (verdict != Verdict::accepted) {
            return verdict;
        }
    }
    return Verdict::accepted;
}

Verdict Validator::test_vertices_of(int outer) const {
    for (std::int32_t v = base_->face(surface_.cell(outer).face).first_vertex; v >= 0; v = base_->next_on_face(v)) {
        const Vec3& q = scan_->positions[v];
        if (!around_here_.contains(q)) {
            continue;
        }
        for (const CellPlaces& here : here_) {
            if (!here.may_hold(q) || !surface_.share_corner(outer, here.cell())) {
                continue;
            }
            const Place& place = base_->place(v);
            const std::optional<Enclosure> at = enclose(surface_.cell(outer).triangle, q, place.alpha, place.t);
            const std::optional<Lift> known = at ? lift_of(outer, surface_.cell(outer).triangle, q, *at) : std::nullopt;
            const Verdict verdict = known ? here.lacks(q, *known) : Verdict::undecided;
            if (verdict != Verdict::accepted) {
                return verdict;
            }
        }
    }
    return Verdict::accepted;
}

Verdict Validator::test_borders() {
    border_arcs_.clear();
    for (const std::int32_t f : scan_faces_) {
        const Triangle& face = scan_->faces[f];
        for (int k = 0; k < 3; ++k) {
            const std::int32_t next = face[(k + 1) % 3];
            if (topology_->border_successor(face[k]) != next) {
                continue;
            }
            // In the direction in which trace() follows it.
            const Verdict verdict = add_border_edge({f, {std::min(face[k], next), std::max(face[k], next)}});
            if (verdict != Verdict::accepted) {
                return verdict;
            }
        }
    }
    return border_arcs_.test(surface_);
}

Verdict Validator::add_border_edge(const BorderEdge& edge) {
    for (std::size_t n = orders_.size(); n < orders_used_ + 2; ++n) {
        orders_.emplace_back(); // pointers to orders stay valid
    }
    std::array<Corner, 2> ends{};
    for (int i = 0; i < 2; ++i) {
        const Verdict found = corner(edge.ends[i], ends[i]);
        if (found != Verdict::accepted) {
            return found;
        }
    }
    if (ends[0].order != nullptr && ends[0].order->is_base_edge(edge.ends[1])) {
        add_base_edge(edge, ends[0], ends[1]);
        return Verdict::accepted;
    }
    crossings_.clear();
    const Verdict verdict = trace(ends[0], ends[1]);
    if (verdict == Verdict::accepted) {
        border_arcs_.add(surface_, edge, {trace_end(ends[0], ends[1]), trace_end(ends[1], ends[0]), crossings_});
    }
    return verdict;
}

/// An edge that represents itself, on the cells on both of its sides.
void Validator::add_base_edge(const BorderEdge& edge, const Corner& from, const Corner& to) {
    const ScanLine line{&scan_->positions[from.scan_vertex], &scan_->positions[to.scan_vertex]};
    for (const int cell : from.order->fan().cells) {
        const int b = surface_.corner_of(cell, to.order->vertex());
        if (b >= 0 && !surface_.cell(cell).impassable) {
            const int a = surface_.corner_of(cell, from.order->vertex());
            border_arcs_.add(
                surface_, edge,
                {cell, {{Displacement(), walls_at_corner(a)}, true}, {{Displacement(), walls_at_corner(b)}, true}},
                line);
        }
    }
}

} // namespace foldless
