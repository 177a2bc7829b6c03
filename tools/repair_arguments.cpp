#include <foldless/tools/repair_arguments.h>

#include <foldless/io/file_type.h>
#include <foldless/io/printable.h>
#include <foldless/tools/distinct_files.h>
#include <foldless/tools/option_values.h>
#include <foldless/tools/wrong_usage.h>

#include <fmt/format.h>

#include <vector>

namespace foldless {

namespace {

void name_files(RepairCommand& command, const RepairArguments& arguments) {
    command.scan = file_name({"SCAN", arguments.scan});
    command.output = file_name({"--output", arguments.output});
    std::vector<NamedFile> outputs{{"--output", command.output}};
    if (arguments.report) {
        command.report = file_name({"--report", *arguments.report});
        outputs.emplace_back("--report", *command.report);
    }
    const FileType type = file_type(command.output);
    if (type != FileType::ply && type != FileType::obj) {
        throw WrongUsage(fmt::format("--output must end in .ply or .obj: {}", printable(command.output)));
    }
    require_distinct_files(outputs, {{"the scan", command.scan}});
}

} // namespace

RepairCommand repair_command(const RepairArguments& arguments) {
    RepairCommand command;
    if (arguments.min_component_faces) {
        command.options.min_component_faces = face_count({"--min-component-faces", *arguments.min_component_faces});
    }
    command.options.drop_unserved = arguments.drop_unserved;
    command.quiet = arguments.quiet;
    name_files(command, arguments);
    return command;
}

} // namespace foldless
