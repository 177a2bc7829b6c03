/// \file
/// Any file into a raw mesh, by the reader for its extension.
#pragma once

#include <foldless/io/raw_mesh.h>

#include <filesystem>

namespace foldless {

/// \throws UnreadableFile if the file cannot be read.
/// \throws RefusedMesh for polygons that cannot be fanned.
[[nodiscard]] RawMesh read_raw(const std::filesystem::path& path, Content content);

/// The positions and faces of the mesh, which loses them.
[[nodiscard]] Scan take_scan(RawMesh& mesh);

} // namespace foldless
