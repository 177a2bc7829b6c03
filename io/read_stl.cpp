#include <foldless/io/read_stl.h>

#include <foldless/io/byte_order.h>
#include <foldless/io/errors.h>
#include <foldless/io/numbers.h>
#include <foldless/io/printable.h>
#include <foldless/io/text_cursor.h>
#include <foldless/io/weld.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <utility>

namespace foldless {

namespace {

// A binary file: a header of 80 bytes, a count, and per triangle a normal, three corners and an attribute of 2 bytes.
constexpr std::size_t header_size = 80;
constexpr std::size_t data_start = header_size + sizeof(std::uint32_t);
constexpr std::size_t vector_size = 3 * sizeof(float);
constexpr std::size_t triangle_size = 4 * vector_size + sizeof(std::uint16_t);

std::uint64_t binary_size(std::string_view bytes) {
    const auto count = load<std::uint32_t>(bytes.data() + header_size, std::endian::little);
    return data_start + std::uint64_t{count} * triangle_size;
}

bool is_binary(std::string_view bytes) {
    return bytes.size() >= data_start && binary_size(bytes) == bytes.size();
}

bool is_word(std::string_view token, std::string_view word) {
    return std::ranges::equal(
        token, word, [](char a, char b) { return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b; });
}

bool starts_like_text(std::string_view bytes) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (bytes.starts_with(byte_order_mark)) {
        bytes.remove_prefix(byte_order_mark.size());
    }
    constexpr std::string_view solid = "solid";
    const std::size_t start = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
    return is_word(bytes.substr(start, solid.size()), solid);
}

Vec3 load_vector(const char* bytes) {
    constexpr std::endian order = std::endian::little;
    return {load<float>(bytes, order), load<float>(bytes + sizeof(float), order),
            load<float>(bytes + 2 * sizeof(float), order)};
}

std::vector<Vec3> read_binary_corners(std::string_view bytes) {
    std::vector<Vec3> corners;
    corners.reserve((bytes.size() - data_start) / triangle_size * 3);
    for (std::size_t at = data_start; at < bytes.size(); at += triangle_size) {
        for (std::size_t i = 1; i <= 3; ++i) {
            corners.push_back(load_vector(bytes.data() + at + i * vector_size));
        }
    }
    return corners;
}

class AsciiReader {
public:
    AsciiReader(std::string_view text, const std::string& name) : cursor_(text, name, {}) {}

    std::vector<Vec3> read_corners() {
        bool open = false;
        for (std::string_view word = cursor_.token_of_any_line(); !word.empty(); word = cursor_.token_of_any_line()) {
            if (is_word(word, "facet") && open) {
                read_facet();
            } else if (is_word(word, open ? "endsolid" : "solid")) {
                open = !open;
                cursor_.skip_line();
            } else {
                fail_for(open ? "facet' or 'endsolid" : "solid", word);
            }
        }
        if (open) {
            cursor_.fail("the file ends before 'endsolid'");
        }
        return std::move(corners_);
    }

private:
    void read_facet() {
        require("normal");
        static_cast<void>(read_vector());
        require("outer");
        require("loop");
        for (int i = 0; i < 3; ++i) {
            require("vertex");
            corners_.push_back(read_vector());
        }
        require("endloop");
        require("endfacet");
    }

    Vec3 read_vector() {
        const double x = read_number("x");
        const double y = read_number("y");
        const double z = read_number("z");
        return {x, y, z};
    }

    /// Numbers may stand on lines of their own.
    double read_number(std::string_view what) {
        const std::size_t line = cursor_.line();
        if (cursor_.peek().empty() && !(cursor_.next_line() && parse_double(cursor_.peek()).ok())) {
            cursor_.fail_at(line, fmt::format("{} is missing", what));
        }
        return cursor_.real(what);
    }

    void require(std::string_view word) {
        const std::string_view found = cursor_.token_of_any_line();
        if (!is_word(found, word)) {
            fail_for(word, found);
        }
    }

    [[noreturn]] void fail_for(std::string_view word, std::string_view found) const {
        if (found.empty()) {
            cursor_.fail(fmt::format("the file ends where '{}' should stand", word));
        }
        cursor_.fail(fmt::format("{} stands where '{}' should stand", in_quotes(found), word));
    }

    TextCursor cursor_;
    std::vector<Vec3> corners_;
};

[[noreturn]] void fail_for_size(std::string_view bytes, const std::string& name) {
    if (bytes.size() < data_start) {
        throw UnreadableFile(fmt::format("{}: byte {}: neither ascii STL nor the {} bytes of a binary header", name,
                                         bytes.size(), data_start));
    }
    throw UnreadableFile(fmt::format("{}: byte {}: {} triangles take {} bytes, but the file has {}", name, header_size,
                                     (binary_size(bytes) - data_start) / triangle_size, binary_size(bytes),
                                     bytes.size()));
}

RawMesh welded_mesh(const std::vector<Vec3>& corners, const std::string& name) {
    RawMesh mesh;
    const std::size_t count = corners.size();
    if (count > max_vertices) {
        throw UnreadableFile(fmt::format("{}: {} triangles are too many", name, count / 3));
    }
    Welded welded = weld(corners);
    mesh.positions = std::move(welded.positions);
    mesh.faces.reserve(count / 3);
    for (std::size_t i = 0; i < count; i += 3) {
        mesh.faces.push_back({welded.indices[i], welded.indices[i + 1], welded.indices[i + 2]});
    }
    mesh.ignore("normals");
    mesh.notes.welded_vertices = count - mesh.positions.size();
    return mesh;
}

} // namespace

RawMesh read_stl(std::string_view bytes, const std::string& name) {
    if (is_binary(bytes)) {
        return welded_mesh(read_binary_corners(bytes), name);
    }
    if (!starts_like_text(bytes)) {
        fail_for_size(bytes, name);
    }
    return welded_mesh(AsciiReader(bytes, name).read_corners(), name);
}

} // namespace foldless
