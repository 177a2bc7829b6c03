#include <foldless/decimate/validator.h>

#include <foldless/decimate/scratch.h>
#include <foldless/predicates/jacobian.h>
#include <foldless/predicates/prismoid_line.h>
#include <foldless/predicates/prismoid_point.h>
#include <foldless/predicates/scan_orientation.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldless {
namespace {

/// On a patch with more, vertices are counted before they are located: vectors that grow by doubling would take up to
/// three times the room that is needed.
constexpr std::size_t many_scan_faces = 10000;

} // namespace

Validator::Validator(const BaseSurface& base, const PreparedScan& prepared, const ValidatorOptions& options)
    : base_(&base), prepared_(&prepared), scan_(&prepared.scan()), topology_(&prepared.topology()), options_(options),
      surface_(base), image_(*scan_, *topology_, options.constant_directions), beside_(*scan_),
      borders_(*scan_, *topology_), gathered_(scan_->faces.size()) {}

const std::vector<std::int32_t>& Validator::gather(const std::vector<std::int32_t>& removed) {
    for (const std::int32_t f : scan_faces_) {
        gathered_.unmark(f);
    }
    clear_scratch(scan_faces_);
    for (const std::int32_t face : removed) {
        for (const std::int32_t f : base_->face(face).scan_faces) {
            if (gathered_.mark(f)) {
                scan_faces_.push_back(f);
            }
        }
    }
    return scan_faces_;
}

void Validator::append_read(std::vector<std::int32_t>& faces) const {
    surface_.append_read(faces);
}

void Validator::forget_refusals() {
    witness_ = -1;
    face_witness_ = -1;
}

Verdict Validator::judge(const Patch& patch) {
    reset(patch);
    const Verdict verdict = judge_reset(patch);
    if (verdict == Verdict::accepted) {
        note_places();
    }
    image_.clear();
    return verdict;
}

void Validator::note_places() {
    trial_.places.reserve(image_.lifts().size());
    for (const auto& [scan_vertex, lift] : image_.lifts()) {
        trial_.places.push_back({scan_vertex, lift.cell, lift.at.alpha, lift.at.t});
    }
}

Verdict Validator::judge_reset(const Patch& patch) {
    Verdict verdict = judge_vertices(patch);
    trial_.vertices_pass = verdict == Verdict::accepted && !options_.constant_directions;
    if (verdict == Verdict::accepted) {
        verdict = judge_faces(patch);
    }
    if (verdict == Verdict::accepted) {
        verdict = close_ranges();
    }
    if (verdict == Verdict::accepted) {
        verdict = test_alternatives();
    }
    if (verdict == Verdict::accepted) {
        verdict = beside_.test(surface_, image_.lifts());
    }
    const bool has_free_border = options_.trimmed && !options_.constant_directions;
    return verdict == Verdict::accepted && has_free_border ? borders_.test(surface_, image_, scan_faces_) : verdict;
}

void Validator::reset(const Patch& patch) {
    surface_.reset(patch, options_.constant_directions);
    ranges_.reset(surface_);
    image_.reset(surface_, ranges_);
    const std::size_t count = patch.added.size();
    trial_.clear();
    trial_.faces.resize(count);
    for (std::size_t c = 0; c < count; ++c) {
        trial_.faces[c].is_scan_face = surface_.cell(static_cast<int>(c)).impassable;
    }
}

Verdict Validator::judge_vertices(const Patch& patch) {
    Verdict verdict = location_.reset(surface_, options_.uniqueness);
    if (verdict == Verdict::accepted) {
        static_cast<void>(gather(patch.removed));
        verdict = ask_witness();
    }
    return verdict == Verdict::accepted ? locate_vertices(patch) : verdict;
}

Verdict Validator::judge_faces(const Patch& patch) {
    Verdict verdict = reach_kept_corners();
    if (verdict != Verdict::accepted) {
        return verdict;
    }
    find_wall_planes();
    find_cone();
    if (!options_.constant_directions) {
        verdict = image_.order_fans(patch);
    }
    return verdict == Verdict::accepted ? test_faces() : verdict;
}

Verdict Validator::ask_witness() {
    // The candidates for an edge, and the edges around it, tend to fail at the same scan vertex: asked first, it saves
    // asking the others. Where it is content it is asked again in its turn, so that nothing depends on it but time.
    if (witness_ < 0 || base_->place(witness_).face < 0 || !surface_.removes(base_->place(witness_).face)) {
        return Verdict::accepted;
    }
    pending_ = {witness_};
    solve_pending();
    Lift lift{};
    return find_place(0, lift);
}

