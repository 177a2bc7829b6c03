/// \file
/// `foldless verify`, and the part of `foldless simplify` that verifies.
#pragma once

#include <foldless/tools/command.h>
#include <foldless/tools/console.h>
#include <foldless/tools/exit_code.h>

#include <foldless/verify/verify.h>

namespace foldless {

/// verify() with a progress bar.
/// \throws RefusedMesh
[[nodiscard]] VerifyResult verify_with_bar(const BaseMesh& base, const Scan& scan, int threads, const Console& console);

/// That `name` is not certified, each violation counted by name, and where the first ones are. None if it is.
[[nodiscard]] std::vector<std::string> violation_messages(std::string_view name, const VerifyResult& result);

/// Verifies a base mesh from the files alone.
/// \throws UnreadableFile, RefusedMesh, UnwritableFile
ExitCode run(const VerifyCommand& command);

} // namespace foldless
