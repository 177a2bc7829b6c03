/// \file
/// `foldless repair`
#pragma once

#include <foldless/tools/command.h>
#include <foldless/tools/exit_code.h>

namespace foldless {

/// Reads a scan, repairs it, and writes what comes out of it.
/// \throws UnreadableFile, RefusedMesh, UnwritableFile
ExitCode run(const RepairCommand& command);

} // namespace foldless
