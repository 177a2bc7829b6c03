/// \file
/// Reads an image: OpenEXR, PNG and JPEG by extension.
#pragma once

#include <foldless/images/image.h>
#include <foldless/io/errors.h>

#include <filesystem>

namespace foldless {

/// Reads `.exr`, `.png`, `.jpg` or `.jpeg`, whatever the case of the extension, as read_exr(), read_png() and
/// read_jpeg() do.
///
/// \throws UnreadableFile if the extension is another, or as these do.
[[nodiscard]] ReadImage read_image(const std::filesystem::path& path);

} // namespace foldless
