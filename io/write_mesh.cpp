#include <foldless/io/write_mesh.h>

#include <foldless/io/file_type.h>
#include <foldless/io/float32.h>
#include <foldless/io/printable.h>
#include <foldless/io/write_obj.h>
#include <foldless/io/write_ply.h>

#include <fmt/format.h>

#include <algorithm>

namespace foldless {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view reason) {
    throw UnwritableFile(fmt::format("{}: cannot be written: {}", printable(path), reason));
}

FileType require_file_type(const std::filesystem::path& path, bool face_directions) {
    const FileType type = file_type(path);
    if (type != FileType::ply && type != FileType::obj) {
        fail(path, "unknown file type; .ply and .obj can be written");
    }
    if (type == FileType::obj && face_directions) {
        fail(path, "OBJ has no room for constant face directions; choose .ply");
    }
    return type;
}

/// Arrays that are absent are empty; the others have one entry per vertex or per face.
void require_lengths(const std::filesystem::path& path, const BaseMesh& base) {
    const auto fits = [](std::size_t length, std::size_t wanted) { return length == 0 || length == wanted; };
    const std::size_t vertices = base.positions.size();
    const std::size_t faces = base.faces.size();
    if (!fits(base.directions.size(), vertices) || !fits(base.scan_vertex.size(), vertices) ||
        !fits(base.ranges.size(), faces) || !fits(base.face_directions.size(), faces)) {
        fail(path, "the arrays of the base mesh differ in length");
    }
}

// What is proven must be what is written: a value that the file would round is refused.
void require_exact(const std::filesystem::path& path, const BaseMesh& base) {
    const bool ranges = std::ranges::all_of(
        base.ranges, [](const Range& range) { return is_float32(range.lo) && is_float32(range.hi); });
    if ((base.float32 && !all_float32(base.positions)) || !all_float32(base.directions) ||
        !all_float32(base.face_directions) || !ranges) {
        fail(path, "the base mesh has values that float32 does not hold");
    }
}

} // namespace

void require_writable(const std::filesystem::path& path) {
    const AtomicFile probe(path);
}

void require_writable_base_mesh(const std::filesystem::path& path, bool face_directions) {
    require_file_type(path, face_directions);
    require_writable(path);
}

AtomicFile stage_base_mesh(const std::filesystem::path& path, const BaseMesh& base,
                           const std::vector<std::string>& comments) {
    const FileType type = require_file_type(path, !base.face_directions.empty());
    require_lengths(path, base);
    require_exact(path, base);
    AtomicFile file(path);
    type == FileType::ply ? write_ply(file, base, comments) : write_obj(file, base, comments);
    file.finish();
    return file;
}

AtomicFile stage_correspondence(const std::filesystem::path& path, const Scan& scan,
                                const Correspondence& correspondence) {
    const std::size_t vertices = scan.positions.size();
    if (correspondence.base_face.size() != vertices || correspondence.alpha.size() != vertices ||
        correspondence.t.size() != vertices) {
        fail(path, "the correspondence and the scan differ in length");
    }
    AtomicFile file(path);
    write_ply(file, scan, correspondence);
    file.finish();
    return file;
}

AtomicFile stage_text(const std::filesystem::path& path, const std::string& text) {
    AtomicFile file(path);
    file.write(text);
    file.finish();
    return file;
}

void write_base_mesh(const std::filesystem::path& path, const BaseMesh& base,
                     const std::vector<std::string>& comments) {
    stage_base_mesh(path, base, comments).commit();
}

void write_correspondence(const std::filesystem::path& path, const Scan& scan, const Correspondence& correspondence) {
    stage_correspondence(path, scan, correspondence).commit();
}

void write_text(const std::filesystem::path& path, const std::string& text) {
    stage_text(path, text).commit();
}

} // namespace foldless
