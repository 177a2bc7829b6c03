#include <foldless/bake/subdivision.h>

#include <algorithm>
#include <tuple>

namespace foldless {
namespace {

struct Side {
    std::int32_t low, high; ///< the ends
    std::int32_t face;
    int opposite; ///< corner
};

} // namespace

Subdivision::Subdivision(std::size_t vertices, const std::vector<Triangle>& faces, int level)
    : vertices_(vertices), faces_(faces), segments_(1 << level), edges_(faces.size()) {
    std::vector<Side> sides;
    sides.reserve(3 * faces.size());
    for (std::int32_t face = 0; face < static_cast<std::int32_t>(faces.size()); ++face) {
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(faces[face][(k + 1) % 3], faces[face][(k + 2) % 3]);
            sides.push_back({low, high, face, k});
        }
    }
    const auto ends = [](const Side& side) { return std::pair(side.low, side.high); };
    std::sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) {
        return std::tuple(a.low, a.high, a.face) < std::tuple(b.low, b.high, b.face);
    });
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if (i == 0 || ends(sides[i]) != ends(sides[i - 1])) {
            ++edge_count_;
        }
        edges_[sides[i].face][sides[i].opposite] = static_cast<std::int32_t>(edge_count_ - 1);
    }
}

std::size_t Subdivision::vertex_count() const {
    const auto n = static_cast<std::size_t>(segments_);
    const std::size_t inside = n < 3 ? 0 : (n - 1) * (n - 2) / 2;
    return vertices_ + edge_count_ * (n - 1) + faces_.size() * inside;
}

std::size_t Subdivision::vertex(std::int32_t face, const Weights& weights) const {
    for (int k = 0; k < 3; ++k) {
        if (weights[k] == segments_) {
            return static_cast<std::size_t>(faces_[face][k]);
        }
    }
    for (int k = 0; k < 3; ++k) {
        if (weights[k] == 0) {
            return on_edge(face, k, weights);
        }
    }
    // Rows of constant c >= 1 hold b = 1 to segments - c - 1.
    const auto n = static_cast<std::size_t>(segments_);
    const auto row = static_cast<std::size_t>(weights[2]) - 1;
    const std::size_t before = row * (n - 2) - row * (row - 1) / 2; // for row 0 the product is zero
    return vertices_ + edge_count_ * (n - 1) + static_cast<std::size_t>(face) * ((n - 1) * (n - 2) / 2) + before +
           static_cast<std::size_t>(weights[1]) - 1;
}

std::size_t Subdivision::on_edge(std::int32_t face, int opposite, const Weights& weights) const {
    const int first = (opposite + 1) % 3;
    const int second = (opposite + 2) % 3;
    const int from_low = faces_[face][first] < faces_[face][second] ? weights[second] : weights[first];
    return vertices_ + static_cast<std::size_t>(edges_[face][opposite]) * (static_cast<std::size_t>(segments_) - 1) +
           static_cast<std::size_t>(from_low) - 1;
}

} // namespace foldless
