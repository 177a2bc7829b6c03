#include <foldless/io/complete_appearance.h>

#include <gtest/gtest.h>

#include <cmath>

namespace foldless {
namespace {

using Colours = std::vector<Eigen::Vector3f>;
using Notes = std::vector<std::string>;

RawMesh triangle(Colours colours) {
    RawMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.faces = {{2, 0, 1}};
    mesh.appearance.colours = std::move(colours);
    return mesh;
}

TEST(CompleteAppearance, TakesIntegersAboveOneForBytes) {
    RawMesh mesh = triangle({{255, 51, 0}, {2, 1, 1}, {0, 0, 0}});
    complete_appearance(mesh);
    EXPECT_EQ(mesh.appearance.colours, (Colours{{1, 0.2F, 0}, {2 / 255.0F, 1 / 255.0F, 1 / 255.0F}, {0, 0, 0}}));
    EXPECT_TRUE(mesh.notes.ignored.empty());
}

TEST(CompleteAppearance, TakesOtherNumbersAsTheyAre) {
    for (const Colours& colours :
         {Colours{{1, 1, 1}, {0, 0, 1}, {0, 0, 0}}, Colours{{0.5F, 0, 1}, {1, 1, 1}, {0, 0, 0}}}) {
        RawMesh mesh = triangle(colours);
        complete_appearance(mesh);
        EXPECT_EQ(mesh.appearance.colours, colours);
        EXPECT_TRUE(mesh.notes.ignored.empty());
    }
}

TEST(CompleteAppearance, KeepsToTheUnitThatIsDeclared) {
    RawMesh mesh = triangle({{1, 1, 1}, {0, 0, 1}, {0, 0, 0}});
    mesh.appearance.colour_unit = 65535.0F;
    complete_appearance(mesh);
    EXPECT_EQ(mesh.appearance.colours[1], Eigen::Vector3f(0, 0, 1 / 65535.0F));
}

TEST(CompleteAppearance, ClampsColoursAndSaysSo) {
    RawMesh mesh = triangle({{1.5F, -0.25F, 1}, {1, 1, 1}, {0, 0, 0}});
    complete_appearance(mesh);
    EXPECT_EQ(mesh.appearance.colours[0], Eigen::Vector3f(1, 0, 1));
    EXPECT_EQ(mesh.notes.ignored, (Notes{"colour values beyond 0 to 1"}));
}

TEST(CompleteAppearance, DropsColoursThatSomeVerticesLack) {
    RawMesh mesh = triangle({{1, 1, 1}, {0, 0, 1}});
    complete_appearance(mesh);
    EXPECT_TRUE(mesh.appearance.colours.empty());
    EXPECT_EQ(mesh.notes.ignored, (Notes{"colours, which some vertices lack"}));
}

TEST(CompleteAppearance, GivesTheCornersTheTextureCoordinatesOfTheirVertices) {
    RawMesh mesh = triangle({});
    mesh.appearance.vertex_texture_coordinates = {{0, 0.5F}, {1, -7}, {2, 3}};
    complete_appearance(mesh);
    const TextureTriangle expected{Eigen::Vector2f(2, 3), Eigen::Vector2f(0, 0.5F), Eigen::Vector2f(1, -7)};
    EXPECT_EQ(mesh.appearance.texture_coordinates, (std::vector<TextureTriangle>{expected}));
}

TEST(CompleteAppearance, PrefersTheTextureCoordinatesOfFaces) {
    RawMesh mesh = triangle({});
    mesh.appearance.vertex_texture_coordinates = {{0, 0.5F}, {1, -7}, {2, 3}};
    const TextureTriangle of_face{Eigen::Vector2f(2, 9), Eigen::Vector2f(0, 9), Eigen::Vector2f(1, 9)};
    mesh.appearance.texture_coordinates = {of_face};
    complete_appearance(mesh);
    EXPECT_EQ(mesh.appearance.texture_coordinates, (std::vector<TextureTriangle>{of_face}));
    EXPECT_EQ(mesh.notes.ignored, (Notes{"texture coordinates of vertices beside those of faces"}));
}

TEST(CompleteAppearance, HasNoTextureCoordinatesWhereNoCornerHasOne) {
    RawMesh mesh = triangle({});
    mesh.appearance.texture_coordinates = {{no_texture_coordinate(), no_texture_coordinate(), no_texture_coordinate()}};
    complete_appearance(mesh);
    EXPECT_TRUE(mesh.appearance.texture_coordinates.empty());
}

} // namespace
} // namespace foldless
