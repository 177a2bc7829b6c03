/// \file
/// `foldless info`
#pragma once

#include <foldless/tools/command.h>
#include <foldless/tools/exit_code.h>

namespace foldless {

/// Prints what a mesh is to standard output.
/// \throws UnreadableFile, UnwritableFile
ExitCode run(const InfoCommand& command);

} // namespace foldless
