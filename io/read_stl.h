/// \file
/// Reads STL, ascii and binary.
#pragma once

#include <foldless/io/raw_mesh.h>

#include <string>
#include <string_view>

namespace foldless {

/// A file is binary if it has exactly the size that its count of triangles asks for, even if it starts with `solid`.
/// Corners at equal positions become one vertex. Normals are noted as ignored.
///
/// \throws UnreadableFile, with `name` as the file.
[[nodiscard]] RawMesh read_stl(std::string_view bytes, const std::string& name);

} // namespace foldless
