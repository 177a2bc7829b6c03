/// \file
/// foldless_bench_unguarded: one scan decimated with and without the validator, in this order, in one process.

#include <foldless/bench/bench_models.h>
#include <foldless/bench/unguarded_loop.h>
#include <foldless/io/read_mesh.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace {

using Json = nlohmann::ordered_json;

/// The exit codes of foldless, as far as they apply.
enum ExitCode : int { done = 0, internal_error = 1, wrong_usage = 2, unreadable = 3, refused = 4 };

struct Arguments {
    std::string model;
    std::optional<std::size_t> faces;
    bool trim = false;
};

void declare(CLI::App& app, Arguments& arguments) {
    app.name("foldless_bench_unguarded");
    app.add_option("MODEL", arguments.model, "a scan")->required();
    app.add_option("FACES", arguments.faces, "stop at so many (default: until every edge is refused)");
    app.add_flag("--trim", arguments.trim, "--boundary trim instead of lock");
}

Json run_json(std::size_t faces, double setup, double decimate) {
    return {{"faces", faces}, {"cpu_seconds", {{"setup", setup}, {"decimate", decimate}, {"total", setup + decimate}}}};
}

/// Both runs; the one without validator goes down to the faces that the guarded one has reached.
Json compare(const Arguments& arguments) {
    const foldless::Scan scan = foldless::read_scan(arguments.model).scan;
    foldless::DecimateOptions options = foldless::bench_options();
    options.target_faces = arguments.faces;
    options.boundary = arguments.trim ? foldless::Boundary::trim : foldless::Boundary::lock;
    const foldless::DecimateResult guarded = foldless::decimate(scan, options);
    options.target_faces = guarded.base.faces.size();
    const foldless::UnguardedResult unguarded = foldless::unguarded_decimate(scan, options);
    Json json{{"model", arguments.model}, {"faces", scan.faces.size()}};
    json["guarded"] = run_json(guarded.base.faces.size(), guarded.statistics.setup_cpu_seconds,
                               guarded.statistics.decimate_cpu_seconds);
    json["unguarded"] = run_json(unguarded.faces, unguarded.setup_cpu_seconds, unguarded.decimate_cpu_seconds);
    json["ratio"] =
        json["guarded"]["cpu_seconds"]["total"].get<double>() / json["unguarded"]["cpu_seconds"]["total"].get<double>();
    return json;
}

/// One line, and the code that goes with it.
int complain(const std::exception& error, int code) {
    fmt::print(stderr, "foldless_bench_unguarded: {}\n", error.what());
    return code;
}

} // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CLI::App app("One scan decimated with and without the validator: processor seconds, as JSON.");
    try {
        declare(app, arguments);
        app.parse(argc, argv);
        fmt::print("{}\n", compare(arguments).dump(2));
        return done;
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? done : wrong_usage;
    } catch (const foldless::UnreadableFile& error) {
        return complain(error, unreadable);
    } catch (const foldless::RefusedMesh& error) {
        return complain(error, refused);
    } catch (const std::exception& error) {
        return complain(error, internal_error);
    }
}
