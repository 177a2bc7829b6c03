// A program that links the decimator and nothing that judges it.
#include <foldless/decimate/decimate.h>

int main() {
    const foldless::Scan tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                     {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    return foldless::decimate(tetrahedron).base.faces.size() == tetrahedron.faces.size() ? 0 : 1;
}
