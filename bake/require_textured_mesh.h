/// \file
/// What a textured mesh must be before it is written.
#pragma once

#include <foldless/bake/textured_mesh.h>

#include <filesystem>
#include <string_view>

namespace foldless {

/// Refuses to write `path`, with the reason.
/// \throws UnwritableFile
[[noreturn]] void refuse_to_write(const std::filesystem::path& path, std::string_view reason);

/// Checks that the arrays agree in length, each face names vertices that there are, and every number is finite.
/// O(vertices + faces).
/// \throws UnwritableFile
void require_textured_mesh(const std::filesystem::path& path, const TexturedMesh& mesh);

} // namespace foldless
