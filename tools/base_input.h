/// \file
/// The base mesh that a command works on.
#pragma once

#include <foldless/io/base_mesh.h>
#include <foldless/tools/console.h>

#include <filesystem>

namespace foldless {

/// Reads a base mesh and says what was ignored of it.
/// \throws UnreadableFile, RefusedMesh
[[nodiscard]] BaseMesh read_base(const std::filesystem::path& path, const Console& console);

/// The same for commands that displace its surface: constant face directions would leave gaps.
/// \throws UnreadableFile, RefusedMesh
[[nodiscard]] BaseMesh read_base_with_vertex_directions(const std::filesystem::path& path, const Console& console);

} // namespace foldless