Verdict Validator::locate_vertices(const Patch& patch) {
    alternatives_.clear();
    if (scan_faces_.size() > many_scan_faces) {
        image_.reserve(vertices_on(patch));
    }
    pending_.clear();
    most_pending_ = PointBatch::capacity;
    for (const std::int32_t face : patch.removed) {
        for (std::int32_t v = base_->face(face).first_vertex; v >= 0; v = base_->next_on_face(v)) {
            const Verdict verdict = locate_soon(v);
            if (verdict != Verdict::accepted) {
                return verdict;
            }
        }
    }
    for (const PatchVertex& changed : patch.changed) {
        const bool was_there = changed.index < static_cast<std::int32_t>(base_->vertex_slots());
        const std::int32_t v = was_there ? base_->vertex(changed.index).scan_vertex : -1;
        if (v >= 0 && changed.value.scan_vertex != v) { // kept no longer
            const Verdict verdict = locate_soon(v);
            if (verdict != Verdict::accepted) {
                return verdict;
            }
        }
    }
    return locate_pending();
}

Verdict Validator::locate_soon(std::int32_t v) {
    pending_.push_back(v);
    return pending_.size() < most_pending_ ? Verdict::accepted : locate_pending();
}

// Many vertices are solved for at once, and judged in their order. Most patches that fail do so at one of their first
// vertices: the first lists are short, so that at most as much is solved in vain as was of use.
Verdict Validator::locate_pending() {
    solve_pending();
    for (int index = 0; index < static_cast<int>(pending_.size()); ++index) {
        const Verdict verdict = locate_vertex(index);
        if (verdict != Verdict::accepted) {
            return verdict;
        }
    }
    pending_.clear();
    most_pending_ = std::min(2 * most_pending_, PointLocation::most_points);
    return Verdict::accepted;
}

/// As many as get a new place, if all do.
std::size_t Validator::vertices_on(const Patch& patch) const {
    std::size_t count = patch.changed.size();
    for (const std::int32_t face : patch.removed) {
        for (std::int32_t v = base_->face(face).first_vertex; v >= 0; v = base_->next_on_face(v)) {
            ++count;
        }
    }
    return count;
}

void Validator::solve_pending() {
    pending_points_.clear();
    for (const std::int32_t v : pending_) {
        pending_points_.push_back(scan_->positions[v]);
    }
    location_.solve(pending_points_);
}

Verdict Validator::find_place(int index, Lift& lift) {
    ++trial_.retested;
    const Verdict verdict = location_.locate(index, lift);
    return verdict != Verdict::accepted || options_.constant_directions ? verdict
                                                                        : test_normals_at(pending_[index], lift);
}

Verdict Validator::test_normals_at(std::int32_t v, const Lift& lift) const {
    const InterpolatedDirection d(surface_.cell(lift.cell).triangle.d, lift.at.alpha, lift.at.alpha_error);
    for (const std::int32_t f : topology_->faces_around(v)) {
        Sign sign = d.sees(prepared_->normal(f));
        if (sign == Sign::undecided) {
            const BaseTriangle& triangle = surface_.cell(lift.cell).triangle;
            const Vec3& q = scan_->positions[v];
            sign = normal_condition_at(triangle, q, lift.point(triangle, q).t, prepared_->triangle(f));
        }
        if (sign != Sign::positive) {
            return verdict_of(sign, Verdict::normal_condition);
        }
    }
    return Verdict::accepted;
}

Verdict Validator::locate_vertex(int index) {
    const std::int32_t v = pending_[index];
    Lift lift{};
    const Verdict verdict = find_place(index, lift);
    if (verdict != Verdict::accepted) {
        witness_ = v;
        return verdict;
    }
    for (const Lift& other : location_.alternatives()) {
        alternatives_.emplace_back(v, other);
    }
    image_.add(v, lift);
    const Displacement t = lift.point(surface_.cell(lift.cell).triangle, scan_->positions[v]).t;
    Verdict reached = ranges_.reach(lift.cell, t);
    for (int k = 0; k < 3 && reached == Verdict::accepted; ++k) {
        const int beside = (lift.walls & wall_bit(k)) == 0 ? border : surface_.neighbour(lift.cell, k);
        reached = beside == border ? Verdict::accepted : ranges_.reach(beside, t);
    }
    return reached;
}

