#include <foldless/decimate/decimator.h>

#include <foldless/decimate/commit.h>
#include <foldless/decimate/edge_order.h>
#include <foldless/decimate/served_run.h>
#include <foldless/decimate/vertex_directions.h>

#include <foldless/io/bounding_box.h>
#include <foldless/predicates/visible_direction.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace foldless {
namespace {

/// Edges asked between two looks at the clock and two calls of the user's progress function.
constexpr std::size_t check_interval = 64;

/// The root mean square distance, in diagonals, up to which an end of an edge is a good place for the vertex that
/// is left: less than most displacements that are left at the end.
constexpr double good_enough = 2e-3;

/// The corners of a face, turned so that v comes first.
std::array<Vec3, 3> from_corner(const Triangle& corners, const std::array<Vec3, 3>& positions, std::int32_t v) {
    const int k = corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
    return {positions[k], positions[(k + 1) % 3], positions[(k + 2) % 3]};
}

bool has_crowded_vertices(const ScanTopology& topology, const Scan& scan) {
    for (std::size_t v = 0; v < scan.positions.size(); ++v) {
        if (topology.faces_around(static_cast<std::int32_t>(v)).size() > most_edges_at_a_vertex) {
            return true;
        }
    }
    return false;
}

ValidatorOptions validator_options(const DecimateOptions& options) {
    return {options.unique_among_fold_free ? Uniqueness::fold_free : Uniqueness::in_range,
            options.directions == Directions::face, options.boundary == Boundary::trim, options.orientation_test,
            options.max_displacement};
}

} // namespace

Decimator::Decimator(const Scan& scan, const DecimateOptions& options)
    : scan_(&scan), options_(options), topology_(scan), base_(scan), origin_(scan.positions[scan.faces[0][0]]),
      good_enough_(std::pow(good_enough * bounding_box_diagonal(scan), 2)),
      mobility_(scan.positions.size(), Mobility::free), has_crowded_vertices_(has_crowded_vertices(topology_, scan)),
      quadrics_(vertex_quadrics(scan, origin_)), queue_(base_.connectivity().n_edges()),
      validator_(base_, scan, topology_, validator_options(options)), face_count_(scan.faces.size()),
      start_(std::chrono::steady_clock::now()) {
    find_directions();
    enter_all_edges(base_, queue_);
}

void Decimator::find_directions() {
    const std::size_t count = scan_->positions.size();
    std::vector<char> unserved(count, 0);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count), [&](const tbb::blocked_range<std::size_t>& range) {
        std::vector<Vec3> normals;
        std::vector<std::array<Vec3, 3>> star;
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const auto v = static_cast<std::int32_t>(i);
            normals.clear();
            star.clear();
            for (const std::int32_t f : topology_.faces_around(v)) {
                const Triangle& face = scan_->faces[f];
                normals.push_back(validator_.scan_normal(f).value());
                star.push_back(from_corner(
                    face, {scan_->positions[face[0]], scan_->positions[face[1]], scan_->positions[face[2]]}, v));
            }
            const std::optional<Vec3> visible = most_visible_direction(normals);
            unserved[i] = !normals.empty() && !visible ? 1 : 0;
            std::optional<Vec3> chosen = visible;
            if (options_.directions == Directions::area || options_.directions == Directions::angle) {
                chosen = vertex_normal(star, options_.directions);
            }
            if (chosen) { // else freeze_faces_at() finds one for a part of the faces
                base_.vertex(v).direction = stored_direction(*chosen);
            }
        }
    });
    freeze_unserved(unserved);
}

void Decimator::freeze_unserved(const std::vector<char>& unserved) {
    std::vector<char> frozen(scan_->faces.size(), 0);
    for (std::size_t i = 0; i < unserved.size(); ++i) {
        const auto v = static_cast<std::int32_t>(i);
        if (options_.boundary == Boundary::lock && topology_.border_successor(v) >= 0) {
            mobility_[v] = Mobility::fixed;
        }
        if (unserved[v] != 0) {
            ++statistics_.unserved_vertices;
            freeze_faces_at(v, frozen);
        }
    }
}

