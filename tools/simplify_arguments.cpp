#include <foldless/tools/simplify_arguments.h>

#include <foldless/io/file_type.h>
#include <foldless/io/printable.h>
#include <foldless/tools/bake_arguments.h>
#include <foldless/tools/distinct_files.h>
#include <foldless/tools/option_values.h>
#include <foldless/tools/wrong_usage.h>

#include <fmt/format.h>

#include <vector>

namespace foldless {

namespace {

template <class Option>
void lay_over(Option& option, const char* name, const std::optional<std::string>& word) {
    if (word) {
        option = choice<Option>({name, *word});
    }
}

DecimateOptions decimate_options(const SimplifyArguments& arguments, Preset preset) {
    DecimateOptions options = preset == Preset::paper ? paper_options() : DecimateOptions{};
    lay_over(options.directions, "--directions", arguments.directions);
    lay_over(options.placement, "--placement", arguments.placement);
    lay_over(options.boundary, "--boundary", arguments.boundary);
    if (arguments.store_directions) {
        options.store_directions = yes_or_no({"--store-directions", *arguments.store_directions});
    }
    if (arguments.faces) {
        options.target_faces = face_count({"--faces", *arguments.faces});
    }
    if (arguments.threads) {
        options.threads = thread_count({"--threads", *arguments.threads});
    }
    if (arguments.time_limit) {
        options.time_limit = seconds({"--time-limit", *arguments.time_limit});
    }
    return options;
}

std::vector<NamedFile> outputs(const SimplifyCommand& command) {
    std::vector<NamedFile> files{{"--output", command.base}};
    if (command.correspondence) {
        files.emplace_back("--correspondence", *command.correspondence);
    }
    if (command.report) {
        files.emplace_back("--report", *command.report);
    }
    return files;
}

void require_writable_types(const SimplifyCommand& command) {
    const FileType type = file_type(command.base);
    if (type != FileType::ply && type != FileType::obj) {
        throw WrongUsage(fmt::format("--output must end in .ply or .obj: {}", printable(command.base)));
    }
    if (type == FileType::obj && command.options.directions == Directions::face) {
        throw WrongUsage("--directions face needs an --output that ends in .ply: OBJ has no room for them");
    }
    if (command.correspondence && file_type(*command.correspondence) != FileType::ply) {
        throw WrongUsage(fmt::format("--correspondence must end in .ply: {}", printable(*command.correspondence)));
    }
}

void name_files(SimplifyCommand& command, const SimplifyArguments& arguments) {
    command.scan = file_name({"SCAN", arguments.scan});
    command.base = file_name({"--output", arguments.base});
    if (arguments.report) {
        command.report = file_name({"--report", *arguments.report});
    }
    if (arguments.correspondence) {
        command.correspondence = file_name({"--correspondence", *arguments.correspondence});
    }
    require_writable_types(command);
    require_distinct_files(outputs(command), {{"the scan", command.scan}});
}

/// What is to be baked from the base mesh once it is written.
BakeCommand baking(const SimplifyCommand& command, const SimplifyArguments& arguments) {
    if (command.options.directions == Directions::face) {
        throw WrongUsage("--directions face and --bake contradict one another: displaced, the faces would not meet");
    }
    BakeArguments bake;
    bake.base = arguments.base;
    bake.scan = arguments.scan;
    bake.folder = *arguments.bake;
    bake.atlas = arguments.atlas;
    bake.threads = arguments.threads;
    bake.quiet = arguments.quiet;
    return bake_command(bake);
}

} // namespace

SimplifyCommand simplify_command(const SimplifyArguments& arguments) {
    SimplifyCommand command;
    lay_over(command.preset, "--preset", arguments.preset);
    command.options = decimate_options(arguments, command.preset);
    if (arguments.ratio && arguments.faces) {
        throw WrongUsage("--faces and --ratio contradict one another: give one of them");
    }
    if (arguments.ratio) {
        command.ratio = ratio({"--ratio", *arguments.ratio});
    }
    if (arguments.max_displacement) {
        command.max_displacement = length({"--max-displacement", *arguments.max_displacement});
    }
    command.verify = !arguments.no_verify;
    command.quiet = arguments.quiet;
    name_files(command, arguments);
    if (arguments.atlas && !arguments.bake) {
        throw WrongUsage("--atlas is the size of the maps that --bake writes: give both");
    }
    if (arguments.bake) {
        command.bake = baking(command, arguments);
    }
    return command;
}

} // namespace foldless
