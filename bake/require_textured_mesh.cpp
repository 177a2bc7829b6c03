#include <foldless/bake/require_textured_mesh.h>

#include <foldless/io/errors.h>
#include <foldless/io/printable.h>

#include <fmt/format.h>

#include <algorithm>

namespace foldless {

namespace {

bool lengths_agree(const TexturedMesh& mesh) {
    const std::size_t directions = mesh.base->directions.size();
    return mesh.uv.size() == mesh.base->faces.size() && (directions == 0 || directions == mesh.base->positions.size());
}

bool indices_are_in_range(const BaseMesh& base) {
    return std::ranges::all_of(base.faces, [&](const Triangle& face) {
        return std::ranges::all_of(face, [&](std::int32_t vertex) {
            return vertex >= 0 && static_cast<std::size_t>(vertex) < base.positions.size();
        });
    });
}

bool all_finite(const TexturedMesh& mesh) {
    const auto finite = [](const auto& vector) { return vector.allFinite(); };
    return std::ranges::all_of(mesh.base->positions, finite) && std::ranges::all_of(mesh.base->directions, finite) &&
           std::ranges::all_of(mesh.uv, [&](const auto& corners) { return std::ranges::all_of(corners, finite); });
}

} // namespace

void refuse_to_write(const std::filesystem::path& path, std::string_view reason) {
    throw UnwritableFile(fmt::format("{}: cannot be written: {}", printable(path), reason));
}

void require_textured_mesh(const std::filesystem::path& path, const TexturedMesh& mesh) {
    if (!lengths_agree(mesh)) {
        refuse_to_write(path, "the arrays of the textured mesh differ in length");
    }
    if (!indices_are_in_range(*mesh.base)) {
        refuse_to_write(path, "the base mesh has a face whose vertex is out of range");
    }
    if (!all_finite(mesh)) {
        refuse_to_write(path, "the textured mesh has numbers that are not finite");
    }
}

} // namespace foldless
