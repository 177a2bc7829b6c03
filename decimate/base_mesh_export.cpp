#include <foldless/decimate/base_mesh_export.h>

#include <foldless/decimate/patched_surface.h>

#include <algorithm>

namespace foldless {
namespace {

/// The vertices and faces that are left, in the order in which they are written.
struct Survivors {
    std::vector<std::int32_t> vertices;
    std::vector<std::int32_t> faces;
    std::vector<std::int32_t> vertex_numbers; ///< the place of each in that order, -1 for what is not left
    std::vector<std::int32_t> face_numbers;
};

/// Those of the indices that are marked with 0, in the order in which they were before; numbers them in their marks.
std::vector<std::int32_t> number(const std::vector<std::int32_t>& order, std::vector<std::int32_t>& marks) {
    std::vector<std::int32_t> result;
    for (const std::int32_t index : inverse(order)) {
        if (marks[index] == 0) {
            marks[index] = static_cast<std::int32_t>(result.size());
            result.push_back(index);
        }
    }
    return result;
}

Survivors survivors_of(const BaseSurface& surface, const LocalOrder& order) {
    Survivors left;
    left.vertex_numbers.assign(surface.vertex_slots(), -1);
    for (const auto face : surface.connectivity().faces()) {
        left.faces.push_back(face.idx());
        for (const std::int32_t v : surface.corners(face.idx())) {
            left.vertex_numbers[v] = 0;
        }
    }
    left.vertices = number(order.vertices, left.vertex_numbers);
    const auto written = [&](std::int32_t f) { return order.faces[surface.first_number(f)]; };
    std::sort(left.faces.begin(), left.faces.end(),
              [&](std::int32_t a, std::int32_t b) { return written(a) < written(b); });
    left.face_numbers.assign(surface.face_slots(), -1);
    for (std::size_t n = 0; n < left.faces.size(); ++n) {
        left.face_numbers[left.faces[n]] = static_cast<std::int32_t>(n);
    }
    return left;
}

void export_vertices(const BaseSurface& surface, const Survivors& left, const LocalOrder& order, BaseMesh& base) {
    for (const std::int32_t v : left.vertices) {
        const BaseVertex vertex = surface.vertex(v);
        base.positions.push_back(vertex.position);
        base.scan_vertex.push_back(vertex.scan_vertex < 0 ? -1 : order.vertices[vertex.scan_vertex]);
        base.directions.push_back(vertex.direction);
    }
}

void export_faces(const BaseSurface& surface, const Survivors& left, BaseMesh& base) {
    for (const std::int32_t f : left.faces) {
        const Triangle corners = surface.corners(f);
        base.faces.push_back(
            {left.vertex_numbers[corners[0]], left.vertex_numbers[corners[1]], left.vertex_numbers[corners[2]]});
        base.ranges.push_back(surface.face(f).range);
    }
}

/// One direction for each face in the place of those of the vertices.
void export_face_directions(const BaseSurface& surface, const Survivors& left, BaseMesh& base) {
    base.directions.clear();
    for (const std::int32_t f : left.faces) {
        const Triangle corners = surface.corners(f);
        base.face_directions.push_back(
            face_direction({surface.vertex(corners[0]).position, surface.vertex(corners[1]).position,
                            surface.vertex(corners[2]).position}));
    }
}

void export_places(const BaseSurface& surface, const Survivors& left, const LocalOrder& order,
                   Correspondence& correspondence) {
    const std::size_t count = surface.vertex_slots();
    correspondence.base_face.assign(count, -1);
    correspondence.alpha.assign(count, Vec3::Zero());
    correspondence.t.assign(count, 0.0);
    const auto written_first = [&](std::int32_t a, std::int32_t b) {
        return left.face_numbers[a] < left.face_numbers[b];
    };
    std::vector<std::int32_t> around;
    for (std::size_t v = 0; v < count; ++v) {
        const Place place = surface.place(static_cast<std::int32_t>(v));
        std::int32_t face = place.face;
        Vec3 alpha = place.alpha;
        if (place.kept >= 0) {
            around.clear();
            surface.append_faces_around(place.kept, around);
            if (around.empty()) {
                continue; // no face uses it
            }
            face = *std::min_element(around.begin(), around.end(), written_first);
            const Triangle corners = surface.corners(face);
            alpha = Vec3::Unit(std::find(corners.begin(), corners.end(), place.kept) - corners.begin());
        }
        const std::int32_t before = order.vertices[v];
        correspondence.base_face[before] = left.face_numbers[face];
        correspondence.alpha[before] = alpha;
        correspondence.t[before] = place.t;
    }
}

} // namespace

ExportedMesh export_base_mesh(const BaseSurface& surface, const LocalOrder& order, bool constant_directions,
                              bool float32) {
    const Survivors left = survivors_of(surface, order);
    ExportedMesh result;
    result.base.float32 = float32;
    export_vertices(surface, left, order, result.base);
    export_faces(surface, left, result.base);
    if (constant_directions) {
        export_face_directions(surface, left, result.base);
    }
    export_places(surface, left, order, result.correspondence);
    return result;
}

} // namespace foldless
