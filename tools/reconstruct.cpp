#include <foldless/tools/reconstruct.h>

#include <foldless/bake/atlas_sampler.h>
#include <foldless/bake/map_files.h>
#include <foldless/bake/reconstruct.h>
#include <foldless/bake/surface_distance.h>
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
#include <foldless/tools/plain_mesh.h>
#include <foldless/tools/threads.h>

#include <fmt/format.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace foldless {

namespace {

/// As they will be stored.
void round_to_float32(Scan& surface) {
    for (Vec3& position : surface.positions) {
        position = position.cast<float>().cast<double>();
    }
    surface.float32 = true;
}

Scan surface_of(const ReconstructCommand& command, const BaseMesh& base, const DisplacementMaps& maps) {
    const AtlasSampler sampler(maps.atlas, maps.displacement, maps.mask);
    const auto value_at = [&](std::int32_t face, const Vec3& alpha) { return sampler.value(face, alpha); };
    try {
        return reconstruct(base, value_at, {command.level, threads_to_use(command.threads)});
    } catch (const std::length_error& error) {
        throw RefusedMesh(fmt::format("{} at --level {}: {}", printable(command.base), command.level, error.what()));
    }
}

/// The surface as it will be written.
Scan stored_surface(const ReconstructCommand& command, const BaseMesh& base) {
    const DisplacementMaps maps = read_maps(command.maps, base.faces.size());
    Scan surface = surface_of(command, base, maps);
    if (surface.faces.empty()) {
        throw RefusedMesh(fmt::format("{}: covers nothing at --level {}", printable(command.maps), command.level));
    }
    if (base.float32) {
        round_to_float32(surface);
    }
    return surface;
}

Comparison compare_with_bar(const ReconstructCommand& command, const Input& input, const Scan& surface) {
    ProgressBar bar(Console(command.quiet).bar_output());
    Comparison comparison;
    comparison.scan = input.record;
    comparison.diagonal = bounding_box_diagonal(input.scan);
    comparison.bound = comparison_bound * comparison.diagonal;
    DistanceOptions options;
    options.bound = comparison.bound;
    options.threads = threads_to_use(command.threads);
    options.progress = [&](double share) {
        bar.show("comparing", share, "");
        return true;
    };
    try {
        comparison.distance = surface_distance(input.scan, surface, options);
    } catch (const std::invalid_argument& error) { // the bound may be too small for coordinates this large
        throw RefusedMesh(fmt::format("{}: cannot be compared: {}", printable(*command.scan), error.what()));
    }
    return comparison;
}

std::string distance_text(const OneSidedDistance& distance, double diagonal) {
    return fmt::format("at most {:.4g} ({:.4f} % of the diagonal), RMS {:.4g} ({:.5f} %)", distance.maximum_bound,
                       100.0 * distance.maximum_bound / diagonal, distance.rms, 100.0 * distance.rms / diagonal);
}

std::vector<std::string> summary_lines(const ReconstructRecord& record) {
    std::vector<std::string> lines{
        fmt::format("{}: {} vertices, {} faces", printable(record.path), record.vertices, record.faces)};
    if (record.comparison) {
        const Comparison& found = *record.comparison;
        lines.push_back(fmt::format("distance from the scan: {}", distance_text(found.distance.there, found.diagonal)));
        lines.push_back(fmt::format("distance to the scan:   {}", distance_text(found.distance.back, found.diagonal)));
    }
    return lines;
}

ReconstructRecord record_of(const ReconstructCommand& command, const Scan& surface) {
    ReconstructRecord record;
    record.base = command.base.string();
    record.maps = command.maps.string();
    record.level = command.level;
    record.path = command.output.string();
    record.vertices = surface.positions.size();
    record.faces = surface.faces.size();
    record.usage.threads = threads_to_use(command.threads);
    return record;
}

AtomicFile stage_surface(const ReconstructCommand& command, Scan&& surface) {
    const std::vector<std::string> comments{fmt::format("foldless {} reconstruct, level {}", version(), command.level)};
    return stage_base_mesh(command.output, without_directions(std::move(surface)), comments);
}

} // namespace

ExitCode run(const ReconstructCommand& command) {
    require_writable(command.output);
    if (command.report) {
        require_writable(*command.report);
    }
    const ThreadAllowance allowance(threads_to_use(command.threads));
    const Console console(command.quiet);
    Stopwatch watch;
    PhaseTimes times;
    const BaseMesh base = read_base_with_vertex_directions(command.base, console);
    std::optional<Input> scan;
    if (command.scan) {
        scan = read_input(*command.scan, console);
    }
    times.read = watch.lap();
    Scan surface = stored_surface(command, base);
    times.reconstruct = watch.lap();
    ReconstructRecord record = record_of(command, surface);
    if (scan) {
        record.comparison = compare_with_bar(command, *scan, surface);
        times.compare = watch.lap();
    }
    std::vector<AtomicFile> files;
    files.push_back(stage_surface(command, std::move(surface)));
    times.write = watch.lap();
    record.usage.times = times;
    record.usage.peak_memory_bytes = peak_memory_bytes();
    if (command.report) {
        files.push_back(stage_text(*command.report, json_report(record)));
    }
    const std::vector<std::string> lines = summary_lines(record);
    commit_all(files);
    console.print(lines);
    return ExitCode::done;
}

} // namespace foldless
