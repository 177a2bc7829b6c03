/// \file
/// Writes OpenEXR.
#pragma once

#include <foldless/images/image.h>
#include <foldless/io/atomic_file.h>

#include <filesystem>

namespace foldless {

/// Writes an image under a temporary name; the caller commits it. Every value is stored as it stands, as float32 in
/// scan lines that are compressed with ZIP; every entry of the metadata is an attribute of its name, `double` or
/// `string`. The bytes depend on the arguments alone. Besides the image, takes memory for what is written.
///
/// \throws std::invalid_argument if the image is not sound (see image.h), or a name of a channel or an entry is empty,
/// longer than 255 bytes, holds a null, or is an entry that OpenEXR itself writes.
/// \throws UnwritableFile
[[nodiscard]] AtomicFile stage_exr(const std::filesystem::path& path, const Image& image, const Metadata& metadata);

} // namespace foldless
