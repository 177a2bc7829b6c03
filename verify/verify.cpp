#include <foldless/verify/verify.h>

#include <foldless/verify/base_checks.h>
#include <foldless/verify/base_rays.h>
#include <foldless/verify/border_curves.h>
#include <foldless/verify/face_checks.h>
#include <foldless/verify/interior_samples.h>
#include <foldless/verify/needed_ranges.h>
#include <foldless/verify/requirements.h>
#include <foldless/verify/surface_map.h>
#include <foldless/verify/topology_checks.h>

#include <foldless/predicates/default_arithmetic.h>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace foldless {
namespace {

using namespace verification;

/// The shares of all work, as measured on large scans; only the progress function reads them.
constexpr double share_of_ranges = 0.1;
constexpr double share_of_base = 0.05;
constexpr double share_of_places = 0.2;
constexpr double share_of_faces = 0.5;
constexpr double share_of_rays = 0.15;

void require_sensible(const VerifyOptions& options) {
    if (options.threads.value_or(1) < 1) {
        throw std::invalid_argument("VerifyOptions: threads is less than 1");
    }
    if (options.samples_per_face < 0) {
        throw std::invalid_argument("VerifyOptions: samples_per_face is negative");
    }
    if (options.rays_per_face < 1) {
        throw std::invalid_argument("VerifyOptions: rays_per_face is less than 1");
    }
}

/// The displacements, summed in the order of the vertices.
void summarise_displacements(const Correspondents& all, const Adjacency& scan_adjacency, VerifyResult& result) {
    double sum_of_squares = 0.0;
    std::size_t count = 0;
    for (std::size_t v = 0; v < all.scan.positions.size(); ++v) {
        const bool is_used = !scan_adjacency.faces_around(static_cast<std::int32_t>(v)).empty();
        const Place& place = all.association.place(static_cast<std::int32_t>(v));
        if (!is_used) {
            continue;
        }
        const double length =
            place.exists() ? displacement(all.base, place, all.scan.positions[v]) : 0.0; // 0 on a frozen face
        result.min_displacement = count == 0 ? length : std::min(result.min_displacement, length);
        result.max_displacement = count == 0 ? length : std::max(result.max_displacement, length);
        sum_of_squares += length * length;
        ++count;
    }
    result.rms_displacement = count == 0 ? 0.0 : std::sqrt(sum_of_squares / static_cast<double>(count));
}

/// The scan face that a frozen base face is.
std::int32_t frozen_scan_face(const Meshes& meshes, std::int32_t base_face) {
    const Triangle& corners = meshes.base.faces[base_face];
    return meshes.scan_adjacency.face_with(meshes.kept.scan_of[corners[0]], meshes.kept.scan_of[corners[1]]);
}

SurfaceMap surface_map(const BaseFaces& faces, const Meshes& meshes, const Meetings& meetings) {
    SurfaceMap map;
    map.scan_faces.reserve(meetings.size() + faces.frozen_count());
    auto meeting = meetings.begin();
    for (std::int32_t face = 0; face < static_cast<std::int32_t>(meshes.base.faces.size()); ++face) {
        map.first.push_back(map.scan_faces.size());
        map.ranges.push_back(faces.is_moving(face) ? faces.face(face).range : Range{0.0, 0.0});
        map.frozen.push_back(!faces.is_moving(face));
        if (!faces.is_moving(face)) {
            map.scan_faces.push_back(frozen_scan_face(meshes, face));
        }
        for (; meeting != meetings.end() && meeting->first == face; ++meeting) {
            map.scan_faces.push_back(meeting->second);
        }
    }
    map.first.push_back(map.scan_faces.size());
    return map;
}

/// \param map where the surface map is kept, or null
VerifyResult run(const BaseMesh& base, const Scan& scan, const VerifyOptions& options, SurfaceMap* map) {
    require_usable(base, scan);
    VerifyResult result;
    Findings findings;
    Stages stages(options.progress);

    check_topology(base, scan, findings);
    const Adjacency base_adjacency(base.positions.size(), base.faces);
    const Adjacency scan_adjacency(scan.positions.size(), scan.faces);
    const KeptVertices kept = kept_vertices(base, scan, scan_adjacency, findings);
    const Meshes meshes{base, scan, base_adjacency, scan_adjacency, kept};
    BaseFaces faces(meshes);
    const bool locked = border_is_locked(meshes);
    check_seams(meshes, faces, locked, findings);

    result.frozen_faces = faces.frozen_count();
    result.ranges_computed = base.ranges.empty();
    if (result.ranges_computed) {
        set_needed_ranges(faces, meshes, stages, share_of_ranges);
    }
    check_jacobians(faces, stages, share_of_base, findings);
    check_base_windings(faces, stages, 0.0, findings);

    const Association association = Associator(faces, meshes).associate(stages, share_of_places, findings);
    const Correspondents all{faces, scan, association};
    Degree degree(faces, meshes);
    const bool is_proof = !faces.constant_directions();
    const bool has_rays = !is_proof || !locked;
    const Meetings meetings = FaceChecks(all, scan_adjacency, degree, findings)
                                  .check(stages, has_rays ? share_of_faces : share_of_faces + share_of_rays);
    if (is_proof && !locked) {
        const BorderCurves curves(all, meshes);
        curves.check(meetings, stages, 0.0, findings);
        curves.settle(degree);
    }
    if (is_proof) {
        result.level = Level::surface;
        degree.check(association, findings);
    } else {
        check_interior_samples(all, options.samples_per_face, stages, findings);
    }
    if (has_rays) {
        const BaseRays rays(all, meetings, {options.rays_per_face, locked, !is_proof});
        const double uncovered = rays.check(stages, share_of_rays, findings);
        result.uncovered_fraction = locked ? 0.0 : uncovered;
    }

    result.cancelled = stages.cancelled();
    result.signs = stages.signs();
    findings.write(result);
    result.ambiguous_vertices = association.ambiguous_vertices;
    summarise_displacements(all, scan_adjacency, result);
    if (map != nullptr && !result.cancelled) {
        *map = surface_map(faces, meshes, meetings);
    }
    return result;
}

/// As many threads as are asked for; never more than the process may have.
int concurrency(const VerifyOptions& options) {
    const auto allowed =
        static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
    return std::min(options.threads.value_or(allowed), allowed);
}

VerifyResult run_on_threads(const BaseMesh& base, const Scan& scan, const VerifyOptions& options, SurfaceMap* map) {
    require_sensible(options);
    const DefaultArithmetic arithmetic;
    tbb::task_arena arena(concurrency(options)); // its threads compute as this one does
    return arena.execute([&] { return run(base, scan, options, map); });
}

} // namespace

VerifyResult verify(const BaseMesh& base, const Scan& scan, const VerifyOptions& options) {
    return run_on_threads(base, scan, options, nullptr);
}

MappedSurface map_surface(const BaseMesh& base, const Scan& scan, const VerifyOptions& options) {
    MappedSurface result;
    result.certificate = run_on_threads(base, scan, options, &result.map);
    return result;
}

} // namespace foldless
