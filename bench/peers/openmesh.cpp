// OpenMesh's DecimaterT with its default traits (float): the error quadrics without a bound give the order. With
// HAUSDORFF a collapse is refused, too, that moves the surface further than 1 % of the diagonal. Borders are decimated,
// too.

#include "peer.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModHausdorffT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include <stdexcept>

namespace {

struct Traits : OpenMesh::DefaultTraits {
    VertexAttributes(OpenMesh::Attributes::Status);
    EdgeAttributes(OpenMesh::Attributes::Status);
    FaceAttributes(OpenMesh::Attributes::Status);
    HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge | OpenMesh::Attributes::Status);
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;
using Decimater = OpenMesh::Decimater::DecimaterT<Mesh>;

#ifdef HAUSDORFF
constexpr float share_of_diagonal = 0.01F;

float diagonal_of(const Mesh& mesh) {
    Mesh::Point low = mesh.point(OpenMesh::VertexHandle(0));
    Mesh::Point high = low;
    for (const auto vertex : mesh.vertices()) {
        low.minimize(mesh.point(vertex));
        high.maximize(mesh.point(vertex));
    }
    return (high - low).norm();
}
#endif

class OpenMeshPeer : public Peer {
public:
    explicit OpenMeshPeer(const PlainMesh& scan) {
        mesh_.reserve(scan.points.size(), scan.points.size() + scan.faces.size(), scan.faces.size());
        for (const auto& [x, y, z] : scan.points) {
            mesh_.add_vertex({x, y, z});
        }
        for (const auto& [a, b, c] : scan.faces) {
            if (!mesh_
                     .add_face(OpenMesh::VertexHandle(static_cast<int>(a)), OpenMesh::VertexHandle(static_cast<int>(b)),
                               OpenMesh::VertexHandle(static_cast<int>(c)))
                     .is_valid()) {
                throw std::runtime_error("OpenMesh refuses a face");
            }
        }
    }

    void decimate(std::size_t faces) override {
        Decimater decimater(mesh_);
        OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadrics;
        decimater.add(quadrics);
        decimater.module(quadrics).unset_max_err();
#ifdef HAUSDORFF
        OpenMesh::Decimater::ModHausdorffT<Mesh>::Handle hausdorff;
        decimater.add(hausdorff);
        decimater.module(hausdorff).set_tolerance(share_of_diagonal * diagonal_of(mesh_));
#endif
        if (!decimater.initialize()) {
            throw std::runtime_error("OpenMesh does not take these modules");
        }
        decimater.decimate_to_faces(0, faces);
    }

    PlainMesh result() const override {
        PlainMesh plain;
        std::vector<std::uint32_t> number(mesh_.n_vertices());
        for (const auto vertex : mesh_.vertices()) { // not those that are deleted
            const auto& point = mesh_.point(vertex);
            number[static_cast<std::size_t>(vertex.idx())] = static_cast<std::uint32_t>(plain.points.size());
            plain.points.push_back({point[0], point[1], point[2]});
        }
        for (const auto face : mesh_.faces()) {
            auto& corners = plain.faces.emplace_back();
            std::size_t k = 0;
            for (const auto vertex : mesh_.fv_range(face)) {
                corners[k++] = number[static_cast<std::size_t>(vertex.idx())];
            }
        }
        return plain;
    }

private:
    Mesh mesh_;
};

} // namespace

std::unique_ptr<Peer> make_peer(const PlainMesh& scan) {
    return std::make_unique<OpenMeshPeer>(scan);
}
