#include <foldless/io/read_raw.h>

#include <foldless/io/file_bytes.h>
#include <foldless/io/file_type.h>
#include <foldless/io/float32.h>
#include <foldless/io/printable.h>
#include <foldless/io/read_obj.h>
#include <foldless/io/read_off.h>
#include <foldless/io/read_ply.h>
#include <foldless/io/read_stl.h>

#include <fmt/format.h>

#include <string>
#include <string_view>
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
    case FileType::off: return read_off(bytes, name, content);
    case FileType::stl: return read_stl(bytes, name);
    default: throw UnreadableFile(fmt::format("{}: unknown file type; .ply, .obj, .off and .stl can be read", name));
    }
}

} // namespace

RawMesh read_raw(const std::filesystem::path& path, Content content) {
    const FileBytes file(path);
    RawMesh mesh = read_bytes(path, file.bytes(), content);
    mesh.notes.fanned_polygons = mesh.fans.size();
    if (const std::string refused = refused_polygons_text(mesh); !refused.empty()) {
        throw RefusedMesh(fmt::format("{}: {}", printable(path), refused));
    }
    return mesh;
}

Scan take_scan(RawMesh& mesh) {
    const bool float32 = all_float32(mesh.positions);
    return {std::move(mesh.positions), std::move(mesh.faces), float32};
}

} // namespace foldless
