/// \file
/// Reads JPEG.
#pragma once

#include <foldless/images/image.h>
#include <foldless/io/errors.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace foldless {

/// Reads an image as Y or R G B, values scaled from 8 bits to [0, 1] and not converted otherwise. There are no
/// metadata; an orientation that a camera noted is not applied.
///
/// \throws UnreadableFile if the file cannot be read, is damaged, has inks instead of colours or more than 8 bits a
/// value, or is larger than image_size.h allows. Memory is bounded by a multiple of the size of the file: every block
/// of 64 pixels takes a bit of it or more.
[[nodiscard]] ReadImage read_jpeg(const std::filesystem::path& path);

/// The same from bytes in memory; `name` stands for them in messages.
[[nodiscard]] ReadImage read_jpeg(std::string_view bytes, const std::string& name);

} // namespace foldless
