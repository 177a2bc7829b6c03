/// \file
/// An independent judge of repaired meshes.
#pragma once

#include <foldless/io/scan.h>

#include <string>

namespace foldless::test {

/// What keeps a mesh from being an oriented manifold of different triangles with an area whose vertices are all in use;
/// empty if nothing does. From the definitions, without any of the tables of the library, and slow. Areas are those of
/// doubles: exact for small whole coordinates.
[[nodiscard]] std::string flaw_of(const Scan& scan);

} // namespace foldless::test
