/// \file
/// Colours and texture coordinates as they come out of a reader.
#pragma once

#include <foldless/io/scan_appearance.h>

#include <Eigen/Core>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace foldless {

/// What faces are made of: a texture of PLY, or a material of OBJ.
struct RawMaterial {
    std::string name;    ///< of OBJ
    std::string picture; ///< as the file names it, "" if it names none; for OBJ the material library does
};

/// What a reader finds when it is asked for a coloured scan. Values are finite, but NaN for a corner without a texture
/// coordinate; indices are in range.
struct RawAppearance {
    std::vector<Eigen::Vector3f> colours; ///< in the units of the file; of vertices, perhaps not of all, see below
    std::optional<float> colour_unit;     ///< the brightest value if it is declared
    std::vector<Eigen::Vector2f> vertex_texture_coordinates; ///< as colours
    std::vector<TextureTriangle> texture_coordinates;        ///< one per face, or empty
    std::vector<RawMaterial> materials;
    std::vector<std::int32_t> material_of_face;  ///< index into materials, or -1; one per face, or empty
    std::vector<std::string> material_libraries; ///< as the file names them, one or more in a name
};

/// The texture coordinate of a corner that has none.
[[nodiscard]] inline Eigen::Vector2f no_texture_coordinate() {
    return Eigen::Vector2f::Constant(std::numeric_limits<float>::quiet_NaN());
}

} // namespace foldless
