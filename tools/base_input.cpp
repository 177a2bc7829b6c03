#include <foldless/tools/base_input.h>

#include <foldless/io/errors.h>
#include <foldless/io/printable.h>
#include <foldless/io/read_mesh.h>
#include <foldless/tools/input.h>

#include <fmt/format.h>

#include <utility>

namespace foldless {

BaseMesh read_base(const std::filesystem::path& path, const Console& console) {
    ReadBaseMesh read = read_base_mesh(path);
    note_ignored(path, read.notes, console);
    return std::move(read.base);
}

BaseMesh read_base_with_vertex_directions(const std::filesystem::path& path, const Console& console) {
    BaseMesh base = read_base(path, console);
    if (!base.face_directions.empty()) {
        throw RefusedMesh(
            fmt::format("{}: has directions of faces, with which a displaced surface has gaps", printable(path)));
    }
    return base;
}

} // namespace foldless