/// As few as must be, so that one direction serves the vertex for all others.
void Decimator::freeze_faces_at(std::int32_t v, std::vector<char>& frozen) {
    mobility_[v] = Mobility::fixed;
    std::vector<std::int32_t> faces;
    base_.append_faces_around(v, faces);
    std::erase_if(faces, [&](std::int32_t f) { return frozen[f] != 0; });
    if (faces.empty()) {
        return;
    }
    normals_.clear();
    for (const std::int32_t f : faces) {
        normals_.push_back(validator_.scan_normal(f).value());
    }
    const ServedRun run = longest_served_run(normals_, !base_.is_border_vertex(v));
    base_.vertex(v).direction = stored_direction(run.direction);
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (run.contains(i, faces.size())) {
            continue;
        }
        frozen[faces[i]] = 1;
        for (const std::int32_t corner : scan_->faces[faces[i]]) {
            mobility_[corner] = Mobility::fixed;
        }
    }
}

std::optional<StopReason> Decimator::interrupted() {
    if (asked_since_check_++ % check_interval != 0) {
        return std::nullopt;
    }
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    if (options_.time_limit && elapsed.count() > *options_.time_limit) {
        return StopReason::time_limit;
    }
    if (options_.progress &&
        !options_.progress({face_count_, options_.target_faces.value_or(0), scan_->faces.size()})) {
        return StopReason::cancelled;
    }
    return std::nullopt;
}

StopReason Decimator::run() {
    while (!options_.target_faces || face_count_ > *options_.target_faces) {
        if (const std::optional<StopReason> reason = interrupted()) {
            return *reason;
        }
        const std::optional<std::int32_t> edge = queue_.pop();
        if (!edge) {
            return StopReason::every_edge_refused;
        }
        ++statistics_.attempted;
        if (ask(*edge)) {
            commit();
            ++statistics_.accepted;
        } else {
            queue_.refuse(*edge);
        }
    }
    return StopReason::target_reached;
}

bool Decimator::ask(std::int32_t edge) {
    Collapse collapse;
    Verdict verdict =
        make_collapse(base_, edge, {mobility_, options_.edge_valence_limit, has_crowded_vertices_}, collapse);
    if (verdict != Verdict::accepted) {
        ++statistics_.refused[static_cast<std::size_t>(verdict)];
        return false;
    }
    survivor_is_known_ = false;
    Quadric quadric = quadrics_[collapse.gone];
    quadric += quadrics_[collapse.stays];
    const bool keeps_place = mobility_[collapse.stays] == Mobility::fixed ||
                             (base_.is_border_vertex(collapse.stays) && !base_.is_border_vertex(collapse.gone));
    const bool keep_direction = options_.store_directions && options_.directions != Directions::face;
    candidates({&base_, collapse, quadric, origin_, keeps_place, scan_->float32, keep_direction, good_enough_},
               options_.placement, candidates_);
    for (const Candidate& candidate : candidates_) {
        verdict = ask_candidate(candidate.at == collapse.gone ? reversed(base_, collapse) : collapse, candidate);
        if (verdict == Verdict::accepted) {
            return true;
        }
        ++statistics_.refused[static_cast<std::size_t>(verdict)];
    }
    return false;
}

Extent Decimator::extent_of(const Candidate& candidate) const {
    if (candidate.keeps_direction) {
        return Extent::star_of_gone;
    }
    return options_.store_directions ? Extent::both_stars : Extent::two_rings;
}

Verdict Decimator::ask_candidate(const Collapse& collapse, const Candidate& candidate) {
    collapse_ = collapse;
    extent_ = extent_of(candidate);
    fill_faces(base_, collapse, extent_, patch_);
    BaseVertex gone = base_.vertex(collapse.gone);
    gone.scan_vertex = -1;
    patch_.changed.push_back({collapse.gone, gone});
    if (!candidate.keeps_direction) {
        BaseVertex survivor = base_.vertex(collapse.stays);
        survivor.position = candidate.position;
        survivor.scan_vertex = candidate.at == collapse.stays ? survivor.scan_vertex : -1;
        patch_.changed.push_back({collapse.stays, survivor});
    }
    const Verdict verdict = guard_faces(base_, patch_);
    if (verdict != Verdict::accepted) {
        return verdict;
    }
    if (!candidate.keeps_direction && options_.directions != Directions::face && !set_directions(collapse)) {
        return Verdict::direction;
    }
    const Verdict judged = validator_.judge(patch_);
    statistics_.retested_vertices += validator_.trial().retested;
    statistics_.refused_between_vertices += validator_.trial().vertices_pass && is_between_vertices(judged) ? 1 : 0;
    return judged;
}

