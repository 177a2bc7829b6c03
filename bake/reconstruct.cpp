#include <foldless/bake/reconstruct.h>

#include <foldless/bake/subdivision.h>

#include <foldless/predicates/default_arithmetic.h>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace foldless {
namespace {

constexpr double half = 0.5; // of the coverage

/// Of an edge. The cover does not end nearer to either end, so that what is cut off, and what is left, has an area in
/// rounded coordinates too.
constexpr double least_share = 1.0 / 64;

class Reconstructor {
public:
    Reconstructor(const BaseMesh& base, const MapValueAt& value_at, int level)
        : base_(base), value_at_(value_at), subdivision_(base.positions.size(), base.faces, level) {}

    Scan run() {
        if (subdivision_.vertex_count() > std::numeric_limits<std::int32_t>::max()) {
            throw std::length_error("more vertices than 32 bits count");
        }
        surface_.float32 = false;
        surface_.positions.resize(subdivision_.vertex_count());
        covered_.assign(subdivision_.vertex_count(), 0);
        claim_borders();
        const std::size_t faces = base_.faces.size();
        tbb::parallel_for(std::size_t{0}, faces, [&](std::size_t face) { displace(static_cast<std::int32_t>(face)); });
        join_faces();
        drop_unused();
        return std::move(surface_);
    }

private:
    /// The lowest face around each vertex on an edge or corner of the base mesh.
    void claim_borders() {
        owner_.assign(subdivision_.vertex_count(), -1);
        for (std::int32_t face = 0; face < static_cast<std::int32_t>(base_.faces.size()); ++face) {
            for_each_vertex([&](const Subdivision::Weights& weights) {
                std::int32_t& owner = owner_[subdivision_.vertex(face, weights)];
                owner = owner < 0 ? face : owner;
            });
        }
    }

    template <class Visit>
    void for_each_vertex(Visit visit) const {
        const int n = subdivision_.segments();
        for (int c = 0; c <= n; ++c) {
            for (int b = 0; b + c <= n; ++b) {
                visit(Subdivision::Weights{n - b - c, b, c});
            }
        }
    }

    /// Each vertex has one owner, so that no two threads write to one.
    void displace(std::int32_t face) {
        for_each_vertex([&](const Subdivision::Weights& weights) {
            const std::size_t vertex = subdivision_.vertex(face, weights);
            if (owner_[vertex] == face) {
                const Vec3 alpha = coordinates(weights);
                const MapValue value = value_at_(face, alpha);
                surface_.positions[vertex] = displaced(face, alpha, value.t);
                covered_[vertex] = value.coverage >= half ? 1 : 0;
            }
        });
    }

    [[nodiscard]] Vec3 coordinates(const Subdivision::Weights& weights) const {
        const double n = subdivision_.segments();
        return {weights[0] / n, weights[1] / n, weights[2] / n};
    }

    [[nodiscard]] Vec3 displaced(std::int32_t face, const Vec3& alpha, double t) const {
        Vec3 x = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            const std::int32_t corner = base_.faces[face][k];
            x += alpha[k] * (base_.positions[corner] + t * base_.directions[corner]);
        }
        return x;
    }

    void join_faces() {
        for (std::int32_t face = 0; face < static_cast<std::int32_t>(base_.faces.size()); ++face) {
            subdivision_.for_each_face([&](const auto&... corners) { join_face(face, {corners...}); });
        }
    }

    /// Adds the covered part of a small face: a triangle, the whole or a corner of it, or what is left without a
    /// corner.
    void join_face(std::int32_t face, const std::array<Subdivision::Weights, 3>& corners) {
        std::vector<std::int32_t>& rim = rim_;
        rim.clear();
        for (int k = 0; k < 3; ++k) {
            const std::size_t vertex = subdivision_.vertex(face, corners[k]);
            const std::size_t next = subdivision_.vertex(face, corners[(k + 1) % 3]);
            if (covered_[vertex]) {
                rim.push_back(static_cast<std::int32_t>(vertex));
            }
            if (covered_[vertex] != covered_[next]) {
                rim.push_back(end_of_cover(face, corners[k], corners[(k + 1) % 3]));
            }
        }
        rim.erase(std::unique(rim.begin(), rim.end()), rim.end());
        for (std::size_t k = 2; k < rim.size(); ++k) {
            if (rim[k] != rim[0]) {
                surface_.faces.push_back({rim[0], rim[k - 1], rim[k]});
            }
        }
    }

