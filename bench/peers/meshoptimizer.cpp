// meshoptimizer's meshopt_simplify without options and without a bound on the error: it keeps the topology, and
// vertices of the border move along the border alone.

#include "peer.h"

#include <meshoptimizer.h>

#include <cfloat>
#include <utility>
#include <vector>

namespace {

constexpr float any_error = FLT_MAX;

class Meshoptimizer : public Peer {
public:
    explicit Meshoptimizer(const PlainMesh& scan) : points_(scan.points), indices_(3 * scan.faces.size()) {
        std::size_t place = 0;
        for (const auto& face : scan.faces) {
            for (const std::uint32_t corner : face) {
                indices_[place++] = corner;
            }
        }
    }

    void decimate(std::size_t faces) override {
        std::vector<unsigned int> left(indices_.size()); // as much as the library asks for
        left.resize(meshopt_simplify(left.data(), indices_.data(), indices_.size(), points_[0].data(), points_.size(),
                                     sizeof points_[0], 3 * faces, any_error, 0, nullptr));
        indices_ = std::move(left);
    }

    PlainMesh result() const override {
        PlainMesh plain;
        std::vector<std::uint32_t> number(points_.size(), unused);
        for (std::size_t first = 0; first + 2 < indices_.size(); first += 3) {
            auto& corners = plain.faces.emplace_back();
            for (std::size_t k = 0; k < corners.size(); ++k) {
                std::uint32_t& vertex = number[indices_[first + k]];
                if (vertex == unused) {
                    vertex = static_cast<std::uint32_t>(plain.points.size());
                    plain.points.push_back(points_[indices_[first + k]]);
                }
                corners[k] = vertex;
            }
        }
        return plain;
    }

private:
    static constexpr std::uint32_t unused = UINT32_MAX;

    std::vector<std::array<float, 3>> points_;
    std::vector<unsigned int> indices_;
};

} // namespace

std::unique_ptr<Peer> make_peer(const PlainMesh& scan) {
    return std::make_unique<Meshoptimizer>(scan);
}
