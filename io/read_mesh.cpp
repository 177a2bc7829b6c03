#include <foldless/io/read_mesh.h>

#include <foldless/io/file_bytes.h>
#include <foldless/io/file_type.h>
#include <foldless/io/float32.h>
#include <foldless/io/printable.h>
#include <foldless/io/raw_mesh.h>
#include <foldless/io/read_obj.h>
#include <foldless/io/read_off.h>
#include <foldless/io/read_ply.h>
#include <foldless/io/read_stl.h>
#include <foldless/predicates/default_arithmetic.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace foldless {

namespace {

constexpr std::string_view gzip_magic = "\x1f\x8b";

RawMesh read_bytes(const std::filesystem::path& path, std::string_view bytes, Content content) {
    const std::string name = printable(path);
    if (bytes.starts_with(gzip_magic)) {
        throw UnreadableFile(fmt::format("{}: compressed with gzip; decompress it first", name));
    }
    switch (file_type(path)) {
    case FileType::ply: return read_ply(bytes, name, content);
    case FileType::obj: return read_obj(bytes, name, content);
    case FileType::off: return read_off(bytes, name);
    case FileType::stl: return read_stl(bytes, name);
    default: throw UnreadableFile(fmt::format("{}: unknown file type; .ply, .obj, .off and .stl can be read", name));
    }
}

/// \throws RefusedMesh for polygons that cannot be fanned.
RawMesh read_raw(const std::filesystem::path& path, Content content) {
    const FileBytes file(path);
    RawMesh mesh = read_bytes(path, file.bytes(), content);
    mesh.notes.fanned_polygons = mesh.fans.size();
    if (const std::string refused = refused_polygons_text(mesh); !refused.empty()) {
        throw RefusedMesh(fmt::format("{}: {}", printable(path), refused));
    }
    return mesh;
}

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
    const bool float32 = all_float32(mesh.positions);
    return {{std::move(mesh.positions), std::move(mesh.faces), float32}, std::move(mesh.notes)};
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
