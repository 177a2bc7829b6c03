#include "openmesh_base.h"

#include "unguarded_base.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include <vector>

namespace foldless::test {
namespace {

struct Traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
    VertexAttributes(OpenMesh::Attributes::Status);
    EdgeAttributes(OpenMesh::Attributes::Status);
    FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
    HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge | OpenMesh::Attributes::Status);
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

Mesh mesh_of(const Scan& scan) {
    Mesh mesh;
    for (const Vec3& p : scan.positions) {
        mesh.add_vertex({p.x(), p.y(), p.z()});
    }
    for (const Triangle& face : scan.faces) {
        mesh.add_face(OpenMesh::VertexHandle(face[0]), OpenMesh::VertexHandle(face[1]),
                      OpenMesh::VertexHandle(face[2]));
    }
    for (const auto vertex : mesh.vertices()) {
        mesh.status(vertex).set_locked(mesh.is_boundary(vertex));
    }
    return mesh;
}

void decimate_by_quadrics(Mesh& mesh, std::size_t faces) {
    OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
    OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadrics;
    decimater.add(quadrics);
    decimater.module(quadrics).unset_max_err();
    decimater.initialize();
    decimater.decimate_to_faces(0, faces);
}

} // namespace

BaseMesh openmesh_base(const Scan& scan, std::size_t faces, Random& random) {
    Mesh mesh = mesh_of(scan);
    decimate_by_quadrics(mesh, faces);
    BaseMesh base;
    base.float32 = scan.float32;
    // A collapse moves no vertex, so that those that are left are scan vertices of the same number.
    std::vector<std::int32_t> number(scan.positions.size(), -1);
    for (const auto vertex : mesh.vertices()) { // not those that are deleted
        if (!mesh.is_isolated(vertex)) {
            number[vertex.idx()] = static_cast<std::int32_t>(base.positions.size());
            base.positions.push_back(scan.positions[vertex.idx()]);
            base.scan_vertex.push_back(vertex.idx());
        }
    }
    for (const auto face : mesh.faces()) {
        Triangle corners;
        int k = 0;
        for (const auto vertex : mesh.fv_range(face)) {
            corners[k++] = number[vertex.idx()];
        }
        base.faces.push_back(corners);
    }
    add_displacements(base, scan, random);
    return base;
}

} // namespace foldless::test
