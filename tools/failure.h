/// \file
/// Exceptions as messages and exit codes.
#pragma once

#include <foldless/tools/exit_code.h>

namespace foldless {

/// Prints one line about the exception that is being handled and returns its exit code. Call it in a catch clause.
[[nodiscard]] ExitCode describe_failure() noexcept;

/// An exception that nobody can catch ends the program in the same way, without a core. So does memory that runs out,
/// at once and without an exception: CGAL's Mpzf cannot be destroyed after one that it throws for that.
void handle_termination();

} // namespace foldless
