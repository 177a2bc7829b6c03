#include <foldless/decimate/answers_ahead.h>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>

namespace foldless {
namespace {

/// Edges asked at once, per thread: enough to even out that some take longer than others. Among more of them one is
/// more often asked in vain, because it lies beside another that is collapsed first.
constexpr std::size_t ahead_per_thread = 4;

/// Edges of the queue that are looked at to find those.
constexpr std::size_t looked_at_per_slot = 3;

/// One where vertices are crowded: an answer beside one would rest on thousands of faces.
std::size_t number_of_askers(const AskedState& state) {
    return state.has_crowded_vertices ? 1 : static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
}

} // namespace

AnswersAhead::AnswersAhead(const AskedState& state) : state_(state), askers_(number_of_askers(state)) {
    if (askers_.size() > 1) {
        changed_at_.resize(state.base->face_slots(), 0);
    }
    slots_.resize(askers_.size() > 1 ? askers_.size() * ahead_per_thread : 1);
}

const EdgeAnswer& AnswersAhead::answer(std::int32_t edge, EdgeQueue& queue) {
    if (askers_.size() == 1) {
        slots_.front().edge = edge;
        ask(slots_.front(), 0);
        return slots_.front().answer;
    }
    const Slot* slot = find(edge);
    if (slot == nullptr) {
        choose(edge, queue);
        ask_chosen();
        slot = find(edge);
    }
    return slot->answer;
}

void AnswersAhead::about_to_change(const Patch& patch) {
    if (askers_.size() == 1) {
        return; // nothing is asked ahead
    }
    ++changes_;
    for (const std::int32_t face : patch.removed) {
        changed_at_[face] = changes_;
    }
}

void AnswersAhead::forget() {
    for (Slot& slot : slots_) {
        slot.edge = -1;
    }
    if (!changed_at_.empty()) {
        changed_at_.assign(state_.base->face_slots(), changes_); // what is asked from now on stands
        changed_at_.shrink_to_fit();
    }
}

AnswersAhead::Slot* AnswersAhead::find(std::int32_t edge) {
    const auto slot = std::find_if(slots_.begin(), slots_.end(), [edge](const Slot& s) { return s.edge == edge; });
    return slot != slots_.end() && stands(*slot) ? &*slot : nullptr;
}

bool AnswersAhead::stands(const Slot& slot) const {
    return std::all_of(slot.answer.read.begin(), slot.answer.read.end(),
                       [&](std::int32_t face) { return changed_at_[face] <= slot.asked_at; });
}

/// The edge and those next in the queue, as many as there are slots, unless their answers stand.
void AnswersAhead::choose(std::int32_t edge, EdgeQueue& queue) {
    next_.assign(1, edge);
    queue.look_ahead(looked_at_per_slot * slots_.size(), next_);
    keep_those_apart();
    for (Slot& slot : slots_) {
        const bool is_wanted = std::find(next_.begin(), next_.end(), slot.edge) != next_.end();
        slot.edge = is_wanted && stands(slot) ? slot.edge : -1;
    }
    chosen_.clear();
    auto free = slots_.begin();
    for (const std::int32_t e : next_) {
        if (find(e) != nullptr) {
            continue;
        }
        free = std::find_if(free, slots_.end(), [](const Slot& slot) { return slot.edge < 0; });
        free->edge = e;
        free->asked_at = changes_;
        chosen_.push_back(&*free);
    }
}

/// Of the edges ahead, leaves those whose stars have no vertex in common with that of one before, which is likely to be
/// collapsed: what is asked of them would be asked in vain.
void AnswersAhead::keep_those_apart() {
    near_.clear();
    std::size_t kept = 0;
    for (const std::int32_t e : next_) {
        star_of(e);
        const bool is_apart =
            std::none_of(star_.begin(), star_.end(), [&](std::int32_t v) { return near_.contains(v); });
        if (kept > 0 && !is_apart) {
            continue;
        }
        for (const std::int32_t v : star_) {
            near_.insert(v);
        }
        next_[kept++] = e;
        if (kept == slots_.size()) {
            break;
        }
    }
    next_.resize(kept);
}

/// The vertices of the faces around both ends.
void AnswersAhead::star_of(std::int32_t edge) {
    const Connectivity& mesh = state_.base->connectivity();
    const OpenMesh::HalfedgeHandle halfedge = mesh.halfedge_handle(OpenMesh::EdgeHandle(edge), 0);
    const std::int32_t from = mesh.from_vertex_handle(halfedge).idx();
    const std::int32_t to = mesh.to_vertex_handle(halfedge).idx();
    rim_of(*state_.base, {halfedge, from, to}, star_);
    star_.insert(star_.end(), {from, to});
}

/// Those that take long first, so that no thread waits long for the last one.
void AnswersAhead::ask_chosen() {
    for (Slot* slot : chosen_) {
        slot->effort = effort_of(slot->edge);
    }
    std::sort(chosen_.begin(), chosen_.end(), [](const Slot* a, const Slot* b) { return a->effort > b->effort; });
    std::atomic<std::size_t> next{0};
    tbb::parallel_for(std::size_t{0}, std::min(askers_.size(), chosen_.size()), [&](std::size_t /*any*/) {
        const auto thread = static_cast<std::size_t>(tbb::this_task_arena::current_thread_index());
        for (std::size_t n = next++; n < chosen_.size(); n = next++) {
            ask(*chosen_[n], thread);
        }
    });
}

/// About how long it takes to ask an edge: the scan faces around its ends.
std::size_t AnswersAhead::effort_of(std::int32_t edge) const {
    const Connectivity& mesh = state_.base->connectivity();
    std::size_t effort = 0;
    for (int side = 0; side < 2; ++side) {
        const OpenMesh::HalfedgeHandle halfedge = mesh.halfedge_handle(OpenMesh::EdgeHandle(edge), side);
        for (const auto face : mesh.vf_range(mesh.to_vertex_handle(halfedge))) {
            effort += state_.base->face(face.idx()).scan_faces.size();
        }
    }
    return effort;
}

void AnswersAhead::ask(Slot& slot, std::size_t thread) {
    if (!askers_[thread]) {
        askers_[thread].emplace(state_);
    }
    askers_[thread]->ask(slot.edge, slot.answer);
}

} // namespace foldless
