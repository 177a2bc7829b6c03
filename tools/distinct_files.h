/// \file
/// Outputs must not overwrite inputs or one another.
#pragma once

#include <filesystem>
#include <utility>
#include <vector>

namespace foldless {

/// What the command line calls a file, and its path.
using NamedFile = std::pair<const char*, std::filesystem::path>;

/// A base mesh without its scan is of no use: it cannot be verified, and nothing can be baked from it.
/// \throws WrongUsage if an output is one of the inputs, under whatever name, or two outputs are one file
void require_distinct_files(const std::vector<NamedFile>& outputs, const std::vector<NamedFile>& inputs);

} // namespace foldless
