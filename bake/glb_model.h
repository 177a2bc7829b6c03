/// \file
/// From a textured mesh to the tree of objects and the bytes that a glTF file holds.
#pragma once

#include <foldless/bake/textured_mesh.h>
#include <foldless/bake/write_glb.h>

#include <tiny_gltf.h>

namespace foldless {

/// One scene, one node, one mesh of one primitive, one buffer that holds everything. The caller adds what is said about
/// the file. Every number of the mesh must be finite as float32.
[[nodiscard]] tinygltf::Model glb_model(const TexturedMesh& mesh, const GlbPictures& pictures);

} // namespace foldless
