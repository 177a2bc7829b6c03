/// \file
/// What a command line asks for.
#pragma once

#include <foldless/bake/atlas_maps.h>
#include <foldless/decimate/decimate.h>
#include <foldless/repair/repair.h>
#include <foldless/report/run_record.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>

namespace foldless {

/// A length in model units or as a share of the diagonal of the scan's bounding box.
struct Length {
    double value;
    bool relative; ///< value is a share of the diagonal, 0.01 for `1%`
};

/// `foldless bake`
struct BakeCommand {
    std::filesystem::path base;
    std::filesystem::path scan;
    std::filesystem::path folder;
    int atlas = 2048;                ///< texels on a side
    std::optional<Length> max_error; ///< then `atlas` is the largest size to try
    BakeMethod method = BakeMethod::inverse;
    bool vector = true;
    bool normal = true;
    bool color = true; ///< if the scan has colours
    std::optional<std::filesystem::path> report;
    std::optional<int> threads;
    bool quiet = false;
};

/// `foldless simplify`
struct SimplifyCommand {
    std::filesystem::path scan;
    std::filesystem::path base;
    std::optional<std::filesystem::path> report;
    std::optional<std::filesystem::path> correspondence;
    Preset preset = Preset::standard;
    DecimateOptions options; ///< without what depends on the scan, which follows
    std::optional<double> ratio;
    std::optional<Length> max_displacement;
    bool verify = true;
    std::optional<BakeCommand> bake; ///< afterwards
    bool quiet = false;
};

/// `foldless verify`
struct VerifyCommand {
    std::filesystem::path base;
    std::filesystem::path scan;
    std::optional<std::filesystem::path> report;
    std::optional<std::filesystem::path> violations;
    std::optional<int> threads;
    bool quiet = false;
};

/// `foldless repair`
struct RepairCommand {
    std::filesystem::path scan;
    std::filesystem::path output;
    std::optional<std::filesystem::path> report;
    RepairOptions options;
    bool quiet = false;
};

/// `foldless reconstruct`
struct ReconstructCommand {
    std::filesystem::path base;
    std::filesystem::path maps; ///< the folder
    std::filesystem::path output;
    int level = 5;                             ///< each base face becomes 4^level
    std::optional<std::filesystem::path> scan; ///< to compare with
    std::optional<std::filesystem::path> report;
    std::optional<int> threads;
    bool quiet = false;
};

/// `foldless info`
struct InfoCommand {
    std::filesystem::path mesh;
    bool json = false;
};

/// `--help` and `--version`
struct PrintCommand {
    std::string text;
};

using Command = std::variant<SimplifyCommand, VerifyCommand, RepairCommand, BakeCommand, ReconstructCommand,
                             InfoCommand, PrintCommand>;

} // namespace foldless