bool Decimator::set_directions(const Collapse& collapse) {
    const std::optional<Vec3> survivor = direction_of(collapse.stays);
    if (!survivor) {
        return false;
    }
    patch_.changed[1].value.direction = *survivor;
    if (options_.store_directions) {
        return true;
    }
    rim_of(base_, collapse, rim_);
    for (const std::int32_t v : rim_) {
        const std::optional<Vec3> direction = direction_of(v);
        if (!direction) {
            return false;
        }
        BaseVertex vertex = base_.vertex(v);
        vertex.direction = *direction;
        patch_.changed.push_back({v, vertex});
    }
    return true;
}

std::optional<Vec3> Decimator::direction_of(std::int32_t v) {
    std::optional<Vec3> direction;
    if (options_.directions == Directions::visible) {
        direction = v == collapse_.stays ? visible_direction_of_survivor() : visible_direction_of(v);
    }
    if (!direction) {
        // Also where no single direction sees every scan face on the star: the validator asks less, that each scan face
        // be seen where it lies.
        star_.clear();
        for (const PatchFace& face : patch_.added) {
            if (std::find(face.corners.begin(), face.corners.end(), v) == face.corners.end()) {
                continue;
            }
            std::array<Vec3, 3> positions;
            for (int k = 0; k < 3; ++k) {
                const bool moved = face.corners[k] == collapse_.stays;
                positions[k] = moved ? patch_.changed[1].value.position : base_.vertex(face.corners[k]).position;
            }
            star_.push_back(from_corner(face.corners, positions, v));
        }
        direction =
            vertex_normal(star_, options_.directions == Directions::angle ? Directions::angle : Directions::area);
    }
    return direction ? std::optional<Vec3>(stored_direction(*direction)) : std::nullopt;
}

const std::optional<Vec3>& Decimator::visible_direction_of_survivor() {
    // The scan faces around the two ends are the same for all candidates of an edge.
    if (!survivor_is_known_) {
        visible_from_survivor_ = visible_direction_of(collapse_.stays);
        survivor_is_known_ = true;
    }
    return visible_from_survivor_;
}

std::optional<Vec3> Decimator::visible_direction_of(std::int32_t v) {
    star_faces_.clear();
    for (const std::int32_t f : patch_.removed) {
        const Triangle corners = base_.corners(f);
        const bool around = std::any_of(corners.begin(), corners.end(), [&](std::int32_t corner) {
            return corner == v || (v == collapse_.stays && corner == collapse_.gone);
        });
        if (around && !is_frozen(f)) {
            star_faces_.push_back(f);
        }
    }
    normals_.clear();
    for (const std::int32_t f : validator_.gather(star_faces_)) {
        normals_.push_back(validator_.scan_normal(f).value());
    }
    return most_visible_direction(normals_);
}

bool Decimator::is_frozen(std::int32_t face) const {
    if (!base_.face(face).is_scan_face) {
        return false;
    }
    const Triangle corners = base_.corners(face);
    return std::all_of(corners.begin(), corners.end(), [&](std::int32_t v) { return mobility_[v] == Mobility::fixed; });
}

void Decimator::commit() {
    edges_changed_by(base_, collapse_, extent_, edges_);
    commit_collapse(base_, collapse_, patch_, validator_.trial());
    quadrics_[collapse_.stays] += quadrics_[collapse_.gone];
    face_count_ -= patch_.removed.size() - patch_.added.size();
    requeue(base_, collapse_.stays, edges_, queue_);
}

} // namespace foldless
