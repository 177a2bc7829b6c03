/// \file
/// Writes a textured base mesh as binary glTF 2.0.
#pragma once

#include <foldless/bake/textured_mesh.h>
#include <foldless/io/atomic_file.h>
#include <foldless/io/errors.h>

#include <filesystem>
#include <optional>
#include <string>

namespace foldless {

/// Pictures as the bytes of PNG files. They are embedded as they are and not looked at.
struct GlbPictures {
    std::optional<std::string> normal_png; ///< normals in the frame of TANGENT and NORMAL; green grows upwards
    std::optional<std::string> colour_png; ///< sRGB
};

/// What the file says about itself.
struct GlbNotes {
    std::string generator; ///< `asset.generator`, e.g. "foldless 0.1.0"
    /// A JSON object that becomes `extras.foldless` of the mesh, e.g. how the displacement map is scaled. Without nulls
    /// and empty lists, which are lost; integers beyond 32 bits become reals.
    std::optional<std::string> extras_json;
};

/// Writes the mesh under a temporary name. The caller commits the file.
///
/// The file has one mesh of one indexed primitive, a vertex being split where its texture coordinates differ, and
/// vertices without faces left out. All numbers are float32: double positions and texture coordinates are *rounded*, so
/// that the file is for rendering, and a proof about the base mesh holds for its other files.
/// * POSITION, with its bounds.
/// * NORMAL: the displacement direction at unit length; where it is zero, or there are none, that of the faces around.
/// * TANGENT, if there is a normal map: vertex_frames.h has the definition.
/// * TEXCOORD_0.
/// * _DISPLACEMENT_DIRECTION, if the base mesh has directions of vertices: as stored, at any length. A displaced point
///   is POSITION + t _DISPLACEMENT_DIRECTION, both interpolated and the latter not renormalised. Directions of faces
///   have no place in the file.
/// * One material, rough and not metallic, with the pictures as baseColorTexture and normalTexture.
///
/// Memory for twice the file, and a few times the mesh.
/// \throws UnwritableFile if the system refuses; if the arrays differ in length, an index is out of range, a number is
/// not finite as float32, there are no faces, `extras_json` is no JSON object, or the file would have more than 2 GiB.
[[nodiscard]] AtomicFile stage_glb(const std::filesystem::path& path, const TexturedMesh& mesh,
                                   const GlbPictures& pictures, const GlbNotes& notes);

} // namespace foldless
