#include "cgal_base.h"

#include "unguarded_base.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Constrained_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <vector>

namespace foldless::test {
namespace {

namespace simplification = CGAL::Surface_mesh_simplification;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Edge = Mesh::Edge_index;
using IsConstrained = Mesh::Property_map<Edge, bool>;
using Placement = simplification::Constrained_placement<simplification::LindstromTurk_placement<Mesh>, IsConstrained>;

Mesh mesh_of(const Scan& scan) {
    Mesh mesh;
    for (const Vec3& p : scan.positions) {
        mesh.add_vertex({p.x(), p.y(), p.z()});
    }
    for (const Triangle& face : scan.faces) {
        mesh.add_face(Mesh::Vertex_index(face[0]), Mesh::Vertex_index(face[1]), Mesh::Vertex_index(face[2]));
    }
    return mesh;
}

/// Collapses edges until two for each three faces are left, border edges never.
void decimate(Mesh& mesh, std::size_t faces) {
    const IsConstrained is_constrained = mesh.add_property_map<Edge, bool>("e:is_constrained", false).first;
    for (const Edge edge : mesh.edges()) {
        is_constrained[edge] = mesh.is_border(edge);
    }
    simplification::edge_collapse(
        mesh, simplification::Count_stop_predicate<Mesh>(faces * 3 / 2),
        CGAL::parameters::edge_is_constrained_map(is_constrained).get_placement(Placement(is_constrained)));
}

Vec3 position_of(const Mesh& mesh, Mesh::Vertex_index vertex) {
    const auto& p = mesh.point(vertex);
    return {p.x(), p.y(), p.z()};
}

} // namespace

BaseMesh cgal_base(const Scan& scan, std::size_t faces, Random& random) {
    Mesh mesh = mesh_of(scan);
    decimate(mesh, faces);
    BaseMesh base;
    base.float32 = scan.float32;
    std::vector<std::int32_t> number(scan.positions.size(), -1);
    for (const Mesh::Vertex_index vertex : mesh.vertices()) { // not those that are removed
        if (mesh.is_isolated(vertex)) {
            continue;
        }
        const Vec3 position = position_of(mesh, vertex);
        const bool is_kept = position == scan.positions[vertex.idx()];
        number[vertex.idx()] = static_cast<std::int32_t>(base.positions.size());
        base.positions.push_back(base.float32 ? to_float32(position) : position);
        base.scan_vertex.push_back(is_kept ? static_cast<std::int32_t>(vertex.idx()) : -1);
    }
    for (const Mesh::Face_index face : mesh.faces()) {
        const auto halfedge = mesh.halfedge(face);
        base.faces.push_back({number[mesh.source(halfedge).idx()], number[mesh.target(halfedge).idx()],
                              number[mesh.target(mesh.next(halfedge)).idx()]});
    }
    add_displacements(base, scan, random);
    return base;
}

} // namespace foldless::test
