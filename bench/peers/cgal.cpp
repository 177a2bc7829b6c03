// CGAL's Surface_mesh_simplification, as in its examples: Simple_cartesian<double>, Surface_mesh, no filter, no
// constraint, so that borders are decimated, too. Its own stop predicates count edges; this one counts faces.

#include "peer.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#ifdef EDGE_LENGTH
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#else
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#endif
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <stdexcept>
#include <vector>

namespace {

namespace simplification = CGAL::Surface_mesh_simplification;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
#ifdef EDGE_LENGTH
using Cost = simplification::Edge_length_cost<Mesh>;
using Placement = simplification::Midpoint_placement<Mesh>;
#else
using Cost = simplification::LindstromTurk_cost<Mesh>;
using Placement = simplification::LindstromTurk_placement<Mesh>;
#endif

struct FaceCount {
    std::size_t faces;

    template <typename Value, typename Profile>
    bool operator()(const Value& /*cost*/, const Profile& profile, std::size_t /*edges at the start*/,
                    std::size_t /*edges*/) const {
        return profile.surface_mesh().number_of_faces() <= faces;
    }
};

class Cgal : public Peer {
public:
    explicit Cgal(const PlainMesh& scan) {
        const auto vertices = static_cast<Mesh::size_type>(scan.points.size());
        const auto faces = static_cast<Mesh::size_type>(scan.faces.size());
        mesh_.reserve(vertices, vertices + faces, faces);
        for (const auto& [x, y, z] : scan.points) {
            mesh_.add_vertex({x, y, z});
        }
        for (const auto& [a, b, c] : scan.faces) {
            if (mesh_.add_face(Mesh::Vertex_index(a), Mesh::Vertex_index(b), Mesh::Vertex_index(c)) ==
                Mesh::null_face()) {
                throw std::runtime_error("CGAL refuses a face");
            }
        }
    }

    void decimate(std::size_t faces) override {
        simplification::edge_collapse(mesh_, FaceCount{faces},
                                      CGAL::parameters::get_cost(Cost()).get_placement(Placement()));
    }

    PlainMesh result() const override {
        PlainMesh plain;
        std::vector<std::uint32_t> number(mesh_.number_of_vertices() + mesh_.number_of_removed_vertices());
        for (const auto vertex : mesh_.vertices()) { // not those that are removed
            const auto& point = mesh_.point(vertex);
            number[vertex.idx()] = static_cast<std::uint32_t>(plain.points.size());
            plain.points.push_back(
                {static_cast<float>(point.x()), static_cast<float>(point.y()), static_cast<float>(point.z())});
        }
        for (const auto face : mesh_.faces()) {
            const auto halfedge = mesh_.halfedge(face);
            plain.faces.push_back({number[mesh_.source(halfedge).idx()], number[mesh_.target(halfedge).idx()],
                                   number[mesh_.target(mesh_.next(halfedge)).idx()]});
        }
        return plain;
    }

private:
    Mesh mesh_;
};

} // namespace

std::unique_ptr<Peer> make_peer(const PlainMesh& scan) {
    return std::make_unique<Cgal>(scan);
}
