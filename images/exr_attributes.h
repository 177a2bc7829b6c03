/// \file
/// Attributes of an OpenEXR header that are the file's own, and not metadata.
#pragma once

#include <string_view>

namespace foldless {

/// Whether OpenEXR gives this name a meaning that readers rely on.
[[nodiscard]] bool is_reserved_attribute(std::string_view name);

/// Names of attributes and channels have as many bytes at most.
constexpr std::size_t longest_exr_name = 255;

} // namespace foldless
