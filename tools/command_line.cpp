#include <foldless/tools/command_line.h>

#include <foldless/io/file_type.h>
#include <foldless/io/printable.h>
#include <foldless/report/option_names.h>
#include <foldless/report/version.h>
#include <foldless/tools/bake_arguments.h>
#include <foldless/tools/distinct_files.h>
#include <foldless/tools/option_values.h>
#include <foldless/tools/repair_arguments.h>
#include <foldless/tools/simplify_arguments.h>
#include <foldless/tools/wrong_usage.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

namespace foldless {

namespace {

constexpr const char* exit_codes = "exit codes:\n"
                                   "  0  done; verify: certified\n"
                                   "  1  internal error\n"
                                   "  2  wrong usage\n"
                                   "  3  input cannot be read\n"
                                   "  4  input refused: its defects are counted by name\n"
                                   "  5  output cannot be written\n"
                                   "  6  not certified: the violations are counted by name\n"
                                   "  7  out of memory\n"
                                   "  128 + n  ended by signal n";

// Where the descriptions of options start.
constexpr std::size_t help_column = 38;

struct VerifyArguments {
    std::string base;
    std::string scan;
    std::optional<std::string> report;
    std::optional<std::string> violations;
    std::optional<std::string> threads;
    bool quiet = false;
};

struct InfoArguments {
    std::string mesh;
    bool json = false;
};

/// The words that an option takes, for its help.
template <class Option>
std::string words() {
    return fmt::format("{}", fmt::join(OptionNames<Option>::words, "|"));
}

/// CLI11 would read --quiet=2x as a number, and --quiet=false as its contrary.
void declare_flag(CLI::App& app, const char* name, bool& value, const char* description) {
    app.add_flag(name, value, description)->disable_flag_override();
}

void declare_files(CLI::App& app, SimplifyArguments& arguments) {
    app.add_option("SCAN", arguments.scan, "the scan: .ply, .obj, .off or .stl")->required();
    app.add_option("-o,--output", arguments.base, "the base mesh to write: .ply, or .obj without ranges")
        ->required()
        ->type_name("BASE");
    app.add_option("--report", arguments.report, "write a report")->type_name("FILE.json");
    app.add_option("--correspondence", arguments.correspondence, "write where each scan vertex lies on the base mesh")
        ->type_name("FILE.ply");
    app.add_option("--bake", arguments.bake, "bake the maps of the base mesh into a folder, too")->type_name("DIR");
    app.add_option("--atlas", arguments.atlas, "texels on a side of the maps of --bake, 2048 by default")
        ->type_name("N");
}

void declare_stops(CLI::App& app, SimplifyArguments& arguments) {
    app.add_option("--faces", arguments.faces, "stop at the first state with at most N faces")->type_name("N");
    app.add_option("--ratio", arguments.ratio, "the same as a share of the scan's faces, above 0 and at most 1")
        ->type_name("R");
    app.add_option("--time-limit", arguments.time_limit,
                   "end the decimation so many seconds after the start, with what is reached")
        ->type_name("SECONDS");
    app.add_option("--max-displacement", arguments.max_displacement,
                   "bound on displacements: model units, or e.g. 1% of the diagonal")
        ->type_name("D");
}

void declare_methods(CLI::App& app, SimplifyArguments& arguments) {
    app.add_option("--preset", arguments.preset, "a set of options; those that are given are laid over it")
        ->type_name(words<Preset>());
    app.add_option("--directions", arguments.directions, "how displacement directions are chosen")
        ->type_name(words<Directions>());
    app.add_option("--store-directions", arguments.store_directions,
                   "no: recomputed over the one-ring after each collapse")
        ->type_name("yes|no");
    app.add_option("--placement", arguments.placement, "where the vertex of a collapsed edge goes")
        ->type_name(words<Placement>());
    app.add_option("--boundary", arguments.boundary, "lock: the border stays; trim: the base mesh may reach beyond it")
        ->type_name(words<Boundary>());
}

void declare_simplify(CLI::App& app, SimplifyArguments& arguments) {
    declare_files(app, arguments);
    declare_stops(app, arguments);
    declare_methods(app, arguments);
    app.add_option("--threads", arguments.threads, "default: all cores; the result does not depend on it")
        ->type_name("N");
    declare_flag(app, "--no-verify", arguments.no_verify, "do not verify the result before it gets its name");
    declare_flag(app, "--quiet", arguments.quiet, "print errors and targets that were not reached only");
}

void declare_verify(CLI::App& app, VerifyArguments& arguments) {
    app.add_option("BASE", arguments.base, "the base mesh: .ply or .obj")->required();
    app.add_option("SCAN", arguments.scan, "the scan: .ply, .obj, .off or .stl")->required();
    app.add_option("--report", arguments.report, "write a report")->type_name("FILE.json");
    app.add_option("--violations", arguments.violations, "write the located violations as a mesh to look at")
        ->type_name("FILE.ply");
    app.add_option("--threads", arguments.threads, "default: all cores")->type_name("N");
    declare_flag(app, "--quiet", arguments.quiet, "print violations and errors only");
}

void declare_repair(CLI::App& app, RepairArguments& arguments) {
    app.add_option("SCAN", arguments.scan, "the scan: .ply, .obj, .off or .stl")->required();
    app.add_option("-o,--output", arguments.output, "the repaired scan to write: .ply or .obj")
        ->required()
        ->type_name("OUT");
    app.add_option("--min-component-faces", arguments.min_component_faces, "drop components of fewer than N faces")
        ->type_name("N");
    app.add_flag("--drop-unserved", arguments.drop_unserved,
                 "drop the faces around vertices whose faces no displacement direction sees all");
    app.add_option("--report", arguments.report, "write a report")->type_name("FILE.json");
    app.add_flag("--quiet", arguments.quiet, "print errors only");
}

void declare_bake(CLI::App& app, BakeArguments& arguments) {
    app.add_option("BASE", arguments.base, "a base mesh that represents the scan: .ply or .obj")->required();
    app.add_option("SCAN", arguments.scan, "the scan: .ply, .obj, .off or .stl")->required();
    app.add_option("-o,--output", arguments.folder, "the folder to write the maps into")->required()->type_name("DIR");
    app.add_option("--atlas", arguments.atlas, "texels on a side of the maps, 2048 by default")->type_name("N");
    app.add_option("--max-error", arguments.max_error,
                   "take the smallest maps that give the scan back within so much: model units, or e.g. 0.1% of the "
                   "diagonal; --atlas is the largest size to try then, 8192 by default")
        ->type_name("D");
    app.add_option("--maps", arguments.maps, "some of displacement,vector,normal,color; all by default")
        ->type_name("LIST");
    app.add_option("--method", arguments.method,
                   "scan faces are drawn into the maps, or a ray is cast from each sample")
        ->type_name(words<BakeMethod>());
    app.add_option("--report", arguments.report, "write a report")->type_name("FILE.json");
    app.add_option("--threads", arguments.threads, "default: all cores; the result does not depend on it")
        ->type_name("N");
    declare_flag(app, "--quiet", arguments.quiet, "print violations and errors only");
}

void declare_reconstruct(CLI::App& app, ReconstructArguments& arguments) {
    app.add_option("BASE", arguments.base, "the base mesh: .ply or .obj")->required();
    app.add_option("MAPS", arguments.maps, "the folder that foldless bake wrote")->required();
    app.add_option("-o,--output", arguments.output, "the surface to write: .ply or .obj")->required()->type_name("OUT");
    app.add_option("--level", arguments.level, "each face becomes 4^N faces, 5 by default")->type_name("N");
    app.add_option("--compare", arguments.compare, "measure how far the surface and the scan are from each other")
        ->type_name("SCAN");
    app.add_option("--report", arguments.report, "write a report")->type_name("FILE.json");
    app.add_option("--threads", arguments.threads, "default: all cores; the result does not depend on it")
        ->type_name("N");
    declare_flag(app, "--quiet", arguments.quiet, "print errors only");
}

void declare_info(CLI::App& app, InfoArguments& arguments) {
    app.add_option("MESH", arguments.mesh, "a scan or a base mesh")->required();
    declare_flag(app, "--json", arguments.json, "print a report for other programs");
}

void name_files(VerifyCommand& command, const VerifyArguments& arguments) {
    command.base = file_name({"BASE", arguments.base});
    command.scan = file_name({"SCAN", arguments.scan});
    std::vector<NamedFile> outputs;
    if (arguments.report) {
        command.report = file_name({"--report", *arguments.report});
        outputs.emplace_back("--report", *command.report);
    }
    if (arguments.violations) {
        command.violations = file_name({"--violations", *arguments.violations});
        outputs.emplace_back("--violations", *command.violations);
        if (file_type(*command.violations) != FileType::ply) {
            throw WrongUsage(fmt::format("--violations must end in .ply: {}", printable(*command.violations)));
        }
    }
    require_distinct_files(outputs, {{"the base mesh", command.base}, {"the scan", command.scan}});
}

VerifyCommand verify_command(const VerifyArguments& arguments) {
    VerifyCommand command;
    name_files(command, arguments);
    if (arguments.threads) {
        command.threads = thread_count({"--threads", *arguments.threads});
    }
    command.quiet = arguments.quiet;
    return command;
}

/// The command line with the places that it is parsed into. CLI11 keeps their addresses.
class Parser {
public:
    Parser();
    Command parse(int argc, const char* const* argv);

private:
    CLI::App* add_command(const char* name, const char* description);
    [[nodiscard]] std::string usage_error(const CLI::ParseError& error) const;
    void require_values() const;

