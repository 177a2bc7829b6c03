#include <foldless/io/raw_mesh.h>

#include <foldless/io/polygon.h>
#include <foldless/io/printable.h>

#include <fmt/format.h>

#include <algorithm>

namespace foldless {

namespace {

// A header can name millions of properties; the user reads a few names.
constexpr std::size_t longest_list_of_notes = 20;

std::vector<Vec3> corner_positions(const RawMesh& mesh, const PolygonFan& fan) {
    std::vector<Vec3> corners{mesh.positions[mesh.faces[fan.first_face][0]]};
    for (std::size_t i = 0; i + 2 < fan.corners; ++i) {
        corners.push_back(mesh.positions[mesh.faces[fan.first_face + i][1]]);
    }
    corners.push_back(mesh.positions[mesh.faces[fan.first_face + fan.corners - 3][2]]);
    return corners;
}

} // namespace

std::size_t RawMesh::add_polygon(std::span<const std::int32_t> corners) {
    if (corners.size() < 3) {
        ++short_faces;
        return 0;
    }
    if (corners.size() > 3) {
        fans.push_back({faces.size(), corners.size()});
    }
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        faces.push_back({corners[0], corners[i], corners[i + 1]});
    }
    return corners.size() - 2;
}

void RawMesh::ignore(std::string_view what) {
    const bool known = std::ranges::find(notes.ignored, what) != notes.ignored.end();
    if (!known && notes.ignored.size() < longest_list_of_notes) {
        notes.ignored.emplace_back(what);
    }
}

std::string out_of_range_text(std::int64_t index, std::uint64_t vertices) {
    return fmt::format("vertex index {} is out of range ({} vertices)", index, vertices);
}

std::string refused_polygons_text(const RawMesh& mesh) {
    const auto refused = static_cast<std::size_t>(std::ranges::count_if(
        mesh.fans, [&](const PolygonFan& fan) { return !is_convex_and_planar(corner_positions(mesh, fan)); }));
    std::string text;
    if (refused > 0) {
        text = counted(refused, "polygon is not convex and planar", "polygons are not convex and planar");
    }
    if (mesh.short_faces > 0) {
        text += (text.empty() ? "" : ", ") +
                counted(mesh.short_faces, "face has fewer than three corners", "faces have fewer than three corners");
    }
    return text;
}

} // namespace foldless
