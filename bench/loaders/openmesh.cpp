#include "loader.h"

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
};

using Mesh = OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>;

} // namespace

bool load(const std::string& path, ListedMesh& mesh) {
    Mesh read;
    if (!OpenMesh::IO::read_mesh(read, path)) {
        return false;
    }
    for (const auto vertex : read.vertices()) {
        const auto& point = read.point(vertex);
        mesh.points.push_back({point[0], point[1], point[2]});
    }
    for (const auto face : read.faces()) {
        auto& corners = mesh.faces.emplace_back();
        for (const auto vertex : read.fv_range(face)) {
            corners.push_back(vertex.idx());
        }
    }
    return true;
}
