#include <foldless/tools/bake.h>

#include <foldless/bake/atlas_maps.h>
#include <foldless/bake/fit_maps.h>
#include <foldless/bake/map_files.h>
#include <foldless/io/atomic_file.h>
#include <foldless/io/bounding_box.h>
#include <foldless/io/errors.h>
#include <foldless/io/printable.h>
#include <foldless/io/write_mesh.h>
#include <foldless/report/json_report.h>
#include <foldless/report/process_usage.h>
#include <foldless/report/progress_bar.h>
#include <foldless/report/version.h>
#include <foldless/tools/base_input.h>
#include <foldless/tools/console.h>
#include <foldless/tools/input.h>
#include <foldless/tools/lengths.h>
#include <foldless/tools/threads.h>
#include <foldless/tools/verify.h>
#include <foldless/tools/wrong_usage.h>
#include <foldless/verify/surface_map.h>

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

namespace foldless {

namespace {

/// Before the work: whether the folder, or one of its name, can be written.
void require_writable_folder(const std::filesystem::path& folder) {
    std::error_code error;
    if (std::filesystem::is_directory(folder, error)) {
        require_writable(folder / "maps.json");
    } else if (std::filesystem::exists(folder, error)) {
        throw UnwritableFile(fmt::format("{}: is not a folder", printable(folder)));
    } else {
        require_writable(folder);
    }
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directory(folder, error);
    if (error) {
        throw UnwritableFile(fmt::format("{}: {}", printable(folder), error.message()));
    }
}

Atlas atlas_for(const BaseMesh& base, int size) {
    AtlasOptions options;
    options.size = size;
    try {
        return make_atlas(base, options);
    } catch (const AtlasTooSmall& error) {
        throw WrongUsage(fmt::format("--atlas: {}", error.what()));
    }
}

MappedSurface map_with_bar(const BakeCommand& command, const BaseMesh& base, const Scan& scan) {
    ProgressBar bar(Console(command.quiet).bar_output());
    VerifyOptions options;
    options.threads = threads_to_use(command.threads);
    options.progress = [&](double share) {
        bar.show("verifying", share, "");
        return true;
    };
    try {
        return map_surface(base, scan, options);
    } catch (const RefusedMesh& refusal) { // the scan has been inspected before
        throw RefusedMesh(fmt::format("{}: {}", printable(command.base), refusal.what()));
    }
}

AtlasMaps bake_with_bar(const BakeCommand& command, const BaseMesh& base, const ScanSurface& surface,
                        const SurfaceMap& map, const Atlas& atlas) {
    ProgressBar bar(Console(command.quiet).bar_output());
    AtlasMapsOptions options;
    options.method = command.method;
    options.vector = command.vector;
    options.normal = command.normal;
    options.colour = command.color;
    options.threads = threads_to_use(command.threads);
    options.progress = [&](double share) {
        bar.show("baking", share, "");
        return true;
    };
    return bake_atlas(base, surface, map, atlas, options);
}

/// How large the maps are to be, if that depends on an error.
std::optional<FitRecord> fit_with_bar(const BakeCommand& command, const BaseMesh& base, const ScanSurface& surface,
                                      const SurfaceMap& map) {
    if (!command.max_error) {
        return std::nullopt;
    }
    ProgressBar bar(Console(command.quiet).bar_output());
    FitRecord record;
    record.diagonal = bounding_box_diagonal(surface.scan());
    record.max_error = in_model_units(*command.max_error, record.diagonal);
    FitOptions options;
    options.max_error = record.max_error;
    options.bound = comparison_bound * record.diagonal;
    options.largest = command.atlas;
    options.threads = threads_to_use(command.threads);
    options.progress = [&](double share) {
        bar.show("fitting", share, "");
        return true;
    };
    record.fit = fit_maps(base, surface, map, options);
    return record;
}

std::string fit_text(const FitRecord& record) {
    const double most = record.fit.distance.maximum_bound();
    return fmt::format("at --level {} within {:.4g} of the scan ({:.4f} % of the diagonal)", record.fit.level, most,
                       100.0 * most / record.diagonal);
}

std::string summary_line(const MapsRecord& maps) {
    const double share = 100.0 * static_cast<double>(maps.uncovered) / static_cast<double>(maps.samples);
    const std::string line = fmt::format("{}: {} x {} texels, {} samples, {:.2f} % of them uncovered",
                                         printable(maps.path), maps.size, maps.size, maps.samples, share);
    return maps.method == BakeMethod::direct ? fmt::format("{}: {} rays met nothing", line, maps.uncovered) : line;
}

std::vector<std::string> summary_lines(const BakeRecord& record) {
    std::vector<std::string> lines{summary_line(record.maps)};
    if (record.fit) {
        lines.push_back(fmt::format("{}: {}", printable(record.maps.path), fit_text(*record.fit)));
    }
    return lines;
}

std::string shortfall_text(const FitRecord& record) {
    return fmt::format("--max-error {:.4g} is not reached: {} x {} texels are {}", record.max_error, record.fit.size,
                       record.fit.size, fit_text(record));
}

/// What is known before there are maps.
BakeRecord record_of(const BakeCommand& command, const BaseMesh& base, const Input& input) {
    BakeRecord record;
    record.input = input.record;
    record.base = {command.base.string(), base.positions.size(), base.faces.size(), 0};
    record.maps.method = command.method;
    record.maps.size = command.atlas;
    record.usage.threads = threads_to_use(command.threads);
    return record;
}

void stage_report(std::vector<AtomicFile>& files, const BakeCommand& command, BakeRecord& record) {
    if (command.report) {
        record.usage.peak_memory_bytes = peak_memory_bytes();
        files.push_back(stage_text(*command.report, json_report(record)));
    }
}

/// With the report, which tells what is wrong.
ExitCode refuse(const BakeCommand& command, BakeRecord& record) {
    std::vector<AtomicFile> files;
    stage_report(files, command, record);
    commit_all(files);
    std::ranges::for_each(violation_messages(printable(command.base), record.certificate), print_message);
    return ExitCode::not_certified;
}

} // namespace

void require_writable_outputs(const BakeCommand& command) {
    require_writable_folder(command.folder);
    if (command.report) {
        require_writable(*command.report);
    }
}

ExitCode run(const BakeCommand& command) {
    require_writable_outputs(command);
    const ThreadAllowance allowance(threads_to_use(command.threads));
    const Console console(command.quiet);
    Stopwatch watch;
    const BaseMesh base = read_base_with_vertex_directions(command.base, console);
    const ColouredInput read = read_coloured_input(command.scan, console);
    const Scan& scan = read.input.scan;
    BakeRecord record = record_of(command, base, read.input);
    PhaseTimes& times = record.usage.times;
    times.read = watch.lap();
    (void)atlas_for(base, command.atlas); // there is room, or nothing else needs to be done
    MappedSurface mapped = map_with_bar(command, base, scan);
    times.verify = watch.lap();
    record.certificate = std::move(mapped.certificate);
    record.base.frozen_faces = record.certificate.frozen_faces;
    if (!record.certificate.certified()) {
        return refuse(command, record);
    }
    const ScanSurface surface(scan, read.appearance.vertex_colours);
    record.fit = fit_with_bar(command, base, surface, mapped.map);
    times.fit = watch.lap();
    const Atlas atlas = atlas_for(base, record.fit ? record.fit->fit.size : command.atlas);
    const AtlasMaps maps = bake_with_bar(command, base, surface, mapped.map, atlas);
    times.bake = watch.lap();
    record.maps = {command.folder.string(), command.method, atlas.size, maps.samples, maps.uncovered, maps.contested};
    make_folder(command.folder);
    std::vector<AtomicFile> files =
        stage_maps(command.folder, {&base, &atlas, &maps}, fmt::format("foldless {}", version()));
    times.write = watch.lap();
    stage_report(files, command, record);
    const std::vector<std::string> lines = summary_lines(record);
    commit_all(files);
    if (record.fit && !record.fit->fit.fits) {
        print_message(shortfall_text(*record.fit));
    }
    console.print(lines);
    return ExitCode::done;
}

} // namespace foldless
