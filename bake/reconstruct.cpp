#include <foldless/bake/reconstruct.h>

#include <foldless/bake/subdivision.h>

#include <foldless/predicates/default_arithmetic.h>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace foldless {
namespace {

class Reconstructor {
public:
    Reconstructor(const BaseMesh& base, const DisplacementAt& displacement_at, int level)
        : base_(base), displacement_at_(displacement_at), subdivision_(base.positions.size(), base.faces, level) {}

    Scan run() {
        if (subdivision_.vertex_count() > std::numeric_limits<std::int32_t>::max()) {
            throw std::length_error("more vertices than 32 bits count");
        }
        surface_.float32 = false;
        surface_.positions.resize(subdivision_.vertex_count());
        exists_.assign(subdivision_.vertex_count(), 0);
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
        const Triangle& corners = base_.faces[face];
        const double n = subdivision_.segments();
        for_each_vertex([&](const Subdivision::Weights& weights) {
            const std::size_t vertex = subdivision_.vertex(face, weights);
            if (owner_[vertex] != face) {
                return;
            }
            const Vec3 alpha(weights[0] / n, weights[1] / n, weights[2] / n);
            const std::optional<double> t = displacement_at_(face, alpha);
            if (!t) {
                return;
            }
            Vec3 x = Vec3::Zero();
            for (int k = 0; k < 3; ++k) {
                x += alpha[k] * (base_.positions[corners[k]] + *t * base_.directions[corners[k]]);
            }
            surface_.positions[vertex] = x;
            exists_[vertex] = 1;
        });
    }

    void join_faces() {
        for (std::int32_t face = 0; face < static_cast<std::int32_t>(base_.faces.size()); ++face) {
            subdivision_.for_each_face([&](const auto&... corners) {
                const Triangle small{static_cast<std::int32_t>(subdivision_.vertex(face, corners))...};
                if (exists_[small[0]] && exists_[small[1]] && exists_[small[2]]) {
                    surface_.faces.push_back(small);
                }
            });
        }
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
    const DisplacementAt& displacement_at_;
    Subdivision subdivision_;
    Scan surface_;
    std::vector<std::uint8_t> exists_;
    std::vector<std::int32_t> owner_;
};

} // namespace

Scan reconstruct(const BaseMesh& base, const DisplacementAt& displacement_at, const ReconstructOptions& options) {
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
    return arena.execute([&] { return Reconstructor(base, displacement_at, options.level).run(); });
}

} // namespace foldless
