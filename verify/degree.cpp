#include <foldless/verify/degree.h>

#include <foldless/io/union_find.h>

namespace foldless::verification {

Degree::Degree(const BaseFaces& base, const Meshes& meshes)
    : base_(&base), counted_as_(meshes.base.positions.size(), -1) {
    UnionFind sets(meshes.base.positions.size());
    for (const Triangle& face : meshes.base.faces) {
        sets.join(static_cast<std::uint32_t>(face[0]), static_cast<std::uint32_t>(face[1]));
        sets.join(static_cast<std::uint32_t>(face[0]), static_cast<std::uint32_t>(face[2]));
    }
    const auto lowest = [&](std::int32_t v) {
        return static_cast<std::int32_t>(sets.find(static_cast<std::uint32_t>(v)));
    };
    for (std::size_t f = 0; f < meshes.base.faces.size(); ++f) {
        const std::int32_t vertex = lowest(meshes.base.faces[f][0]);
        if (counted_as_[vertex] < 0) {
            counted_as_[vertex] = static_cast<std::int32_t>(components_.size());
            components_.push_back({vertex});
        }
        component_.push_back(counted_as_[vertex]);
        Component& component = components_[counted_as_[vertex]];
        const auto face = static_cast<std::int32_t>(f);
        const bool has_border = base.adjacency().neighbour(face, 0) < 0 || base.adjacency().neighbour(face, 1) < 0 ||
                                base.adjacency().neighbour(face, 2) < 0;
        component.is_settled = component.is_settled || !base.is_moving(face) || has_border;
    }
    for (std::size_t v = 0; v < meshes.base.positions.size(); ++v) {
        const std::int32_t component = counted_as_[lowest(static_cast<std::int32_t>(v))];
        if (component >= 0 && base.is_kept(static_cast<std::int32_t>(v))) {
            components_[component].is_settled = true;
        }
    }
    counts_ = std::make_unique<std::atomic<std::int32_t>[]>(components_.size());
}

void Degree::count(const std::vector<std::int32_t>& inside) {
    for (const std::int32_t vertex : inside) {
        if (counted_as_[vertex] >= 0) {
            counts_[counted_as_[vertex]].fetch_add(1, std::memory_order_relaxed);
        }
    }
}

void Degree::settle(std::int32_t face) {
    components_[component_[face]].is_settled = true;
}

void Degree::check(const Association& association, Findings& findings) const {
    std::vector<std::int32_t> counts(components_.size());
    for (std::size_t c = 0; c < components_.size(); ++c) {
        counts[c] = counts_[c].load();
    }
    for (std::size_t v = 0; v < association.size(); ++v) {
        const std::int32_t pillar = association.place(static_cast<std::int32_t>(v)).pillar;
        if (pillar >= 0 && counted_as_[pillar] >= 0) {
            ++counts[counted_as_[pillar]];
        }
    }
    for (std::size_t c = 0; c < components_.size(); ++c) {
        if (!components_[c].is_settled && counts[c] != 1) {
            findings.add({.violation = Violation::degree,
                          .base_face = base_->adjacency().faces_around(components_[c].vertex).front(),
                          .position = base_->mesh().positions[components_[c].vertex]});
        }
    }
}

} // namespace foldless::verification
