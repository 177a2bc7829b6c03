#include <foldless/tools/plain_mesh.h>

#include <utility>

namespace foldless {

BaseMesh without_directions(Scan scan) {
    BaseMesh mesh;
    mesh.positions = std::move(scan.positions);
    mesh.faces = std::move(scan.faces);
    mesh.float32 = scan.float32;
    return mesh;
}

} // namespace foldless
