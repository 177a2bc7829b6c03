/// \file
/// Reads OFF as text. (Geomview manual, "OFF files")
#pragma once

#include <foldless/io/raw_mesh.h>

#include <string>
#include <string_view>

namespace foldless {

/// Headers OFF, COFF, NOFF, STOFF and their combinations; the counts stand on the line of the header or the next one.
/// Every vertex and face is a line of its own; what follows the coordinates or indices there is noted as ignored. For a
/// coloured scan colours and texture coordinates of vertices are read: normal, colour and texture coordinate follow the
/// position in this order, as far as the header names them; what it does not name may be a colour. Not read: binary
/// OFF, and points of dimensions other than three.
///
/// \throws UnreadableFile, with `name` as the file.
[[nodiscard]] RawMesh read_off(std::string_view text, const std::string& name, Content content);

} // namespace foldless
