#include <foldless/models/stream_ply.h>

#include <foldless/io/atomic_file.h>

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace foldless {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

std::string header_of(const Model& model, const std::vector<std::string>& comments) {
    std::string header = "ply\nformat binary_little_endian 1.0\n";
    for (const std::string& comment : comments) {
        header += fmt::format("comment {}\n", comment);
    }
    const std::string_view type = model.float32() ? "float" : "double";
    header += fmt::format("element vertex {}\n", model.vertices());
    for (const char axis : {'x', 'y', 'z'}) {
        header += fmt::format("property {} {}\n", type, axis);
    }
    header += fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n", model.faces());
    return header;
}

template <typename Coordinate>
void write_vertices(AtomicFile& file, const Model& model) {
    std::array<char, 3 * sizeof(Coordinate)> record{};
    for (std::int64_t vertex = 0; vertex < model.vertices(); ++vertex) {
        const Eigen::Matrix<Coordinate, 3, 1> position = model.position(vertex).cast<Coordinate>();
        std::memcpy(record.data(), position.data(), record.size());
        file.write({record.data(), record.size()});
    }
}

void write_faces(AtomicFile& file, const Model& model) {
    std::array<char, 1 + sizeof(Triangle)> record{3}; // the number of corners, then the corners
    for (std::int64_t face = 0; face < model.faces(); ++face) {
        const Triangle triangle = model.triangle(face);
        std::memcpy(record.data() + 1, triangle.data(), sizeof triangle);
        file.write({record.data(), record.size()});
    }
}

} // namespace

void stream_ply(const std::filesystem::path& path, const Model& model, const std::vector<std::string>& comments) {
    AtomicFile file(path);
    file.write(header_of(model, comments));
    if (model.float32()) {
        write_vertices<float>(file, model);
    } else {
        write_vertices<double>(file, model);
    }
    write_faces(file, model);
    file.commit();
}

} // namespace foldless
