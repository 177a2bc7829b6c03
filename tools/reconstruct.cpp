#include <foldless/tools/reconstruct.h>

#include <foldless/bake/atlas_sampler.h>
#include <foldless/bake/map_files.h>
#include <foldless/bake/reconstruct.h>
#include <foldless/io/atomic_file.h>
#include <foldless/io/errors.h>
#include <foldless/io/printable.h>
#include <foldless/io/write_mesh.h>
#include <foldless/report/version.h>
#include <foldless/tools/base_input.h>
#include <foldless/tools/console.h>
#include <foldless/tools/plain_mesh.h>
#include <foldless/tools/threads.h>

#include <fmt/format.h>

#include <stdexcept>
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
    const auto displacement_at = [&](std::int32_t face, const Vec3& alpha) {
        return sampler.displacement(face, alpha);
    };
    try {
        return reconstruct(base, displacement_at, {command.level, threads_to_use(command.threads)});
    } catch (const std::length_error& error) {
        throw RefusedMesh(fmt::format("{} at --level {}: {}", printable(command.base), command.level, error.what()));
    }
}

} // namespace

ExitCode run(const ReconstructCommand& command) {
    require_writable(command.output);
    const ThreadAllowance allowance(threads_to_use(command.threads));
    const Console console(command.quiet);
    const BaseMesh base = read_base_with_vertex_directions(command.base, console);
    const DisplacementMaps maps = read_maps(command.maps, base.faces.size());
    Scan surface = surface_of(command, base, maps);
    if (surface.faces.empty()) {
        throw RefusedMesh(fmt::format("{}: covers nothing at --level {}", printable(command.maps), command.level));
    }
    if (base.float32) {
        round_to_float32(surface);
    }
    const std::vector<std::string> lines{fmt::format("{}: {} vertices, {} faces", printable(command.output),
                                                     surface.positions.size(), surface.faces.size())};
    const std::vector<std::string> comments{fmt::format("foldless {} reconstruct, level {}", version(), command.level)};
    std::vector<AtomicFile> files;
    files.push_back(stage_base_mesh(command.output, without_directions(std::move(surface)), comments));
    commit_all(files);
    console.print(lines);
    return ExitCode::done;
}

} // namespace foldless
