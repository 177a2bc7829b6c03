#include "loader.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

bool load(const std::string& path, ListedMesh& mesh) {
    CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> read;
    if (!CGAL::IO::read_polygon_mesh(path, read)) {
        return false;
    }
    for (const auto vertex : read.vertices()) {
        const auto& point = read.point(vertex);
        mesh.points.push_back({point.x(), point.y(), point.z()});
    }
    for (const auto face : read.faces()) {
        auto& corners = mesh.faces.emplace_back();
        for (const auto vertex : read.vertices_around_face(read.halfedge(face))) {
            corners.push_back(vertex.idx());
        }
    }
    return true;
}
