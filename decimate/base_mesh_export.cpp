#include <foldless/decimate/base_mesh_export.h>

#include <foldless/decimate/patched_surface.h>

#include <algorithm>

namespace foldless {
namespace {

/// New indices of the faces and vertices that are left, -1 for the others.
struct Renumbering {
    std::vector<std::int32_t> faces;
    std::vector<std::int32_t> vertices;
};

Renumbering renumber(const BaseSurface& surface) {
    Renumbering result{std::vector<std::int32_t>(surface.face_slots(), -1),
                       std::vector<std::int32_t>(surface.vertex_slots(), -1)};
    std::int32_t count = 0;
    for (const auto face : surface.connectivity().faces()) {
        result.faces[face.idx()] = count++;
        for (const std::int32_t v : surface.corners(face.idx())) {
            result.vertices[v] = 0;
        }
    }
    count = 0;
    for (std::int32_t& v : result.vertices) {
        if (v == 0) {
            v = count++;
        }
    }
    return result;
}

void export_vertices(const BaseSurface& surface, const Renumbering& numbers, bool directions, BaseMesh& base) {
    for (std::size_t v = 0; v < numbers.vertices.size(); ++v) {
        if (numbers.vertices[v] < 0) {
            continue;
        }
        const BaseVertex& vertex = surface.vertex(static_cast<std::int32_t>(v));
        base.positions.push_back(vertex.position);
        base.scan_vertex.push_back(vertex.scan_vertex);
        if (directions) {
            base.directions.push_back(vertex.direction);
        }
    }
}

void export_faces(const BaseSurface& surface, const Renumbering& numbers, bool constant_directions, BaseMesh& base) {
    for (std::size_t f = 0; f < numbers.faces.size(); ++f) {
        if (numbers.faces[f] < 0) {
            continue;
        }
        const Triangle corners = surface.corners(static_cast<std::int32_t>(f));
        base.faces.push_back(
            {numbers.vertices[corners[0]], numbers.vertices[corners[1]], numbers.vertices[corners[2]]});
        base.ranges.push_back(surface.face(static_cast<std::int32_t>(f)).range);
        if (constant_directions) {
            base.face_directions.push_back(
                face_direction({surface.vertex(corners[0]).position, surface.vertex(corners[1]).position,
                                surface.vertex(corners[2]).position}));
        }
    }
}

void export_places(const BaseSurface& surface, const Renumbering& numbers, Correspondence& correspondence) {
    const std::size_t count = surface.vertex_slots();
    correspondence.base_face.assign(count, -1);
    correspondence.alpha.assign(count, Vec3::Zero());
    correspondence.t.assign(count, 0.0);
    std::vector<std::int32_t> around;
    for (std::size_t v = 0; v < count; ++v) {
        const Place& place = surface.place(static_cast<std::int32_t>(v));
        std::int32_t face = place.face;
        Vec3 alpha = place.alpha;
        if (place.kept >= 0) {
            surface.faces_around(place.kept, around);
            if (around.empty()) {
                continue; // no face uses it
            }
            face = *std::min_element(around.begin(), around.end());
            const Triangle corners = surface.corners(face);
            alpha = Vec3::Unit(std::find(corners.begin(), corners.end(), place.kept) - corners.begin());
        }
        correspondence.base_face[v] = numbers.faces[face];
        correspondence.alpha[v] = alpha;
        correspondence.t[v] = place.t;
    }
}

} // namespace

void export_base_mesh(const BaseSurface& surface, const Scan& scan, bool constant_directions, BaseMesh& base,
                      Correspondence& correspondence) {
    const Renumbering numbers = renumber(surface);
    base = {};
    base.float32 = scan.float32;
    export_vertices(surface, numbers, !constant_directions, base);
    export_faces(surface, numbers, constant_directions, base);
    export_places(surface, numbers, correspondence);
}

} // namespace foldless
