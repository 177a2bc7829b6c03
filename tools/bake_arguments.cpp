#include <foldless/tools/bake_arguments.h>

#include <foldless/bake/fit_maps.h>
#include <foldless/bake/reconstruct.h>
#include <foldless/io/file_type.h>
#include <foldless/io/printable.h>
#include <foldless/tools/distinct_files.h>
#include <foldless/tools/option_values.h>
#include <foldless/tools/wrong_usage.h>

#include <fmt/format.h>

#include <sstream>

namespace foldless {

namespace {

/// The largest picture that is written: a gigabyte for each channel.
constexpr int largest_atlas = 16384;

/// Which maps a list such as `displacement,normal` asks for. The displacement is always baked.
void choose_maps(BakeCommand& command, const std::string& list) {
    command.vector = false;
    command.normal = false;
    command.color = false;
    std::istringstream words(list);
    for (std::string word; std::getline(words, word, ',');) {
        if (word == "vector") {
            command.vector = true;
        } else if (word == "normal") {
            command.normal = true;
        } else if (word == "color") {
            command.color = true;
        } else if (word != "displacement") {
            throw WrongUsage(fmt::format("--maps takes a list of displacement, vector, normal and color, not '{}'",
                                         printable(word)));
        }
    }
}

/// Of the files in the folder only the textured base mesh is of a kind that is read.
void keep_inputs(const BakeCommand& command) {
    std::vector<NamedFile> outputs{{"base.obj of the maps", command.folder / "base.obj"},
                                   {"maps.json of the maps", command.folder / "maps.json"}};
    if (command.report) {
        outputs.emplace_back("--report", *command.report);
    }
    require_distinct_files(outputs, {{"the base mesh", command.base}, {"the scan", command.scan}});
}

void name_files(ReconstructCommand& command, const ReconstructArguments& arguments) {
    command.base = file_name({"BASE", arguments.base});
    command.maps = file_name({"MAPS", arguments.maps});
    command.output = file_name({"--output", arguments.output});
    const FileType type = file_type(command.output);
    if (type != FileType::ply && type != FileType::obj) {
        throw WrongUsage(fmt::format("--output must end in .ply or .obj: {}", printable(command.output)));
    }
    std::vector<NamedFile> inputs{{"the base mesh", command.base}};
    std::vector<NamedFile> outputs{{"--output", command.output}};
    if (arguments.compare) {
        command.scan = file_name({"--compare", *arguments.compare});
        inputs.emplace_back("the scan", *command.scan);
    }
    if (arguments.report) {
        command.report = file_name({"--report", *arguments.report});
        outputs.emplace_back("--report", *command.report);
    }
    for (const char* map : {"maps.json", "displacement.exr", "mask.png", "base.obj"}) {
        inputs.emplace_back("a file in MAPS", command.maps / map);
    }
    require_distinct_files(outputs, inputs);
}

} // namespace

BakeCommand bake_command(const BakeArguments& arguments) {
    BakeCommand command;
    command.base = file_name({"BASE", arguments.base});
    command.scan = file_name({"SCAN", arguments.scan});
    command.folder = file_name({"--output", arguments.folder});
    if (arguments.report) {
        command.report = file_name({"--report", *arguments.report});
    }
    keep_inputs(command);
    if (arguments.max_error) {
        command.max_error = length({"--max-error", *arguments.max_error});
        command.atlas = FitOptions{}.largest;
    }
    if (arguments.atlas) {
        command.atlas = whole_number({"--atlas", *arguments.atlas}, {1, largest_atlas});
    }
    if (arguments.maps) {
        choose_maps(command, *arguments.maps);
    }
    if (arguments.method) {
        command.method = choice<BakeMethod>({"--method", *arguments.method});
    }
    if (arguments.threads) {
        command.threads = thread_count({"--threads", *arguments.threads});
    }
    command.quiet = arguments.quiet;
    return command;
}

ReconstructCommand reconstruct_command(const ReconstructArguments& arguments) {
    ReconstructCommand command;
    name_files(command, arguments);
    if (arguments.level) {
        command.level = whole_number({"--level", *arguments.level}, {0, ReconstructOptions::max_level});
    }
    if (arguments.threads) {
        command.threads = thread_count({"--threads", *arguments.threads});
    }
    command.quiet = arguments.quiet;
    return command;
}

} // namespace foldless
