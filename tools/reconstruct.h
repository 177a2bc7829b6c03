/// \file
/// `foldless reconstruct`
#pragma once

#include <foldless/tools/command.h>
#include <foldless/tools/exit_code.h>

namespace foldless {

/// Writes the surface that a base mesh and its baked displacements give.
/// \throws UnreadableFile, RefusedMesh, UnwritableFile
ExitCode run(const ReconstructCommand& command);

} // namespace foldless
