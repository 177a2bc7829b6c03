#include <foldless/bake/split_vertices.h>

#include <map>
#include <tuple>
#include <utility>

namespace foldless {

namespace {

/// Rounded; zero has no sign, so that what is equal has equal bits.
Eigen::Vector2f stored(const Eigen::Vector2d& uv) {
    return {static_cast<float>(uv.x()) + 0.0F, static_cast<float>(uv.y()) + 0.0F};
}

class Splitter {
public:
    std::uint32_t vertex(std::int32_t base_vertex, const Eigen::Vector2f& uv) {
        const auto next = static_cast<std::uint32_t>(split_.uv.size());
        const auto [entry, is_new] = known_.try_emplace({base_vertex, uv.x(), uv.y()}, next);
        if (is_new) {
            split_.base_vertex.push_back(base_vertex);
            split_.uv.push_back(uv);
        }
        return entry->second;
    }

    void add_face(const Triangle& face, const std::array<Eigen::Vector2d, 3>& uv) {
        split_.faces.push_back(
            {vertex(face[0], stored(uv[0])), vertex(face[1], stored(uv[1])), vertex(face[2], stored(uv[2]))});
    }

    SplitVertices take() { return std::move(split_); }

private:
    SplitVertices split_;
    std::map<std::tuple<std::int32_t, float, float>, std::uint32_t> known_;
};

} // namespace

SplitVertices split_vertices(const TexturedMesh& mesh) {
    Splitter splitter;
    for (std::size_t face = 0; face < mesh.uv.size(); ++face) {
        splitter.add_face(mesh.base->faces[face], mesh.uv[face]);
    }
    return splitter.take();
}

} // namespace foldless
