#include <foldless/decimate/renumbering.h>

namespace foldless {

Renumbering number_what_is_left(const OpenMesh::PolyConnectivity& mesh) {
    const auto numbers_of = [&]<class Handle>(std::size_t count, Handle /*of the kind*/) {
        return NewNumbers(count, [&](std::int32_t old) { return !mesh.status(Handle(old)).deleted(); });
    };
    return {numbers_of(mesh.n_edges(), OpenMesh::EdgeHandle()), numbers_of(mesh.n_faces(), OpenMesh::FaceHandle())};
}

} // namespace foldless
