#include <foldless/io/complete_appearance.h>

#include <algorithm>
#include <cmath>

namespace foldless {

namespace {

constexpr float brightest_byte = 255.0F;

bool are_integers(const Eigen::Vector3f& colour) {
    return std::ranges::all_of(colour, [](float value) { return value == std::floor(value); });
}

float unit_of(const std::vector<Eigen::Vector3f>& colours) {
    const bool above_one =
        std::ranges::any_of(colours, [](const Eigen::Vector3f& colour) { return colour.maxCoeff() > 1.0F; });
    return above_one && std::ranges::all_of(colours, are_integers) ? brightest_byte : 1.0F;
}

/// One value per vertex, or none.
template <class Value>
void drop_unless_complete(std::vector<Value>& values, RawMesh& mesh, std::string_view note) {
    if (!values.empty() && values.size() != mesh.positions.size()) {
        values.clear();
        mesh.ignore(note);
    }
}

void complete_colours(RawMesh& mesh) {
    std::vector<Eigen::Vector3f>& colours = mesh.appearance.colours;
    drop_unless_complete(colours, mesh, "colours, which some vertices lack");
    const float unit = mesh.appearance.colour_unit.value_or(unit_of(colours));
    bool clamped = false;
    for (Eigen::Vector3f& colour : colours) {
        const Eigen::Vector3f scaled = colour / unit;
        colour = scaled.cwiseMax(0.0F).cwiseMin(1.0F);
        clamped = clamped || colour != scaled;
    }
    if (clamped) {
        mesh.ignore("colour values beyond 0 to 1");
    }
}

bool has_coordinate(const TextureTriangle& triangle) {
    return std::ranges::any_of(triangle, [](const Eigen::Vector2f& corner) { return corner.allFinite(); });
}

void spread_to_corners(RawMesh& mesh) {
    const std::vector<Eigen::Vector2f>& at = mesh.appearance.vertex_texture_coordinates;
    mesh.appearance.texture_coordinates.reserve(mesh.faces.size());
    for (const auto& [a, b, c] : mesh.faces) {
        mesh.appearance.texture_coordinates.push_back(
            {at[static_cast<std::size_t>(a)], at[static_cast<std::size_t>(b)], at[static_cast<std::size_t>(c)]});
    }
}

void complete_texture_coordinates(RawMesh& mesh) {
    RawAppearance& appearance = mesh.appearance;
    if (std::ranges::none_of(appearance.texture_coordinates, has_coordinate)) {
        appearance.texture_coordinates.clear();
    }
    drop_unless_complete(appearance.vertex_texture_coordinates, mesh, "texture coordinates, which some vertices lack");
    if (!appearance.vertex_texture_coordinates.empty()) {
        if (appearance.texture_coordinates.empty()) {
            spread_to_corners(mesh);
        } else {
            mesh.ignore("texture coordinates of vertices beside those of faces");
        }
    }
    appearance.vertex_texture_coordinates = {};
}

} // namespace

void complete_appearance(RawMesh& mesh) {
    complete_colours(mesh);
    complete_texture_coordinates(mesh);
}

} // namespace foldless
