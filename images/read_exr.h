/// \file
/// Reads OpenEXR.
#pragma once

#include <foldless/images/image.h>
#include <foldless/io/errors.h>

#include <filesystem>

namespace foldless {

/// Reads the image of a file of one part, in scan lines or tiles (of these the largest level). Half and integer values
/// become float; integers above 2^24 are rounded. The image is the data window, wherever it lies. Channels in layers,
/// whose names have a dot, are left out; the others come in the order R, G, B, Y, A and then by name. Attributes that
/// are strings or single numbers are metadata.
///
/// \throws UnreadableFile if the file cannot be read, is deep, has several parts or subsampled channels, lacks pixels,
/// or is larger than image_size.h allows. Memory is bounded by a multiple of the size of the file, that of its
/// compression; what the header claims beyond that is refused before memory is taken for it.
[[nodiscard]] ReadImage read_exr(const std::filesystem::path& path);

} // namespace foldless
