/// \file
/// foldless-generate: writes a scan with known answers.

#include <foldless/io/atomic_file.h>
#include <foldless/models/make_model.h>
#include <foldless/models/stream_ply.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <new>
#include <stdexcept>
#include <string>

namespace {

/// The exit codes of foldless, as far as they apply.
enum ExitCode : int { done = 0, internal_error = 1, wrong_usage = 2, cannot_write = 5, out_of_memory = 7 };

/// Leaves nothing partial behind and ends as the signal would have done, which a shell shows as 128 + number.
void end_by_signal(int number) {
    foldless::remove_temporary_files();
    std::signal(number, SIG_DFL);
    std::raise(number);
}

/// A file beyond the size limit shall be an error of the write, not a death.
void handle_signals() {
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        std::signal(number, end_by_signal);
    }
    std::signal(SIGXFSZ, SIG_IGN);
}

struct Arguments {
    std::string shape;
    foldless::ModelRequest request;
    std::string output;
    bool float64 = false;
};

void declare(CLI::App& app, Arguments& arguments) {
    app.name("foldless-generate");
    app.add_option("SHAPE", arguments.shape, "one of " + foldless::names_of_shapes())->required();
    app.add_option("--faces", arguments.request.faces, "at most so many faces, and nearly as many")->required();
    app.add_option("-o,--output", arguments.output, "the file to write: binary little endian PLY")->required();
    app.add_option("--noise", arguments.request.finish.noise,
                   "standard deviation of a scanner's noise along the normal, in mean edge lengths (default 0)");
    app.add_option("--seed", arguments.request.finish.seed, "of the noise (default 0)");
    app.add_flag("--float64", arguments.float64, "store coordinates as float64, not float32");
}

/// How to make the same file again: what decides the bytes, and nothing else.
std::string comment_of(const foldless::ModelRequest& request) {
    std::string comment =
        fmt::format("foldless-generate {} --faces {}", foldless::name_of(request.shape), request.faces);
    if (request.finish.noise > 0) {
        comment += fmt::format(" --noise {} --seed {}", request.finish.noise, request.finish.seed);
    }
    return comment + (request.finish.float32 ? "" : " --float64");
}

int generate(Arguments arguments) {
    const auto shape = foldless::shape_named(arguments.shape);
    if (!shape) {
        throw std::invalid_argument(
            fmt::format("no shape is called '{}'; there are {}", arguments.shape, foldless::names_of_shapes()));
    }
    arguments.request.shape = *shape;
    arguments.request.finish.float32 = !arguments.float64;
    const foldless::Model model = foldless::make_model(arguments.request);
    foldless::stream_ply(arguments.output, model, {comment_of(arguments.request)});
    return done;
}

/// One line, and the code that goes with it.
int complain(const std::exception& error, int code) {
    fmt::print(stderr, "foldless-generate: {}\n", error.what());
    return code;
}

} // namespace

int main(int argc, char** argv) {
    handle_signals();
    CLI::App app("Writes an analytic scan, of which everything is known, as binary PLY.");
    Arguments arguments;
    try {
        declare(app, arguments);
        app.parse(argc, argv);
        return generate(arguments);
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        return complain(error, wrong_usage);
    } catch (const std::invalid_argument& error) {
        return complain(error, wrong_usage);
    } catch (const foldless::UnwritableFile& error) {
        return complain(error, cannot_write);
    } catch (const std::bad_alloc& error) {
        return complain(error, out_of_memory);
    } catch (const std::exception& error) {
        return complain(error, internal_error);
    }
}
