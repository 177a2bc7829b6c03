/// \file
/// `foldless simplify`
#pragma once

#include <foldless/tools/command.h>
#include <foldless/tools/exit_code.h>

namespace foldless {

/// Decimates a scan, verifies the base mesh as it stands on the disk, and gives the outputs their names.
/// \throws UnreadableFile, RefusedMesh, UnwritableFile
ExitCode run(const SimplifyCommand& command);

} // namespace foldless
