/// \file
/// Writing a model of any size in constant memory.
#pragma once

#include <foldless/io/errors.h>
#include <foldless/models/model.h>

#include <filesystem>
#include <string>
#include <vector>

namespace foldless {

/// Writes binary little endian PLY, float or double as the model is, as an AtomicFile. `comments` go into the header,
/// one line each. Time O(faces), memory O(1).
///
/// \throws UnwritableFile, leaving an existing file of that name untouched and no temporary file behind.
void stream_ply(const std::filesystem::path& path, const Model& model, const std::vector<std::string>& comments);

} // namespace foldless
