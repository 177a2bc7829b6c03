/// \file
/// Writes OBJ.
#pragma once

#include <foldless/io/atomic_file.h>
#include <foldless/io/base_mesh.h>

#include <string>
#include <vector>

namespace foldless {

/// Appends positions, directions and faces of a base mesh whose arrays agree in length. Each number is the shortest
/// decimal that reads back as the same double, and so as the same float.
/// \throws UnwritableFile
void write_obj(AtomicFile& file, const BaseMesh& base, const std::vector<std::string>& comments);

} // namespace foldless