    CLI::App app_{"Decimates 3D scans into base meshes that a scalar displacement map turns back into the scan, "
                  "and proves that nothing folds.",
                  "foldless"};
    SimplifyArguments simplify_;
    VerifyArguments verify_;
    RepairArguments repair_;
    BakeArguments bake_;
    ReconstructArguments reconstruct_;
    InfoArguments info_;
    CLI::App* simplify_app_;
    CLI::App* verify_app_;
    CLI::App* repair_app_;
    CLI::App* bake_app_;
    CLI::App* reconstruct_app_;
    CLI::App* info_app_;
};

Parser::Parser()
    : simplify_app_(add_command("simplify", "decimate a scan into a displacement-mappable base mesh")),
      verify_app_(add_command("verify", "re-prove, from the files alone, that BASE represents SCAN")),
      repair_app_(add_command("repair", "write a scan without the defects for which simplify refuses it")),
      bake_app_(add_command("bake", "bake the displacement of a base mesh and other maps of the scan into pictures")),
      reconstruct_app_(add_command("reconstruct", "give the scan back from a base mesh and its baked displacement")),
      info_app_(add_command("info", "counts, topology, defects, and what simplify would say of a mesh")) {
    app_.set_version_flag("--version", fmt::format("foldless {}", version()), "print the version and exit");
    app_.set_help_flag("-h,--help", "print this help and exit");
    app_.require_subcommand(0, 1);
    app_.footer(exit_codes);
    declare_simplify(*simplify_app_, simplify_);
    declare_verify(*verify_app_, verify_);
    declare_repair(*repair_app_, repair_);
    declare_bake(*bake_app_, bake_);
    declare_reconstruct(*reconstruct_app_, reconstruct_);
    declare_info(*info_app_, info_);
}

CLI::App* Parser::add_command(const char* name, const char* description) {
    CLI::App* command = app_.add_subcommand(name, description);
    command->get_formatter()->column_width(help_column);
    command->set_version_flag("--version", fmt::format("foldless {}", version()), "print the version and exit");
    command->set_help_flag("-h,--help", "print this help and exit");
    return command;
}

/// CLI11's message, in our words where its own are hard to read.
std::string message_of(const CLI::ParseError& error, const CLI::App* command) {
    std::string text = error.what();
    if (error.get_name() != "ArgumentMismatch" || command == nullptr) {
        return text;
    }
    constexpr std::string_view overridden = " was given a disallowed flag override";
    if (text.ends_with(overridden)) {
        return "--" + text.substr(0, text.size() - overridden.size()) + " takes no value";
    }
    const std::string option = text.substr(0, text.find(':'));
    const bool repeated = command->count(option) > 1;
    return option + (repeated ? " is given more than once" : " needs a value");
}

/// One line, with the place where the right usage stands.
std::string Parser::usage_error(const CLI::ParseError& error) const {
    const auto commands = app_.get_subcommands();
    const CLI::App* command = commands.empty() ? nullptr : commands.front();
    const std::string text = printable(message_of(error, command));
    return fmt::format("{} (see foldless {}--help)", text, command == nullptr ? "" : command->get_name() + " ");
}

/// In `--report --quiet` the name of the report was forgotten; a file that is called so can be given as ./--quiet.
void require_values_of(const CLI::Option& option, const CLI::App& command) {
    for (const std::string& value : option.results()) {
        if (value.starts_with('-') && command.get_option_no_throw(value) != nullptr) {
            throw WrongUsage(fmt::format("{} needs a value, not the option {}", option.get_name(), value));
        }
    }
}

void Parser::require_values() const {
    for (const CLI::App* command : app_.get_subcommands()) {
        for (const CLI::Option* option : command->get_options()) {
            if (!option->get_positional()) {
                require_values_of(*option, *command);
            }
        }
    }
}

Command Parser::parse(int argc, const char* const* argv) {
    try {
        app_.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        return PrintCommand{app_.help()};
    } catch (const CLI::CallForVersion& call) {
        return PrintCommand{std::string(call.what()) + '\n'};
    } catch (const CLI::ParseError& error) {
        throw WrongUsage(usage_error(error));
    }
    require_values();
    if (*simplify_app_) {
        return simplify_command(simplify_);
    }
    if (*verify_app_) {
        return verify_command(verify_);
    }
    if (*repair_app_) {
        return repair_command(repair_);
    }
    if (*bake_app_) {
        return bake_command(bake_);
    }
    if (*reconstruct_app_) {
        return reconstruct_command(reconstruct_);
    }
    if (*info_app_) {
        return InfoCommand{file_name({"MESH", info_.mesh}), info_.json};
    }
    throw WrongUsage("a command is missing: simplify, verify, repair, bake, reconstruct or info (see foldless --help)");
}

} // namespace

Command parse_command_line(int argc, const char* const* argv) {
    return Parser().parse(argc, argv);
}

} // namespace foldless
