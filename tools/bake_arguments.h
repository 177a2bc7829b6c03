/// \file
/// The options of `foldless bake` and `foldless reconstruct` as they are spelled.
#pragma once

#include <foldless/tools/command.h>

#include <optional>
#include <string>

namespace foldless {

struct BakeArguments {
    std::string base;
    std::string scan;
    std::string folder;
    std::optional<std::string> atlas;
    std::optional<std::string> maps;
    std::optional<std::string> report;
    std::optional<std::string> threads;
    bool quiet = false;
};

struct ReconstructArguments {
    std::string base;
    std::string maps;
    std::string output;
    std::optional<std::string> level;
    std::optional<std::string> compare;
    std::optional<std::string> report;
    std::optional<std::string> threads;
    bool quiet = false;
};

/// \throws WrongUsage
[[nodiscard]] BakeCommand bake_command(const BakeArguments& arguments);

/// \throws WrongUsage
[[nodiscard]] ReconstructCommand reconstruct_command(const ReconstructArguments& arguments);

} // namespace foldless
