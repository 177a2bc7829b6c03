/// \file
/// The command line.
#pragma once

#include <foldless/tools/command.h>

namespace foldless {

/// What the arguments of main() ask for.
/// \throws WrongUsage
[[nodiscard]] Command parse_command_line(int argc, const char* const* argv);

} // namespace foldless
