/// \file
/// Names and tokens of files, and counts, as they may stand in a message of one line.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace foldless {

/// The path with every control character replaced by `?`.
[[nodiscard]] std::string printable(const std::filesystem::path& path);

/// The token, cut to a few dozen characters, with every byte that is not printable ASCII replaced by `?`.
[[nodiscard]] std::string legible(std::string_view token);
/// The same in quotes.
[[nodiscard]] std::string in_quotes(std::string_view token);

/// "1 face" or "3 faces".
[[nodiscard]] std::string counted(std::size_t count, std::string_view one, std::string_view many);

} // namespace foldless
