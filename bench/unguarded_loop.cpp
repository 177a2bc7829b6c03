#include <foldless/bench/unguarded_loop.h>

#include <foldless/decimate/collapse.h>
#include <foldless/decimate/edge_order.h>
#include <foldless/decimate/local_order.h>
#include <foldless/decimate/placement.h>
#include <foldless/decimate/quadric.h>
#include <foldless/io/defects.h>
#include <foldless/report/process_usage.h>

#include <cmath>
#include <vector>

namespace foldless {
namespace {

class UnguardedLoop {
public:
    UnguardedLoop(const Scan& scan, const DecimateOptions& options);
    void run();

    [[nodiscard]] const UnguardedResult& result() const { return result_; }

private:
    void lock_border();
    [[nodiscard]] bool ask(std::int32_t edge);
    [[nodiscard]] Verdict ask_candidate(const Collapse& collapse, const Candidate& candidate);
    void commit();

    const Scan* scan_;
    const DecimateOptions* options_;
    BaseSurface base_;
    std::vector<Mobility> mobility_;
    ScanTopology topology_;
    VertexQuadrics quadrics_;
    EdgeQueue queue_;
    UnguardedResult result_;

    // The collapse under question.
    Collapse collapse_;
    Patch patch_;
    std::vector<Candidate> candidates_;
    std::vector<std::int32_t> edges_;
};

UnguardedLoop::UnguardedLoop(const Scan& scan, const DecimateOptions& options)
    : scan_(&scan), options_(&options), base_(scan), mobility_(scan.positions.size(), Mobility::free), topology_(scan),
      quadrics_(scan, topology_, scan.positions[scan.faces[0][0]]), queue_(all_edges(base_)) {
    result_.faces = scan.faces.size();
    if (options.boundary == Boundary::lock) {
        lock_border();
    }
}

void UnguardedLoop::lock_border() {
    for (std::size_t v = 0; v < mobility_.size(); ++v) {
        if (base_.is_border_vertex(static_cast<std::int32_t>(v))) {
            mobility_[v] = Mobility::fixed;
        }
    }
}

void UnguardedLoop::run() {
    while (!options_->target_faces || result_.faces > *options_->target_faces) {
        const std::optional<std::int32_t> edge = queue_.pop();
        if (!edge) {
            return;
        }
        ++result_.attempted;
        if (ask(*edge)) {
            commit();
            ++result_.accepted;
        } else {
            queue_.refuse(*edge);
        }
    }
}

bool UnguardedLoop::ask(std::int32_t edge) {
    Collapse collapse;
    if (make_collapse(base_, edge, {mobility_, options_->edge_valence_limit}, collapse) != Verdict::accepted) {
        return false;
    }
    Quadric quadric = quadrics_[collapse.gone];
    quadric += quadrics_[collapse.stays];
    const bool keeps_place = mobility_[collapse.stays] == Mobility::fixed ||
                             (base_.is_border_vertex(collapse.stays) && !base_.is_border_vertex(collapse.gone));
    // Without a validator nothing is saved by an end that keeps its direction: least error first.
    const Vec3& origin = scan_->positions[scan_->faces[0][0]];
    candidates({&base_, collapse, quadric, origin, keeps_place, scan_->float32, false, 0.0}, options_->placement,
               candidates_);
    for (const Candidate& candidate : candidates_) {
        const bool ends_exchanged = candidate.at == collapse.gone;
        if (ask_candidate(ends_exchanged ? reversed(base_, collapse) : collapse, candidate) == Verdict::accepted) {
            return true;
        }
    }
    return false;
}

Verdict UnguardedLoop::ask_candidate(const Collapse& collapse, const Candidate& candidate) {
    collapse_ = collapse;
    fill_faces(base_, collapse, Extent::both_stars, patch_);
    BaseVertex survivor = base_.vertex(collapse.stays);
    survivor.position = candidate.position;
    survivor.scan_vertex = candidate.at == collapse.stays ? survivor.scan_vertex : -1;
    patch_.changed.push_back({collapse.stays, survivor});
    return guard_faces(base_, patch_);
}

void UnguardedLoop::commit() {
    edges_changed_by(base_, collapse_, Extent::both_stars, edges_);
    base_.connectivity().collapse(collapse_.halfedge);
    quadrics_.merge(collapse_.stays, collapse_.gone);
    base_.set_vertex(collapse_.stays, patch_.changed[0].value);
    base_.drop_vertex(collapse_.gone);
    result_.faces -= patch_.removed.size() - patch_.added.size();
    requeue(base_, collapse_.stays, edges_, queue_);
}

} // namespace

UnguardedResult unguarded_decimate(const Scan& scan, const DecimateOptions& options) {
    const double start = process_cpu_seconds();
    require_no_defects(scan);
    const Scan ordered = in_order(scan, local_order(scan));
    UnguardedLoop loop(ordered, options);
    const double set_up = process_cpu_seconds();
    loop.run();
    UnguardedResult result = loop.result();
    result.setup_cpu_seconds = set_up - start;
    result.decimate_cpu_seconds = process_cpu_seconds() - set_up;
    return result;
}

} // namespace foldless
