/// \file
/// Reads PLY: ascii, binary little and big endian. (Turk 1994, The PLY polygon file format)
#pragma once

#include <foldless/io/raw_mesh.h>

#include <string>
#include <string_view>

namespace foldless {

/// Elements other than `vertex` and `face` and properties that are not asked for are read over and noted. In an ascii
/// file every vertex and face is a line of its own. Nothing but blank space may follow the last element, for a count
/// that is too small would lose faces unseen.
///
/// \throws UnreadableFile, with `name` as the file.
[[nodiscard]] RawMesh read_ply(std::string_view bytes, const std::string& name, Content content);

} // namespace foldless
