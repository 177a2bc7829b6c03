#include <foldless/decimate/patch_image.h>

#include <foldless/decimate/scratch.h>

#include <optional>

namespace foldless {

PatchImage::PatchImage(const Scan& scan, const ScanTopology& topology, bool constant_directions)
    : scan_(&scan), topology_(&topology), constant_directions_(constant_directions) {}

void PatchImage::reset(PatchedSurface& surface, PatchRanges& ranges) {
    surface_ = &surface;
    ranges_ = &ranges;
    orders_used_ = 0;
    ordered_.clear();
    clear();
}

void PatchImage::clear() {
    moved_.clear();
    clear_scratch(lifts_);
    traces_.clear();
}

void PatchImage::reserve(std::size_t places) {
    moved_.reserve(places);
    lifts_.reserve(places);
}

void PatchImage::add(std::int32_t scan_vertex, const Lift& lift) {
    moved_.set(scan_vertex, static_cast<std::int32_t>(lifts_.size()));
    lifts_.push_back({scan_vertex, lift});
}

Verdict PatchImage::order_fans(const Patch& patch) {
    for (const PatchFace& face : patch.added) {
        for (const std::int32_t v : face.corners) {
            const std::int32_t scan_vertex = surface_->vertex(v).scan_vertex;
            if (scan_vertex < 0 || ordered_.contains(scan_vertex)) {
                continue;
            }
            const Verdict verdict = order_fan(v, scan_vertex);
            if (verdict != Verdict::accepted) {
                return verdict;
            }
        }
    }
    return Verdict::accepted;
}

Verdict PatchImage::order_fan(std::int32_t base_vertex, std::int32_t scan_vertex) {
    if (orders_used_ == orders_.size()) {
        orders_.emplace_back();
    }
    const Verdict verdict = orders_[orders_used_].reset(base_vertex, *surface_, *scan_, *topology_);
    if (verdict == Verdict::accepted) {
        ordered_.set(scan_vertex, static_cast<std::int32_t>(orders_used_));
        ++orders_used_;
    }
    return verdict;
}

const FanOrder* PatchImage::order_of(std::int32_t base_vertex, std::int32_t scan_vertex) {
    const bool known = ordered_.contains(scan_vertex) || order_fan(base_vertex, scan_vertex) == Verdict::accepted;
    return known ? &orders_[ordered_.find(scan_vertex)] : nullptr;
}

Verdict PatchImage::find(std::int32_t scan_vertex, Corner& out) {
    out.scan_vertex = scan_vertex;
    out.cell = -1;
    out.order = nullptr;
    const std::int32_t n = moved(scan_vertex);
    if (n >= 0) {
        out.cell = lifts_[n].lift.cell;
        out.lift = lifts_[n].lift;
        return Verdict::accepted;
    }
    const Place place = surface_->base().place(scan_vertex);
    if (place.kept < 0) {
        return find_staying(place, out);
    }
    if (constant_directions_) {
        return Verdict::accepted;
    }
    out.order = order_of(place.kept, scan_vertex);
    return out.order != nullptr ? Verdict::accepted : Verdict::orientation;
}

Verdict PatchImage::find_staying(const Place& place, Corner& out) {
    out.cell = surface_->cell_of(place.face);
    const std::optional<Lift> lift = lift_of_place(*surface_, out.cell, scan_->positions[out.scan_vertex], place);
    if (!lift) {
        return Verdict::undecided;
    }
    // A corner on the rim of the patch was with the outer cell; now the new one is the lower.
    out.lift = in_lower_cell(*surface_, *lift);
    out.cell = out.lift.cell;
    return lift->walls == 0 ? Verdict::accepted : ranges_->reach(out.cell, point_in(out.cell, out).t);
}

PrismoidPoint PatchImage::point_in(int cell, const Corner& corner) const {
    if (corner.order != nullptr) {
        return {Displacement(), walls_at_corner(surface_->corner_of(cell, corner.order->vertex()))};
    }
    return corner.lift.point(surface_->cell(cell).triangle, scan_->positions[corner.scan_vertex]);
}

bool PatchImage::holds(int cell, const Corner& corner) const {
    return corner.order == nullptr ? corner.cell == cell : surface_->corner_of(cell, corner.order->vertex()) >= 0;
}

TraceEnd PatchImage::trace_end(const Corner& at, const Corner& other) const {
    const int cell = at.order != nullptr ? at.order->start_cell(other.scan_vertex) : at.cell;
    return {&scan_->positions[at.scan_vertex], cell, point_in(cell, at)};
}

Verdict PatchImage::trace(const Corner& a, const Corner& b, std::vector<TraceCrossing>& crossings) {
    if (a.is_base_edge_to(b)) {
        return Verdict::accepted;
    }
    const Corner& low = a.scan_vertex < b.scan_vertex ? a : b;
    const Corner& high = a.scan_vertex < b.scan_vertex ? b : a;
    const auto follow = [&](std::vector<TraceCrossing>& out) {
        return trace_edge(*surface_, trace_end(low, high), trace_end(high, low), out);
    };
    return traces_.trace(low.scan_vertex, high.scan_vertex, follow, crossings);
}

} // namespace foldless
