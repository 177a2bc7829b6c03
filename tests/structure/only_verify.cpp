// A program that links the verifier and nothing of what it judges.
#include <foldless/verify/verify.h>

int main() {
    const foldless::Scan tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                     {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    foldless::BaseMesh itself;
    itself.positions = tetrahedron.positions;
    itself.directions = {{-1, -1, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    itself.scan_vertex = {0, 1, 2, 3};
    itself.faces = tetrahedron.faces;
    itself.ranges.assign(4, {0, 0});
    return foldless::verify(itself, tetrahedron).certified() ? 0 : 1;
}
