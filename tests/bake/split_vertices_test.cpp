#include <foldless/bake/split_vertices.h>

#include "textured_meshes.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

namespace foldless {
namespace {

using Faces = std::vector<std::array<std::uint32_t, 3>>;

TEST(SplitVertices, SharesAVertexWhereThePictureGoesOn) {
    const SplitVertices split = split_vertices(square().textured());
    EXPECT_EQ(split.base_vertex, (std::vector<std::int32_t>{0, 1, 2, 3}));
    EXPECT_EQ(split.faces, (Faces{{0, 1, 2}, {0, 2, 3}}));
}

TEST(SplitVertices, CopiesOnlyTheVerticesWhereThePictureIsCut) {
    MadeMesh mesh = square();
    mesh.uv[1][1].x() = 0.5; // vertex 2, in the second face
    const SplitVertices split = split_vertices(mesh.textured());
    EXPECT_EQ(split.base_vertex, (std::vector<std::int32_t>{0, 1, 2, 2, 3}));
    EXPECT_EQ(split.faces, (Faces{{0, 1, 2}, {0, 3, 4}}));
    EXPECT_EQ(split.uv[3], Eigen::Vector2f(0.5F, 0));
}

TEST(SplitVertices, MakesAsManyAsThereAreDifferentPlaces) {
    const MadeMesh mesh = cut_grid(6);
    std::set<std::tuple<int, float, float>> places;
    for (std::size_t face = 0; face < mesh.uv.size(); ++face) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Eigen::Vector2f uv = mesh.uv[face][corner].cast<float>();
            places.emplace(mesh.base.faces[face][corner], uv.x(), uv.y());
        }
    }
    EXPECT_EQ(places.size(), 7U * 7U + 7U) << "the vertices, and those on the cut again";
    EXPECT_EQ(split_vertices(mesh.textured()).uv.size(), places.size());
}

TEST(SplitVertices, SharesWhatIsEqualOnceItIsStored) {
    MadeMesh mesh = square();
    mesh.uv[1][1] = {1 + 1e-12, -0.0}; // (1, 0) in the first face
    EXPECT_EQ(split_vertices(mesh.textured()).uv.size(), 4U);
}

TEST(SplitVertices, KeepsVerticesOfTheSamePlaceApart) {
    MadeMesh mesh = square();
    mesh.uv[0].fill({0.5, 0.5});
    mesh.uv[1].fill({0.5, 0.5});
    EXPECT_EQ(split_vertices(mesh.textured()).base_vertex, (std::vector<std::int32_t>{0, 1, 2, 3}));
}

TEST(SplitVertices, LeavesOutVerticesWithoutFaces) {
    MadeMesh mesh = square();
    mesh.base.faces.pop_back();
    mesh.uv.pop_back();
    EXPECT_EQ(split_vertices(mesh.textured()).base_vertex, (std::vector<std::int32_t>{0, 1, 2}));
}

} // namespace
} // namespace foldless