    /// The vertex where the cover ends on the edge between two vertices, made when it is first asked for: by the lowest
    /// face that has the edge. It is the covered end where the cover reaches no further, or where the map of that face
    /// does not cover what another one covers.
    std::int32_t end_of_cover(std::int32_t face, const Subdivision::Weights& a, const Subdivision::Weights& b) {
        const bool a_is_covered = covered_[subdivision_.vertex(face, a)];
        const Subdivision::Weights& covered = a_is_covered ? a : b;
        const Subdivision::Weights& bare = a_is_covered ? b : a;
        const std::pair ends{subdivision_.vertex(face, covered), subdivision_.vertex(face, bare)};
        const auto [found, is_new] = ends_of_cover_.try_emplace(ends, static_cast<std::int32_t>(ends.first));
        const double share = is_new ? covered_share(face, coordinates(covered), coordinates(bare)) : 0.0;
        if (share > least_share) {
            const double s = std::min(share, 1.0 - least_share);
            const Vec3 alpha = (1.0 - s) * coordinates(covered) + s * coordinates(bare);
            found->second = static_cast<std::int32_t>(surface_.positions.size());
            surface_.positions.push_back(displaced(face, alpha, value_at_(face, alpha).t));
        }
        return found->second;
    }

    /// How far the cover reaches from one point to another, which is bare, by halving; 0 if this face covers none of
    /// it.
    [[nodiscard]] double covered_share(std::int32_t face, const Vec3& covered, const Vec3& bare) const {
        constexpr int halvings = 30; // of an edge: less than any texel
        double share = 0.0;
        double beyond = 1.0;
        for (int i = 0; i < halvings; ++i) {
            const double middle = 0.5 * (share + beyond);
            const Vec3 alpha = (1.0 - middle) * covered + middle * bare;
            (value_at_(face, alpha).coverage >= half ? share : beyond) = middle;
        }
        return share;
    }

    void drop_unused() {
        std::vector<std::int32_t> number(surface_.positions.size(), -1);
        for (const Triangle& face : surface_.faces) {
            for (const std::int32_t vertex : face) {
                number[vertex] = 0;
            }
        }
        std::int32_t count = 0;
        for (std::size_t vertex = 0; vertex < number.size(); ++vertex) {
            if (number[vertex] == 0) {
                surface_.positions[count] = surface_.positions[vertex];
                number[vertex] = count++;
            }
        }
        surface_.positions.resize(static_cast<std::size_t>(count));
        for (Triangle& face : surface_.faces) {
            for (std::int32_t& vertex : face) {
                vertex = number[vertex];
            }
        }
    }

    const BaseMesh& base_;
    const MapValueAt& value_at_;
    Subdivision subdivision_;
    Scan surface_;
    std::vector<std::uint8_t> covered_; ///< of each vertex of the subdivision
    std::vector<std::int32_t> owner_;
    std::map<std::pair<std::size_t, std::size_t>, std::int32_t> ends_of_cover_;
    std::vector<std::int32_t> rim_; ///< room for join_face()
};

} // namespace

Scan reconstruct(const BaseMesh& base, const MapValueAt& value_at, const ReconstructOptions& options) {
    if (options.level < 0 || options.level > ReconstructOptions::max_level) {
        throw std::invalid_argument("ReconstructOptions: level is out of bounds");
    }
    if (!base.face_directions.empty()) {
        throw std::invalid_argument("a base mesh with constant face directions has no surface without gaps");
    }
    if (options.threads.value_or(1) < 1) {
        throw std::invalid_argument("ReconstructOptions: threads is less than 1");
    }
    const DefaultArithmetic arithmetic;
    const auto allowed =
        static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
    tbb::task_arena arena(std::min(options.threads.value_or(allowed), allowed));
    return arena.execute([&] { return Reconstructor(base, value_at, options.level).run(); });
}

} // namespace foldless
