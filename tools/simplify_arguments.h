/// \file
/// The arguments of `foldless simplify` as texts, and what they mean.
#pragma once

#include <foldless/tools/command.h>

#include <optional>
#include <string>

namespace foldless {

/// What stands on the command line, unchecked; an option that does not has no value.
struct SimplifyArguments {
    std::string scan;
    std::string base;
    std::optional<std::string> preset;
    std::optional<std::string> faces;
    std::optional<std::string> ratio;
    std::optional<std::string> directions;
    std::optional<std::string> store_directions;
    std::optional<std::string> placement;
    std::optional<std::string> boundary;
    std::optional<std::string> max_displacement;
    std::optional<std::string> threads;
    std::optional<std::string> time_limit;
    std::optional<std::string> report;
    std::optional<std::string> correspondence;
    std::optional<std::string> bake;
    std::optional<std::string> atlas;
    bool no_verify = false;
    bool quiet = false;
};

/// The preset with the options that were given laid over it.
/// \throws WrongUsage for values out of range, options that contradict one another, file types that cannot be written,
/// and files that would overwrite one another or the scan.
[[nodiscard]] SimplifyCommand simplify_command(const SimplifyArguments& arguments);

} // namespace foldless
