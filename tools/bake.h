/// \file
/// `foldless bake`
#pragma once

#include <foldless/tools/command.h>
#include <foldless/tools/exit_code.h>

namespace foldless {

/// Finds out early what would stop run() later.
/// \throws UnwritableFile
void require_writable_outputs(const BakeCommand& command);

/// Verifies a base mesh, and if it is certified bakes its maps into a folder, which is made if it is not there.
/// \throws UnreadableFile, RefusedMesh, UnwritableFile, WrongUsage if the atlas is too small
ExitCode run(const BakeCommand& command);

} // namespace foldless
