#include "loader.h"

#include <cstdio>
#include <exception>
#include <new>

namespace {

// The codes of foldless.
constexpr int read_code = 0;
constexpr int wrong_usage = 2;
constexpr int refused = 3;
constexpr int not_written = 5;
constexpr int out_of_memory = 7;

// No file of the table holds as much: of a mesh that has more the counts are told alone.
constexpr std::size_t most_elements = 1000000;

void write_rows(std::FILE* output, const ListedMesh& mesh) {
    for (const auto& [x, y, z] : mesh.points) {
        std::fprintf(output, "%.17g %.17g %.17g\n", x, y, z);
    }
    for (const auto& face : mesh.faces) {
        for (const long long corner : face) {
            std::fprintf(output, "%lld ", corner);
        }
        std::fprintf(output, "\n");
    }
}

bool write(const char* path, const ListedMesh& mesh) {
    std::FILE* const output = std::fopen(path, "w");
    if (output == nullptr) {
        return false;
    }
    std::fprintf(output, "%zu %zu\n", mesh.points.size(), mesh.faces.size());
    if (mesh.points.size() <= most_elements && mesh.faces.size() <= most_elements) {
        write_rows(output, mesh);
    }
    return std::fclose(output) == 0;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: %s FILE OUTPUT\n", argv[0]);
        return wrong_usage;
    }
    try {
        ListedMesh mesh;
        if (!load(argv[1], mesh)) {
            return refused;
        }
        return write(argv[2], mesh) ? read_code : not_written;
    } catch (const std::bad_alloc&) {
        return out_of_memory;
    } catch (const std::exception&) {
        return refused;
    }
}
