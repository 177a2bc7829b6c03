#include <foldless/tools/bake.h>

#include <foldless/bake/atlas_maps.h>
#include <foldless/bake/map_files.h>
#include <foldless/io/atomic_file.h>
#include <foldless/io/errors.h>
#include <foldless/io/printable.h>
#include <foldless/io/write_mesh.h>
#include <foldless/report/progress_bar.h>
#include <foldless/report/version.h>
#include <foldless/tools/base_input.h>
#include <foldless/tools/console.h>
#include <foldless/tools/input.h>
#include <foldless/tools/threads.h>
#include <foldless/tools/verify.h>
#include <foldless/tools/wrong_usage.h>
#include <foldless/verify/surface_map.h>

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
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

std::string summary_line(const BakeCommand& command, const Atlas& atlas, const AtlasMaps& maps) {
    const double share = 100.0 * static_cast<double>(maps.uncovered) / static_cast<double>(maps.samples);
    return fmt::format("{}: {} x {} texels, {} samples, {:.2f} % of them uncovered", printable(command.folder),
                       atlas.size, atlas.size, maps.samples, share);
}

} // namespace

ExitCode run(const BakeCommand& command) {
    require_writable_folder(command.folder);
    const ThreadAllowance allowance(threads_to_use(command.threads));
    const Console console(command.quiet);
    const BaseMesh base = read_base_with_vertex_directions(command.base, console);
    const ColouredInput read = read_coloured_input(command.scan, console);
    const Scan& scan = read.input.scan;
    const Atlas atlas = atlas_for(base, command.atlas);
    const MappedSurface mapped = map_with_bar(command, base, scan);
    if (!mapped.certificate.certified()) {
        std::ranges::for_each(violation_messages(printable(command.base), mapped.certificate), print_message);
        return ExitCode::not_certified;
    }
    const ScanSurface surface(scan, read.appearance.vertex_colours);
    const AtlasMaps maps = bake_with_bar(command, base, surface, mapped.map, atlas);
    make_folder(command.folder);
    std::vector<AtomicFile> files =
        stage_maps(command.folder, {&base, &atlas, &maps}, fmt::format("foldless {}", version()));
    const std::vector<std::string> lines{summary_line(command, atlas, maps)};
    commit_all(files);
    console.print(lines);
    return ExitCode::done;
}

} // namespace foldless
