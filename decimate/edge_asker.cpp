#include <foldless/decimate/edge_asker.h>

#include <foldless/decimate/scratch.h>
#include <foldless/decimate/vertex_directions.h>
#include <foldless/predicates/visible_direction.h>

#include <algorithm>
#include <utility>

namespace foldless {
namespace {

ValidatorOptions validator_options(const DecimateOptions& options) {
    return {options.unique_among_fold_free ? Uniqueness::fold_free : Uniqueness::in_range,
            options.directions == Directions::face, options.boundary == Boundary::trim, options.orientation_test,
            options.max_displacement};
}

} // namespace

std::array<Vec3, 3> from_corner(const Triangle& corners, const std::array<Vec3, 3>& positions, std::int32_t v) {
    const int k = corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
    return {positions[k], positions[(k + 1) % 3], positions[(k + 2) % 3]};
}

EdgeAsker::EdgeAsker(const AskedState& state)
    : state_(state), validator_(*state.base, *state.scan, validator_options(*state.options)) {}

void EdgeAsker::ask(std::int32_t edge, EdgeAnswer& answer) {
    answer_ = &answer;
    answer.refused.fill(0);
    answer.refused_between_vertices = 0;
    answer.retested_vertices = 0;
    answer.read.clear();
    answer.trial.clear();
    survivor_is_known_ = false;
    validator_.forget_refusals();
    const Verdict verdict = ask_candidates(edge);
    answer.accepted = verdict == Verdict::accepted;
}

Verdict EdgeAsker::ask_candidates(std::int32_t edge) {
    const BaseSurface& base = *state_.base;
    const DecimateOptions& options = *state_.options;
    Collapse collapse;
    Verdict verdict = make_collapse(
        base, edge, {*state_.mobility, options.edge_valence_limit, state_.has_crowded_vertices}, collapse);
    note_stars(collapse);
    if (verdict != Verdict::accepted) {
        ++answer_->refused[static_cast<std::size_t>(verdict)];
        return verdict;
    }
    Quadric quadric = (*state_.quadrics)[collapse.gone];
    quadric += (*state_.quadrics)[collapse.stays];
    const bool keeps_place = (*state_.mobility)[collapse.stays] == Mobility::fixed ||
                             (base.is_border_vertex(collapse.stays) && !base.is_border_vertex(collapse.gone));
    const bool keep_direction = options.store_directions && options.directions != Directions::face;
    candidates({&base, collapse, quadric, state_.origin, keeps_place, state_.scan->scan().float32, keep_direction,
                state_.good_enough},
               options.placement, candidates_);
    for (const Candidate& candidate : candidates_) {
        verdict = ask_candidate(candidate.at == collapse.gone ? reversed(base, collapse) : collapse, candidate);
        if (verdict == Verdict::accepted) {
            break;
        }
        ++answer_->refused[static_cast<std::size_t>(verdict)];
    }
    return verdict;
}

/// What the guards of topology and the candidates read.
void EdgeAsker::note_stars(const Collapse& collapse) {
    if (state_.has_crowded_vertices) {
        return; // then nothing is asked ahead
    }
    state_.base->append_faces_around(collapse.gone, answer_->read);
    state_.base->append_faces_around(collapse.stays, answer_->read);
}

Extent EdgeAsker::extent_of(const Candidate& candidate) const {
    if (candidate.keeps_direction) {
        return Extent::star_of_gone;
    }
    return state_.options->store_directions ? Extent::both_stars : Extent::two_rings;
}

Verdict EdgeAsker::ask_candidate(const Collapse& collapse, const Candidate& candidate) {
    answer_->collapse = collapse;
    answer_->extent = extent_of(candidate);
    fill_patch(candidate);
    const Verdict verdict = guard_faces(*state_.base, answer_->patch);
    if (verdict != Verdict::accepted) {
        return verdict;
    }
    if (!candidate.keeps_direction && state_.options->directions != Directions::face && !set_directions()) {
        return Verdict::direction;
    }
    const Verdict judged = validator_.judge(answer_->patch);
    answer_->read.insert(answer_->read.end(), answer_->patch.removed.begin(), answer_->patch.removed.end());
    validator_.append_read(answer_->read);
    Trial& trial = validator_.trial();
    answer_->retested_vertices += trial.retested;
    answer_->refused_between_vertices += trial.vertices_pass && is_between_vertices(judged) ? 1 : 0;
    if (judged == Verdict::accepted) {
        std::swap(answer_->trial, trial);
    }
    return judged;
}

void EdgeAsker::fill_patch(const Candidate& candidate) {
    const BaseSurface& base = *state_.base;
    const Collapse& collapse = answer_->collapse;
    fill_faces(base, collapse, answer_->extent, answer_->patch);
    BaseVertex gone = base.vertex(collapse.gone);
    gone.scan_vertex = -1;
    answer_->patch.changed.push_back({collapse.gone, gone});
    if (!candidate.keeps_direction) {
        BaseVertex survivor = base.vertex(collapse.stays);
        survivor.position = candidate.position;
        survivor.scan_vertex = candidate.at == collapse.stays ? survivor.scan_vertex : -1;
        answer_->patch.changed.push_back({collapse.stays, survivor});
    }
}

bool EdgeAsker::set_directions() {
    const Collapse& collapse = answer_->collapse;
    const std::optional<Vec3> survivor = direction_of(collapse.stays);
    if (!survivor) {
        return false;
    }
    answer_->patch.changed[1].value.direction = *survivor;
    if (state_.options->store_directions) {
        return true;
    }
    rim_of(*state_.base, collapse, rim_);
    for (const std::int32_t v : rim_) {
        const std::optional<Vec3> direction = direction_of(v);
        if (!direction) {
            return false;
        }
        BaseVertex vertex = state_.base->vertex(v);
        vertex.direction = *direction;
        answer_->patch.changed.push_back({v, vertex});
    }
    return true;
}

std::optional<Vec3> EdgeAsker::direction_of(std::int32_t v) {
    std::optional<Vec3> direction;
    if (state_.options->directions == Directions::visible) {
        direction = v == answer_->collapse.stays ? visible_direction_of_survivor() : visible_direction_of(v);
    }
    if (!direction) {
        // Also where no single direction sees every scan face on the star: the validator asks less, that each scan face
        // be seen where it lies.
        direction = star_normal(v);
    }
    return direction ? std::optional<Vec3>(stored_direction(*direction)) : std::nullopt;
}

/// Of the faces of the patch around a vertex.
std::optional<Vec3> EdgeAsker::star_normal(std::int32_t v) {
    star_.clear();
    for (const PatchFace& face : answer_->patch.added) {
        if (std::find(face.corners.begin(), face.corners.end(), v) == face.corners.end()) {
            continue;
        }
        std::array<Vec3, 3> positions;
        for (int k = 0; k < 3; ++k) {
            const bool moved = face.corners[k] == answer_->collapse.stays;
            positions[k] =
                moved ? answer_->patch.changed[1].value.position : state_.base->vertex(face.corners[k]).position;
        }
        star_.push_back(from_corner(face.corners, positions, v));
    }
    return vertex_normal(star_, state_.options->directions == Directions::angle ? Directions::angle : Directions::area);
}

const std::optional<Vec3>& EdgeAsker::visible_direction_of_survivor() {
    // The scan faces around the two ends are the same for all candidates of an edge.
    if (!survivor_is_known_) {
        visible_from_survivor_ = visible_direction_of(answer_->collapse.stays);
        survivor_is_known_ = true;
    }
    return visible_from_survivor_;
}

std::optional<Vec3> EdgeAsker::visible_direction_of(std::int32_t v) {
    star_faces_.clear();
    for (const std::int32_t f : answer_->patch.removed) {
        const Triangle corners = state_.base->corners(f);
        const bool around = std::any_of(corners.begin(), corners.end(), [&](std::int32_t corner) {
            return corner == v || (v == answer_->collapse.stays && corner == answer_->collapse.gone);
        });
        if (around && !is_frozen(f)) {
            star_faces_.push_back(f);
        }
    }
    const std::vector<std::int32_t>& scan_faces = validator_.gather(star_faces_);
    normals_.reserve(scan_faces.size()); // the last patches hold much of the scan
    for (const std::int32_t f : scan_faces) {
        normals_.push_back(state_.scan->unit_normal(f));
    }
    std::optional<Vec3> direction = most_visible_direction(normals_);
    clear_scratch(normals_);
    return direction;
}

bool EdgeAsker::is_frozen(std::int32_t face) const {
    if (!state_.base->face(face).is_scan_face) {
        return false;
    }
    const Triangle corners = state_.base->corners(face);
    return std::all_of(corners.begin(), corners.end(),
                       [&](std::int32_t v) { return (*state_.mobility)[v] == Mobility::fixed; });
}

} // namespace foldless
