/// \file
/// Writes binary little endian PLY.
#pragma once

#include <foldless/io/atomic_file.h>
#include <foldless/io/base_mesh.h>
#include <foldless/io/scan.h>

#include <string>
#include <vector>

namespace foldless {

/// Appends a base mesh whose arrays agree in length and whose values are exact (see stage_base_mesh).
/// \throws UnwritableFile
void write_ply(AtomicFile& file, const BaseMesh& base, const std::vector<std::string>& comments);

/// Appends a correspondence with one entry per scan vertex.
/// \throws UnwritableFile
void write_ply(AtomicFile& file, const Scan& scan, const Correspondence& correspondence);

} // namespace foldless
