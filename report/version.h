/// \file
/// The version of foldless.
#pragma once

#include <string_view>

namespace foldless {

/// "0.1.0", as in the report, in the header of a base mesh and in `foldless --version`.
[[nodiscard]] std::string_view version();

} // namespace foldless
