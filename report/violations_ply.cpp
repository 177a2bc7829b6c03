#include <foldless/report/violations_ply.h>

#include <foldless/report/version.h>

#include <fmt/format.h>

#include <vector>

namespace foldless {

namespace {

// Red, orange and blue.
constexpr const char* position_colour = "230 25 25";
constexpr const char* scan_colour = "255 165 0";
constexpr const char* base_colour = "30 90 255";

/// The elements in the making. No vertex is shared, so that each has one colour and one violation.
class Elements {
public:
    void add(const LocatedViolation& found, const BaseMesh& base, const Scan& scan);
    [[nodiscard]] std::string vertex_element() const;
    [[nodiscard]] std::string face_element() const;
    [[nodiscard]] std::string data() const { return vertices_ + faces_; }

private:
    void add_point(const Vec3& position, const char* colour, Violation violation);
    void add_face(const Triangle& corners, const std::vector<Vec3>& positions, const char* colour, Violation violation);

    std::string vertices_;
    std::string faces_;
    std::size_t vertex_count_ = 0;
    std::size_t face_count_ = 0;
};

void Elements::add_point(const Vec3& position, const char* colour, Violation violation) {
    vertices_ +=
        fmt::format("{} {} {} {} {}\n", position.x(), position.y(), position.z(), colour, static_cast<int>(violation));
    ++vertex_count_;
}

void Elements::add_face(const Triangle& corners, const std::vector<Vec3>& positions, const char* colour,
                        Violation violation) {
    const std::size_t first = vertex_count_;
    for (const std::int32_t corner : corners) {
        add_point(positions[corner], colour, violation);
    }
    faces_ += fmt::format("3 {} {} {} {}\n", first, first + 1, first + 2, static_cast<int>(violation));
    ++face_count_;
}

void Elements::add(const LocatedViolation& found, const BaseMesh& base, const Scan& scan) {
    if (found.violation == Violation::topology) {
        return;
    }
    add_point(found.position, position_colour, found.violation);
    if (found.scan_face >= 0) {
        add_face(scan.faces[found.scan_face], scan.positions, scan_colour, found.violation);
    }
    if (found.base_face >= 0) {
        add_face(base.faces[found.base_face], base.positions, base_colour, found.violation);
    }
}

std::string Elements::vertex_element() const {
    return fmt::format("element vertex {}\n"
                       "property double x\nproperty double y\nproperty double z\n"
                       "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                       "property int violation\n",
                       vertex_count_);
}

std::string Elements::face_element() const {
    return fmt::format("element face {}\nproperty list uchar int vertex_indices\nproperty int violation\n",
                       face_count_);
}

/// The names of the numbers that stand for violations, of those that were found.
std::string comments(const VerifyResult& result) {
    std::string text = fmt::format("comment foldless {}\n", version());
    for (std::size_t i = 0; i < violation_count; ++i) {
        if (result.violations[i] > 0) {
            text += fmt::format("comment violation {} {}\n", i, name(static_cast<Violation>(i)));
        }
    }
    return text;
}

} // namespace

std::string violations_ply(const VerifyResult& result, const BaseMesh& base, const Scan& scan) {
    Elements elements;
    for (const LocatedViolation& found : result.located) {
        elements.add(found, base, scan);
    }
    return "ply\nformat ascii 1.0\n" + comments(result) + elements.vertex_element() + elements.face_element() +
           "end_header\n" + elements.data();
}

} // namespace foldless
