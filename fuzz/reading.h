/// \file
/// What must hold of every reader, whatever the bytes.
#pragma once

#include "require.h"

#include <foldless/io/complete_appearance.h>
#include <foldless/io/defects.h>
#include <foldless/io/errors.h>
#include <foldless/io/raw_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace foldless::fuzz {

/// The input as a reader takes it. libFuzzer hands out exactly as many bytes as there are, so that the address
/// sanitizer sees what is read behind them.
inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// A message is one line of printable characters.
inline void require_one_line(std::string_view message) {
    require(!message.empty(), "a failure has a message");
    const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
    require(std::ranges::none_of(message, is_control), "a message is one line: " + std::string(message));
}

/// The arrays of a mesh are as long as they say, and all indices are in range; inspecting it never fails.
inline void require_sound(const RawMesh& mesh) {
    const auto fits = [](std::size_t size, std::size_t count) { return size == 0 || size == count; };
    require(fits(mesh.normals.size(), mesh.positions.size()), "a normal for each vertex, or none");
    require(fits(mesh.scan_vertex.size(), mesh.positions.size()), "a scan vertex for each vertex, or none");
    require(fits(mesh.ranges.size(), mesh.faces.size()), "a range for each face, or none");
    require(fits(mesh.face_normals.size(), mesh.faces.size()), "a normal for each face, or none");
    const Scan scan{mesh.positions, mesh.faces, false};
    require(inspect(scan).defects.index_out_of_range == 0, "indices are in range");
    for (const PolygonFan& fan : mesh.fans) {
        require(fan.corners > 3 && fan.first_face + fan.corners - 2 <= mesh.faces.size(), "a fan is made of faces");
    }
    if (const std::string refused = refused_polygons_text(mesh); !refused.empty()) {
        require_one_line(refused);
    }
}

/// There is a value for each vertex or face, or none; colours are in range and materials are known.
inline void require_sound_appearance(const RawMesh& mesh) {
    const RawAppearance& appearance = mesh.appearance;
    const auto fits = [](std::size_t size, std::size_t count) { return size == 0 || size == count; };
    require(fits(appearance.colours.size(), mesh.positions.size()), "a colour for each vertex, or none");
    require(fits(appearance.texture_coordinates.size(), mesh.faces.size()),
            "a texture triangle for each face, or none");
    require(fits(appearance.material_of_face.size(), mesh.faces.size()), "a material for each face, or none");
    for (const Eigen::Vector3f& colour : appearance.colours) {
        require(colour.minCoeff() >= 0.0F && colour.maxCoeff() <= 1.0F, "a colour is in [0, 1]"); // false for NaN
    }
    for (const TextureTriangle& triangle : appearance.texture_coordinates) {
        for (const Eigen::Vector2f& corner : triangle) {
            require(corner.allFinite() || corner.hasNaN(), "a texture coordinate is finite or missing");
        }
    }
    for (const std::int32_t material : appearance.material_of_face) {
        require(material >= -1 && material < static_cast<std::int64_t>(appearance.materials.size()),
                "a material is known, or none");
    }
}

/// Reads; what comes out is sound, or the bytes are refused in one line.
template <class Read>
void require_read_or_refused(const Read& read) {
    try {
        RawMesh mesh = read();
        require_sound(mesh);
        complete_appearance(mesh);
        require_sound_appearance(mesh);
    } catch (const UnreadableFile& error) {
        require_one_line(error.what());
    }
}

} // namespace foldless::fuzz
