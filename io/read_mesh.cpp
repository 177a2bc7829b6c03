#include <foldless/io/read_mesh.h>

#include <foldless/io/float32.h>
#include <foldless/io/printable.h>
#include <foldless/io/read_raw.h>
#include <foldless/predicates/default_arithmetic.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace foldless {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, std::string_view reason) {
    throw RefusedMesh(fmt::format("{}: {}", printable(path), reason));
}

void require_directions(const std::filesystem::path& path, const RawMesh& mesh) {
    if (mesh.corner_conflicts > 0) {
        refuse(path, "no displacement directions: " +
                         counted(mesh.corner_conflicts, "vertex has several normals", "vertices have several normals"));
    }
    if (mesh.missing_normals > 0) {
        refuse(path, "no displacement directions: " +
                         counted(mesh.missing_normals, "vertex has no normal", "vertices have no normal"));
    }
    if (mesh.normals.empty() && mesh.face_normals.empty()) {
        refuse(path, "the mesh has no displacement directions");
    }
}

void require_finite_directions(const std::filesystem::path& path, const RawMesh& mesh) {
    const auto bad = [](const Vec3& direction) { return !direction.allFinite(); };
    const auto count = std::ranges::count_if(mesh.normals, bad) + std::ranges::count_if(mesh.face_normals, bad);
    if (count > 0) {
        refuse(path, counted(static_cast<std::size_t>(count), "displacement direction is not finite",
                             "displacement directions are not finite"));
    }
}

void require_ranges(const std::filesystem::path& path, const RawMesh& mesh) {
    const auto count = std::ranges::count_if(mesh.ranges, [](const Range& range) {
        return !(range.lo <= range.hi) || !std::isfinite(range.lo) || !std::isfinite(range.hi);
    });
    if (count > 0) {
        refuse(path, counted(static_cast<std::size_t>(count), "displacement range is not finite or has t_min > t_max",
                             "displacement ranges are not finite or have t_min > t_max"));
    }
}

} // namespace

ReadScan read_scan(const std::filesystem::path& path) {
    const DefaultArithmetic arithmetic; // for the numbers in text
    RawMesh mesh = read_raw(path, Content::scan);
    return {take_scan(mesh), std::move(mesh.notes)};
}

ReadBaseMesh read_base_mesh(const std::filesystem::path& path) {
    const DefaultArithmetic arithmetic;
    RawMesh mesh = read_raw(path, Content::base_mesh);
    require_directions(path, mesh);
    if (!mesh.normals.empty() && !mesh.face_normals.empty()) {
        mesh.face_normals.clear();
        mesh.ignore("face normals");
    }
    require_finite_directions(path, mesh);
    require_ranges(path, mesh);
    const bool float32 = all_float32(mesh.positions);
    return {{std::move(mesh.positions), std::move(mesh.normals), std::move(mesh.scan_vertex), std::move(mesh.faces),
             std::move(mesh.ranges), std::move(mesh.face_normals), float32},
            std::move(mesh.notes)};
}

} // namespace foldless
