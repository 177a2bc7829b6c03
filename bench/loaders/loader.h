// A program that loads a mesh with a library: `PROGRAM FILE OUTPUT` writes what the library read as a list.
#pragma once

#include <array>
#include <string>
#include <vector>

struct ListedMesh {
    std::vector<std::array<double, 3>> points;
    std::vector<std::vector<long long>> faces; // as the library has them: they may be out of range
};

// Each program has its own. False if the library says that it cannot read the file; exceptions say the same.
bool load(const std::string& path, ListedMesh& mesh);
