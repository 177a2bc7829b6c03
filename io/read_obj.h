/// \file
/// Reads OBJ. (Wavefront, Advanced Visualizer, appendix B1)
#pragma once

#include <foldless/io/raw_mesh.h>

#include <string>
#include <string_view>

namespace foldless {

/// Reads `v`, `vn` and `f`; other statements are noted. Indices count from 1, or from the last vertex if negative; a
/// face may name vertices that come later. For a scan, texture and normal indices are only checked to be integers. For
/// a coloured scan `vt`, `usemtl`, the names of `mtllib` and colours behind the coordinates are kept. For a base mesh
/// every corner of a vertex must name a normal of the same value.
///
/// \throws UnreadableFile, with `name` as the file.
[[nodiscard]] RawMesh read_obj(std::string_view text, const std::string& name, Content content);

} // namespace foldless
