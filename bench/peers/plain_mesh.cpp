#include "plain_mesh.h"

#include <bit>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>

static_assert(std::endian::native == std::endian::little, "files are read and written as they lie in memory");

namespace {

struct Header {
    std::size_t vertices = 0;
    std::size_t faces = 0;
    bool is_double = false;
};

// The lines of the header but those that say nothing about the layout.
std::vector<std::string> layout_lines(std::istream& file) {
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line) && line != "end_header";) {
        if (!line.starts_with("comment") && !line.starts_with("obj_info")) {
            lines.push_back(line);
        }
    }
    return lines;
}

std::size_t count_of(const std::string& line, std::string_view element) {
    std::istringstream words(line);
    std::string keyword;
    std::string name;
    std::size_t count = 0;
    if (!(words >> keyword >> name >> count) || keyword != "element" || name != element) {
        throw std::runtime_error("not a plain PLY: \"" + line + "\" in place of its number of elements");
    }
    return count;
}

Header read_header(std::istream& file) {
    constexpr std::size_t plain_lines = 8;
    const std::vector<std::string> lines = layout_lines(file);
    if (lines.size() != plain_lines) {
        throw std::runtime_error("not a plain PLY: its header has other lines than positions and triangles");
    }
    Header header{count_of(lines[2], "vertex"), count_of(lines[6], "face"), lines[3] == "property double x"};
    const std::string type = header.is_double ? "property double " : "property float ";
    const bool list =
        lines[7] == "property list uchar int vertex_indices" || lines[7] == "property list uchar uint vertex_indices";
    if (lines[0] != "ply" || lines[1] != "format binary_little_endian 1.0" || lines[3] != type + "x" ||
        lines[4] != type + "y" || lines[5] != type + "z" || !list) {
        throw std::runtime_error("not a plain PLY: binary little endian, x y z, and triangles");
    }
    return header;
}

// Takes values from the bytes after the header.
class Body {
public:
    Body(std::istream& file, std::size_t size) : bytes_(size) {
        if (!file.read(bytes_.data(), static_cast<std::streamsize>(size))) {
            throw std::runtime_error("the file is too short");
        }
    }

    template <typename Value>
    Value take() {
        Value value;
        std::memcpy(&value, bytes_.data() + place_, sizeof value);
        place_ += sizeof value;
        return value;
    }

private:
    std::vector<char> bytes_;
    std::size_t place_ = 0;
};

template <typename Coordinate>
std::vector<std::array<float, 3>> read_points(std::istream& file, std::size_t count) {
    Body body(file, count * 3 * sizeof(Coordinate));
    std::vector<std::array<float, 3>> points(count);
    for (auto& point : points) {
        for (float& coordinate : point) {
            coordinate = static_cast<float>(body.take<Coordinate>());
        }
    }
    return points;
}

constexpr std::size_t bytes_per_triangle = 1 + 3 * sizeof(std::uint32_t);

std::vector<std::array<std::uint32_t, 3>> read_faces(std::istream& file, const Header& header) {
    Body body(file, header.faces * bytes_per_triangle);
    std::vector<std::array<std::uint32_t, 3>> faces(header.faces);
    for (auto& face : faces) {
        if (body.take<std::uint8_t>() != face.size()) {
            throw std::runtime_error("a face is no triangle");
        }
        for (std::uint32_t& corner : face) {
            corner = body.take<std::uint32_t>();
            if (corner >= header.vertices) {
                throw std::runtime_error("an index is out of range");
            }
        }
    }
    return faces;
}

} // namespace

PlainMesh read_plain_ply(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw std::runtime_error("the file cannot be opened");
    }
    const Header header = read_header(file);
    PlainMesh mesh;
    mesh.points =
        header.is_double ? read_points<double>(file, header.vertices) : read_points<float>(file, header.vertices);
    mesh.faces = read_faces(file, header);
    return mesh;
}

void write_plain_ply(const std::string& path, const PlainMesh& mesh) {
    std::ofstream file(path, std::ios::binary);
    file << "ply\nformat binary_little_endian 1.0\nelement vertex " << mesh.points.size()
         << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << mesh.faces.size()
         << "\nproperty list uchar int vertex_indices\nend_header\n";
    file.write(reinterpret_cast<const char*>(mesh.points.data()),
               static_cast<std::streamsize>(mesh.points.size() * sizeof mesh.points[0]));
    for (const auto& face : mesh.faces) {
        file.put(static_cast<char>(face.size()));
        file.write(reinterpret_cast<const char*>(face.data()), sizeof face);
    }
    if (!file.flush()) {
        throw std::runtime_error("the result cannot be written");
    }
}
