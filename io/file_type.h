/// \file
/// The format of a file, by its extension.
#pragma once

#include <filesystem>
#include <string>

namespace foldless {

enum class FileType { ply, obj, off, stl, unknown };

/// The extension with its dot, `A` to `Z` in lower case.
[[nodiscard]] std::string lower_case_extension(const std::filesystem::path& path);

/// By extension, whatever its case.
[[nodiscard]] FileType file_type(const std::filesystem::path& path);

} // namespace foldless
