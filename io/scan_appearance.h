/// \file
/// A scan with its colours and texture coordinates.
#pragma once

#include <foldless/io/read_mesh.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace foldless {

/// The places in a picture of the three corners of a face, in the order of its vertices; NaN for a corner without one.
/// u runs to the right and v up, as in the file; a picture covers 0 to 1, and what lies beyond repeats it.
using TextureTriangle = std::array<Eigen::Vector2f, 3>;

/// What a scan looks like, as far as its file says. Colours are sRGB as a rule; nothing is converted.
struct ScanAppearance {
    std::vector<Eigen::Vector3f> vertex_colours;      ///< red, green, blue in [0, 1]; one per vertex, or empty
    std::vector<TextureTriangle> texture_coordinates; ///< one per face, or empty
    std::vector<std::filesystem::path> textures;      ///< pictures, which need not exist
    std::vector<std::int32_t> texture_of_face;        ///< index into textures, or -1; one per face, or empty
};

struct ReadColouredScan {
    Scan scan; ///< as read_scan() returns it
    ScanAppearance appearance;
    ReadNotes notes; ///< what is ignored even so
};

/// Reads a scan and its appearance: PLY with colours per vertex and with texture coordinates per vertex or face; OBJ
/// with colours behind the coordinates, `vt`, and the `map_Kd` of its materials; OFF with colours and texture
/// coordinates per vertex. STL has none. docs/formats.md says which numbers mean which colours, and where pictures are
/// looked for. A material library that cannot be read is noted.
///
/// \throws UnreadableFile as read_scan(), and if a colour or a texture coordinate is not a finite number, or if a face
/// names a texture that the file does not have.
/// \throws RefusedMesh as read_scan().
/// Memory is bounded by a multiple of the size of the file and its material libraries. Time as read_scan().
[[nodiscard]] ReadColouredScan read_coloured_scan(const std::filesystem::path& path);

} // namespace foldless
