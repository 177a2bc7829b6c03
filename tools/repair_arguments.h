/// \file
/// The arguments of `foldless repair` as texts, and what they mean.
#pragma once

#include <foldless/tools/command.h>

#include <optional>
#include <string>

namespace foldless {

/// What stands on the command line, unchecked; an option that does not has no value.
struct RepairArguments {
    std::string scan;
    std::string output;
    std::optional<std::string> report;
    std::optional<std::string> min_component_faces;
    bool drop_unserved = false;
    bool quiet = false;
};

/// \throws WrongUsage for values out of range, file types that cannot be written, and files that would overwrite one
/// another or the scan.
[[nodiscard]] RepairCommand repair_command(const RepairArguments& arguments);

} // namespace foldless
