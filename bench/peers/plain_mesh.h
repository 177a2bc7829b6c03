// A mesh as it stands in a file, and the files that the comparison needs: PLY, binary little endian.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

struct PlainMesh {
    std::vector<std::array<float, 3>> points;
    std::vector<std::array<std::uint32_t, 3>> faces;
};

// Reads vertices of x y z, all float or all double (rounded), and triangles. Throws std::runtime_error for all else:
// the peers measure decimators, not readers.
PlainMesh read_plain_ply(const std::string& path);

// Throws std::runtime_error if it cannot be written.
void write_plain_ply(const std::string& path, const PlainMesh& mesh);
