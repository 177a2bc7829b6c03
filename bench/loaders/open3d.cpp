#include "loader.h"

#include <open3d/geometry/TriangleMesh.h>
#include <open3d/io/TriangleMeshIO.h>

bool load(const std::string& path, ListedMesh& mesh) {
    open3d::geometry::TriangleMesh read;
    open3d::io::ReadTriangleMeshOptions options;
    options.enable_post_processing = false;
    if (!open3d::io::ReadTriangleMesh(path, read, options)) {
        return false;
    }
    for (const Eigen::Vector3d& point : read.vertices_) {
        mesh.points.push_back({point.x(), point.y(), point.z()});
    }
    for (const Eigen::Vector3i& face : read.triangles_) {
        mesh.faces.push_back({face[0], face[1], face[2]});
    }
    return true;
}