Verdict Validator::reach_kept_corners() {
    for (int c = 0; c < surface_.new_cells(); ++c) {
        const std::array<bool, 3>& kept = surface_.cell(c).kept;
        if (!trial_.faces[c].is_scan_face && (kept[0] || kept[1] || kept[2])) {
            const Verdict verdict = ranges_.reach(c, Displacement());
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
        planes_.emplace_back(surface_.cell(c).triangle, ranges_.hull(c));
    }
    behind_.clear();
    for (const NewLift& placed : image_.lifts()) {
        behind_.push_back(planes_[placed.lift.cell].behind(scan_->positions[placed.scan_vertex]));
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

void Validator::touch(int cell, std::int32_t scan_face) {
    if (cell < 0 || cell >= surface_.new_cells()) {
        return;
    }
    std::vector<std::int32_t>& faces = trial_.faces[cell].scan_faces;
    if (faces.empty() || faces.back() != scan_face) { // one scan face is tested at a time
        faces.push_back(scan_face);
    }
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
        const Range t = corner.order == nullptr ? image_.point_in(cell, corner).t.bounds() : Range{0.0, 0.0};
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
        if (a.is_base_edge_to(b)) {
            continue;
        }
        const ScanLine line{&scan_->positions[a.scan_vertex], &scan_->positions[b.scan_vertex]};
        if (certainly_stays_in(surface_.cell(cell), *line.to - *line.from, range)) {
            continue;
        }
        const PrismoidPoint end = image_.point_in(cell, b);
        if (follow_line(surface_.cell(cell).triangle, line, image_.point_in(cell, a), &end).kind !=
            Passage::Kind::ends) {
            return Verdict::undecided;
        }
    }
    return Verdict::accepted;
}

/// Whether all three corners lie on one new cell and behind the planes along its walls: then so does the whole face.
bool Validator::is_inside_one_cell(const std::array<std::int32_t, 3>& moved) const {
    if (moved[0] < 0 || moved[1] < 0 || moved[2] < 0) {
        return false;
    }
    const std::vector<NewLift>& lifts = image_.lifts();
    const int cell = lifts[moved[0]].lift.cell;
    return lifts[moved[1]].lift.cell == cell && lifts[moved[2]].lift.cell == cell &&
           (behind_[moved[0]] & behind_[moved[1]] & behind_[moved[2]]) == WallPlanes::all;
}

Verdict Validator::test_inside(std::int32_t scan_face, const std::array<std::int32_t, 3>& moved) {
    const int cell = image_.lifts()[moved[0]].lift.cell;
    touch(cell, scan_face);
    if (!options_.orientation) {
        return Verdict::accepted;
    }
    std::array<Corner, 3> corners{};
    for (int k = 0; k < 3; ++k) {
        corners[k] = {scan_->faces[scan_face][k], cell, nullptr, image_.lifts()[moved[k]].lift};
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
    const std::array<std::int32_t, 3> places{image_.moved(face[0]), image_.moved(face[1]), image_.moved(face[2])};
    if (!options_.constant_directions && is_inside_one_cell(places)) {
        return test_inside(scan_face, places);
    }
    std::array<Corner, 3> corners{};
    int kept = 0;
    for (int k = 0; k < 3; ++k) {
        const Verdict found = image_.find(face[k], corners[k]);
        if (found != Verdict::accepted) {
            return found;
        }
        kept += corners[k].cell < 0 ? 1 : 0;
    }
    if (options_.constant_directions) {
        return test_constant(scan_face, corners);
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
    const ScanTriangle q = prepared_->triangle(scan_face);
    const ScanNormal normal(q);
    Verdict verdict = test_kept_corners(q, corners, normal);
    if (verdict != Verdict::accepted) {
        return verdict;
    }
    if (cell >= 0 && stays_in(cell, corners) == Verdict::accepted) {
        touch(cell, scan_face);
        return test_orientation(cell, corners);
    }
    verdict = test_spanning(q, corners, normal);
    const bool has_cell = cell >= 0 && std::all_of(corners.begin(), corners.end(),
                                                   [&](const Corner& corner) { return image_.holds(cell, corner); });
    if (verdict == Verdict::accepted && has_cell) {
        verdict = test_orientation(cell, corners); // its edges may leave the cell, its corners do not
    }
    return verdict == Verdict::accepted ? record(scan_face, q, corners) : verdict;
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
    return {scan_->positions[corner.scan_vertex], image_.point_in(cell, corner).t};
}

Verdict Validator::test_constant(std::int32_t scan_face, const std::array<Corner, 3>& corners) {
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
        return verdict_of(seen_along(surface_.cell(c).triangle.d[0], prepared_->triangle(scan_face)),
                          Verdict::normal_condition);
    }
    return Verdict::no_preimage;
}

Verdict Validator::test_kept_corners(const ScanTriangle& q, const std::array<Corner, 3>& corners,
                                     const ScanNormal& normal) const {
    for (const Corner& corner : corners) {
        if (corner.order == nullptr) {
            continue;
        }
        const Vec3 direction = surface_.vertex(corner.order->vertex()).direction;
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

Verdict Validator::test_spanning(const ScanTriangle& q, const std::array<Corner, 3>& corners,
                                 const ScanNormal& normal) {
    for (int k = 0; k < 3; ++k) {
        const Verdict verdict = image_.trace(corners[k], corners[(k + 1) % 3], crossings_);
        if (verdict != Verdict::accepted) {
            return verdict;
        }
    }
    Verdict verdict = test_crossings(q, normal);
    return verdict == Verdict::accepted ? test_pillars(q, corners) : verdict;
}

Verdict Validator::test_crossings(const ScanTriangle& q, const ScanNormal& normal) const {
    const bool seen_by_all = cone_.sees(normal.normalised());
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
            const Verdict verdict = ranges_.reach(cell, crossing.t);
            if (verdict != Verdict::accepted) {
                return verdict;
            }
        }
    }
    for (const std::int32_t vertex : inside_) {
        for (const int cell : surface_.fan(vertex).cells) {
            touch(cell, scan_face);
        }
        const Verdict verdict = ranges_.reach_pillar(vertex, q);
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
        face.range = face.is_scan_face ? Range{0.0, 0.0} : ranges_.rounded(c);
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

} // namespace foldless
