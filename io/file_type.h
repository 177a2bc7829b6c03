/// \file
/// The format of a file, by its extension.
#pragma once

#include <filesystem>

namespace foldless {

enum class FileType { ply, obj, off, stl, unknown };

/// By extension, whatever its case.
[[nodiscard]] FileType file_type(const std::filesystem::path& path);

} // namespace foldless
