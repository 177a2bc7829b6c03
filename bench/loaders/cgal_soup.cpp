#include "loader.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

bool load(const std::string& path, ListedMesh& mesh) {
    std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
    std::vector<std::vector<std::size_t>> faces;
    if (!CGAL::IO::read_polygon_soup(path, points, faces)) {
        return false;
    }
    for (const auto& point : points) {
        mesh.points.push_back({point.x(), point.y(), point.z()});
    }
    for (const auto& face : faces) {
        mesh.faces.emplace_back(face.begin(), face.end());
    }
    return true;
}
