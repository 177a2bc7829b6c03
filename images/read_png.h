/// \file
/// Reads PNG.
#pragma once

#include <foldless/images/image.h>
#include <foldless/io/errors.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace foldless {

/// Reads an image of any colour type, with 1 to 16 bits a value, interlaced or not. Values are scaled to [0, 1] and not
/// converted otherwise, whatever the file says of gamma. The channels are Y, Y A, R G B or R G B A; a palette becomes
/// its colours, a transparent colour becomes alpha. Texts are metadata, and numbers among them stay texts (see
/// number()); of several with one key the first counts.
///
/// \throws UnreadableFile if the file cannot be read, is damaged anywhere before its end, or is larger than
/// image_size.h allows. Memory is bounded by a multiple of the size of the file, that of its compression, and is taken
/// as rows arrive.
[[nodiscard]] ReadImage read_png(const std::filesystem::path& path);

/// The same from bytes in memory; `name` stands for them in messages.
[[nodiscard]] ReadImage read_png(std::string_view bytes, const std::string& name);

} // namespace foldless
