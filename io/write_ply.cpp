#include <foldless/io/write_ply.h>

#include <foldless/io/byte_order.h>
#include <foldless/io/comment_line.h>

#include <fmt/format.h>

#include <cstdint>

namespace foldless {

namespace {

constexpr std::uint8_t triangle_corners = 3;

std::string header_start(const std::vector<std::string>& comments) {
    std::string header = "ply\nformat binary_little_endian 1.0\n";
    for (const std::string& comment : comments) {
        header += "comment " + comment_line(comment) + "\n";
    }
    return header;
}

std::string position_properties(bool float32) {
    const char* type = float32 ? "float" : "double";
    return fmt::format("property {0} x\nproperty {0} y\nproperty {0} z\n", type);
}

constexpr const char* direction_properties = "property float nx\nproperty float ny\nproperty float nz\n";

std::string header(const BaseMesh& base, const std::vector<std::string>& comments) {
    std::string text = header_start(comments);
    text += fmt::format("element vertex {}\n", base.positions.size()) + position_properties(base.float32);
    text += base.directions.empty() ? "" : direction_properties;
    text += base.scan_vertex.empty() ? "" : "property int scan_vertex\n";
    text += fmt::format("element face {}\nproperty list uchar int vertex_indices\n", base.faces.size());
    text += base.ranges.empty() ? "" : "property float t_min\nproperty float t_max\n";
    text += base.face_directions.empty() ? "" : direction_properties;
    return text + "end_header\n";
}

void append(std::string& bytes, const Vec3& value, bool float32) {
    for (const double coordinate : value) {
        if (float32) {
            append_little_endian(bytes, static_cast<float>(coordinate));
        } else {
            append_little_endian(bytes, coordinate);
        }
    }
}

void append_vertex(std::string& bytes, const BaseMesh& base, std::size_t vertex) {
    append(bytes, base.positions[vertex], base.float32);
    if (!base.directions.empty()) {
        append(bytes, base.directions[vertex], true);
    }
    if (!base.scan_vertex.empty()) {
        append_little_endian(bytes, base.scan_vertex[vertex]);
    }
}

void append_face(std::string& bytes, const BaseMesh& base, std::size_t face) {
    append_little_endian(bytes, triangle_corners);
    for (const std::int32_t vertex : base.faces[face]) {
        append_little_endian(bytes, vertex);
    }
    if (!base.ranges.empty()) {
        append_little_endian(bytes, static_cast<float>(base.ranges[face].lo));
        append_little_endian(bytes, static_cast<float>(base.ranges[face].hi));
    }
    if (!base.face_directions.empty()) {
        append(bytes, base.face_directions[face], true);
    }
}

std::string header(const Scan& scan) {
    return header_start({}) + fmt::format("element vertex {}\n", scan.positions.size()) +
           position_properties(scan.float32) +
           "property int base_face\nproperty double alpha0\nproperty double alpha1\nproperty double alpha2\n"
           "property double t\nend_header\n";
}

} // namespace

void write_ply(AtomicFile& file, const BaseMesh& base, const std::vector<std::string>& comments) {
    file.write(header(base, comments));
    std::string bytes;
    for (std::size_t vertex = 0; vertex < base.positions.size(); ++vertex) {
        bytes.clear();
        append_vertex(bytes, base, vertex);
        file.write(bytes);
    }
    for (std::size_t face = 0; face < base.faces.size(); ++face) {
        bytes.clear();
        append_face(bytes, base, face);
        file.write(bytes);
    }
}

void write_ply(AtomicFile& file, const Scan& scan, const Correspondence& correspondence) {
    file.write(header(scan));
    std::string bytes;
    for (std::size_t vertex = 0; vertex < scan.positions.size(); ++vertex) {
        bytes.clear();
        append(bytes, scan.positions[vertex], scan.float32);
        append_little_endian(bytes, correspondence.base_face[vertex]);
        append(bytes, correspondence.alpha[vertex], false);
        append_little_endian(bytes, correspondence.t[vertex]);
        file.write(bytes);
    }
}

} // namespace foldless
