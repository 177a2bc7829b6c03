/// \file
/// Comments that stay on their line.
#pragma once

#include <string>

namespace foldless {

/// The comment with every line end replaced by a blank, so that it cannot become a statement of the file.
[[nodiscard]] std::string comment_line(std::string comment);

} // namespace foldless
