// Any arguments: a command whose values are in range, or wrong usage in one line.

#include "reading.h"

#include <foldless/tools/command_line.h>
#include <foldless/tools/wrong_usage.h>

#include <cmath>
#include <string>
#include <variant>
#include <vector>

namespace foldless::fuzz {
namespace {

/// One argument a line. A NUL ends an argument, as it does for a program.
std::vector<std::string> arguments_of(std::string_view text) {
    std::vector<std::string> arguments{"foldless"};
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        arguments.emplace_back(std::string(text.substr(0, end)).c_str());
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return arguments;
}

bool is_thread_count(const std::optional<int>& threads) {
    return !threads || (*threads >= 1 && *threads <= 1024);
}

void require_in_range(const BakeCommand& command) {
    require(!command.base.empty() && !command.scan.empty() && !command.folder.empty(), "files and folder are named");
    require(command.atlas >= 1 && command.atlas <= 16384, "1 to 16384 texels on a side");
    require(!command.max_error || (std::isfinite(command.max_error->value) && command.max_error->value >= 0),
            "a bound on the error");
    require(is_thread_count(command.threads), "1 to 1024 threads");
}

void require_in_range(const SimplifyCommand& command) {
    const DecimateOptions& options = command.options;
    require(!command.scan.empty() && !command.base.empty(), "both files are named");
    require(!options.target_faces || *options.target_faces >= 1, "at least one face");
    require(!command.ratio || (*command.ratio > 0 && *command.ratio <= 1), "a ratio is above 0 and at most 1");
    require(!options.target_faces || !command.ratio, "one target at most");
    require(!options.time_limit || (std::isfinite(*options.time_limit) && *options.time_limit >= 0), "a time limit");
    require(!command.max_displacement ||
                (std::isfinite(command.max_displacement->value) && command.max_displacement->value >= 0),
            "a bound on displacements");
    require(is_thread_count(options.threads), "1 to 1024 threads");
    if (command.bake) {
        require_in_range(*command.bake);
    }
}

void require_in_range(const VerifyCommand& command) {
    require(!command.scan.empty() && !command.base.empty(), "both files are named");
    require(is_thread_count(command.threads), "1 to 1024 threads");
}

void require_in_range(const RepairCommand& command) {
    require(!command.scan.empty() && !command.output.empty(), "both files are named");
    require(command.options.min_component_faces >= 1, "a component has a face");
}

void require_in_range(const ReconstructCommand& command) {
    require(!command.base.empty() && !command.maps.empty() && !command.output.empty(), "files and folder are named");
    require(command.level >= 0 && command.level <= 12, "4^0 to 4^12 faces");
    require(is_thread_count(command.threads), "1 to 1024 threads");
}

void require_in_range(const InfoCommand& command) {
    require(!command.mesh.empty(), "a mesh is named");
}

void require_in_range(const PrintCommand& command) {
    require(command.text.ends_with('\n'), "help and version end their line");
}

} // namespace
} // namespace foldless::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace foldless;
    using namespace foldless::fuzz;
    const std::vector<std::string> arguments = arguments_of(text_of(data, size));
    std::vector<const char*> pointers;
    for (const std::string& argument : arguments) {
        pointers.push_back(argument.c_str());
    }
    try {
        std::visit([](const auto& command) { require_in_range(command); },
                   parse_command_line(static_cast<int>(pointers.size()), pointers.data()));
    } catch (const WrongUsage& error) {
        require_one_line(error.what());
    }
    return 0;
}
