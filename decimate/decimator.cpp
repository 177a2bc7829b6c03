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

/// Gaps are closed when one of so many faces is left. Sooner, the new arrays take more beside the old ones.
constexpr std::size_t gaps_close_at = 4;

Vec3 origin_of_quadrics(const Scan& scan) {
    return scan.positions[scan.faces[0][0]];
}

bool has_crowded_vertices(const ScanTopology& topology, const Scan& scan) {
    for (std::size_t v = 0; v < scan.positions.size(); ++v) {
        if (topology.faces_around(static_cast<std::int32_t>(v)).size() > most_edges_at_a_vertex) {
            return true;
        }
    }
    return false;
}

} // namespace

Decimator::Decimator(BaseSurface& base, const Scan& scan, const DecimateOptions& options)
    : scan_(&scan), options_(options), prepared_(scan), base_(base), mobility_(scan.positions.size(), Mobility::free),
      quadrics_(scan, prepared_.topology(), origin_of_quadrics(scan)), queue_(all_edges(base_)),
      face_count_(scan.faces.size()), start_(std::chrono::steady_clock::now()) {
    find_directions();
    answers_.emplace(AskedState{&prepared_, &base_, &mobility_, &quadrics_, &options_, origin_of_quadrics(scan),
                                std::pow(good_enough * bounding_box_diagonal(scan), 2),
                                has_crowded_vertices(prepared_.topology(), scan)});
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
            for (const std::int32_t f : prepared_.topology().faces_around(v)) {
                const Triangle& face = scan_->faces[f];
                normals.push_back(prepared_.unit_normal(f));
                star.push_back(from_corner(face, prepared_.triangle(f), v));
            }
            const std::optional<Vec3> visible = most_visible_direction(normals);
            unserved[i] = !normals.empty() && !visible ? 1 : 0;
            std::optional<Vec3> chosen = visible;
            if (options_.directions == Directions::area || options_.directions == Directions::angle) {
                chosen = vertex_normal(star, options_.directions);
            }
            if (chosen) { // else freeze_faces_at() finds one for a part of the faces
                base_.set_direction(v, stored_direction(*chosen));
            }
        }
    });
    freeze_unserved(unserved);
}

void Decimator::freeze_unserved(const std::vector<char>& unserved) {
    std::vector<char> frozen(scan_->faces.size(), 0);
    for (std::size_t i = 0; i < unserved.size(); ++i) {
        const auto v = static_cast<std::int32_t>(i);
        if (options_.boundary == Boundary::lock && prepared_.topology().border_successor(v) >= 0) {
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
    std::vector<Vec3> normals;
    normals.reserve(faces.size());
    for (const std::int32_t f : faces) {
        normals.push_back(prepared_.unit_normal(f));
    }
    const ServedRun run = longest_served_run(normals, !base_.is_border_vertex(v));
    base_.set_direction(v, stored_direction(run.direction));
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
        const EdgeAnswer& answer = answers_->answer(*edge, queue_);
        count(answer);
        if (answer.accepted) {
            commit(answer);
        } else {
            queue_.refuse(*edge);
        }
    }
    return StopReason::target_reached;
}

void Decimator::count(const EdgeAnswer& answer) {
    ++statistics_.attempted;
    statistics_.accepted += answer.accepted ? 1 : 0;
    for (std::size_t n = 0; n < verdict_count; ++n) {
        statistics_.refused[n] += answer.refused[n];
    }
    statistics_.refused_between_vertices += answer.refused_between_vertices;
    statistics_.retested_vertices += answer.retested_vertices;
}

void Decimator::commit(const EdgeAnswer& answer) {
    edges_changed_by(base_, answer.collapse, answer.extent, edges_);
    answers_->about_to_change(answer.patch);
    commit_collapse(base_, answer.collapse, answer.patch, answer.trial);
    quadrics_.merge(answer.collapse.stays, answer.collapse.gone);
    face_count_ -= answer.patch.removed.size() - answer.patch.added.size();
    requeue(base_, answer.collapse.stays, edges_, queue_);
    if (face_count_ <= base_.face_slots() / gaps_close_at) {
        close_gaps();
    }
}

/// What is left of the base mesh keeps its order: it makes no difference but in memory, the most of which is needed in
/// the end, for patches that hold much of the scan.
void Decimator::close_gaps() {
    const Renumbering numbers = number_what_is_left(base_.connectivity());
    queue_.renumber(numbers.edges);
    base_.close_gaps(numbers);
    answers_->forget();
}

} // namespace foldless
