/// \file
/// The options of `foldless bake` and `foldless reconstruct` as they are spelled.
#pragma once

#include <foldless/bake/atlas_maps.h>
#include <foldless/report/option_names.h>
#include <foldless/tools/command.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace foldless {

template <>
struct OptionNames<BakeMethod> {
    static constexpr std::array<std::string_view, 2> words{"inverse", "direct"};
};

struct BakeArguments {
    std::string base;
    std::string scan;
    std::string folder;
    std::optional<std::string> atlas;
    std::optional<std::string> max_error;
    std::optional<std::string> maps;
    std::optional<std::string> method;
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
