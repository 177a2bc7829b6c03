/// \file
/// What is said of an image file that cannot be read.
#pragma once

#include <foldless/io/errors.h>

#include <string>
#include <string_view>

namespace foldless {

/// "NAME: not a readable FORMAT file: REASON", in one line whatever the reason, which may be of a library.
[[nodiscard]] UnreadableFile unreadable_image(const std::string& name, std::string_view format,
                                              std::string_view reason);

} // namespace foldless
