#include <foldless/io/read_off.h>

#include <foldless/io/float32.h>
#include <foldless/io/numbers.h>
#include <foldless/io/printable.h>
#include <foldless/io/text_cursor.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace foldless {

namespace {

// The shortest lines, their ends included: "0 0 0", "0", and a face that is kept, "3 0 1 2".
constexpr std::uint64_t least_vertex_line = 6;
constexpr std::uint64_t least_face_line = 2;
constexpr std::uint64_t least_triangle_line = 8;

bool take_prefix(std::string_view& text, std::string_view prefix) {
    if (!text.starts_with(prefix)) {
        return false;
    }
    text.remove_prefix(prefix.size());
    return true;
}

// Numbers behind the position of a vertex.
constexpr std::size_t normal_size = 3;
constexpr std::size_t colour_size = 3;
constexpr std::size_t colour_size_with_alpha = 4;
constexpr std::size_t texture_size = 2;
constexpr std::size_t most_extras = normal_size + colour_size_with_alpha + texture_size;

class OffReader {
public:
    OffReader(std::string_view text, const std::string& name, Content content)
        : cursor_(text, name, {.comments = true}), content_(content) {}

    RawMesh read() {
        const std::string_view first_count = read_header();
        read_counts(first_count);
        require_space();
        read_vertices();
        read_faces();
        if (cursor_.next_line()) {
            cursor_.fail("data behind the last face");
        }
        return std::move(mesh_);
    }

private:
    /// Returns what is left of the first token, for "OFF8 6 12" is in use.
    std::string_view read_header() {
        std::string_view token = cursor_.next_line() ? cursor_.token() : std::string_view{};
        const std::string_view keyword = token;
        has_texture_coordinates_ = take_prefix(token, "ST");
        const bool has_colours = take_prefix(token, "C");
        has_normals_ = take_prefix(token, "N");
        if (has_texture_coordinates_ && content_ != Content::coloured_scan) {
            mesh_.ignore("texture coordinates");
        }
        if (has_colours && content_ != Content::coloured_scan) {
            mesh_.ignore("colours");
        }
        if (has_normals_) {
            mesh_.ignore("normals");
        }
        if (token.starts_with("4OFF") || token.starts_with("nOFF") || token.starts_with("4nOFF")) {
            cursor_.fail("only OFF of dimension three can be read");
        }
        if (!take_prefix(token, "OFF")) {
            cursor_.fail(fmt::format("an OFF file starts with 'OFF', not with {}", in_quotes(keyword)));
        }
        if (cursor_.peek() == "BINARY") {
            cursor_.fail("binary OFF cannot be read");
        }
        return token;
    }

    void read_counts(std::string_view first) {
        if (first.empty() && cursor_.peek().empty() && !cursor_.next_line()) {
            cursor_.fail("the counts are missing");
        }
        vertices_ = first.empty() ? count("the count of vertices") : joined_count(first);
        faces_ = count("the count of faces");
        if (!cursor_.peek().empty()) {
            static_cast<void>(cursor_.integer("the count of edges"));
        }
        cursor_.require_end_of_line();
    }

    std::uint64_t count(std::string_view what) {
        const std::int64_t value = cursor_.integer(what);
        if (value < 0) {
            cursor_.fail(fmt::format("{} is negative", what));
        }
        return static_cast<std::uint64_t>(value);
    }

    std::uint64_t joined_count(std::string_view text) {
        const auto parsed = parse_integer(text);
        if (!parsed.ok() || parsed.value < 0) {
            cursor_.fail(fmt::format("{} for the count of vertices is not a number", in_quotes(text)));
        }
        return static_cast<std::uint64_t>(parsed.value);
    }

    /// Before anything is reserved: the lines must fit into what is left of the file, where the last needs no end.
    void require_space() {
        const std::uint64_t space = cursor_.bytes_left() + 1;
        const bool vertices_fit = vertices_ <= space / least_vertex_line;
        if (!vertices_fit || faces_ > (space - vertices_ * least_vertex_line) / least_face_line) {
            cursor_.fail(fmt::format("{} vertices and {} faces do not fit into the {} bytes that are left", vertices_,
                                     faces_, cursor_.bytes_left()));
        }
        if (vertices_ > max_vertices || faces_ > max_faces) {
            cursor_.fail("the vertices or faces are too many");
        }
    }

    void begin_line(std::string_view what, std::uint64_t index, std::uint64_t count) {
        if (!cursor_.next_line()) {
            cursor_.fail(fmt::format("the file ends after {} of {} {}", index, count, what));
        }
    }

    void read_vertices() {
        mesh_.positions.reserve(vertices_);
        for (std::uint64_t i = 0; i < vertices_; ++i) {
            begin_line("vertices", i, vertices_);
            const double x = cursor_.real("x");
            const double y = cursor_.real("y");
            const double z = cursor_.real("z");
            mesh_.positions.emplace_back(x, y, z);
            if (content_ == Content::coloured_scan) {
                read_extras();
            } else {
                skip_numbers();
            }
        }
    }

    /// What follows on the line: colours, unless the header says what else.
    void skip_numbers() {
        while (!cursor_.peek().empty()) {
            static_cast<void>(cursor_.real("a colour"));
            if (content_ == Content::coloured_scan) {
                mesh_.ignore("face colours");
            } else if (mesh_.notes.ignored.empty()) {
                mesh_.ignore("colours");
            }
        }
    }

    /// The same, kept. The count of numbers tells whether there is a colour, and whether that has an alpha.
    void read_extras() {
        extras_.clear();
        while (!cursor_.peek().empty()) {
            const double value = cursor_.real("a colour");
            if (extras_.size() <= most_extras) { // one more than fits, so that it fits nowhere
                extras_.push_back(value);
            }
        }
        const std::size_t before = has_normals_ ? normal_size : 0;
        const std::size_t behind = has_texture_coordinates_ ? texture_size : 0;
        const std::size_t colour = extras_.size() - std::min(extras_.size(), before + behind);
        if (colour == colour_size || colour == colour_size_with_alpha) {
            mesh_.appearance.colours.emplace_back(extra(before), extra(before + 1), extra(before + 2));
        } else if (colour > 0) {
            mesh_.ignore("colours");
        }
        if (colour == colour_size_with_alpha) {
            mesh_.ignore("alpha");
        }
        if (has_texture_coordinates_ && extras_.size() >= before + behind) {
            mesh_.appearance.vertex_texture_coordinates.emplace_back(extra(extras_.size() - 2),
                                                                     extra(extras_.size() - 1));
        }
    }

    float extra(std::size_t at) {
        const double rounded = to_float32(extras_[at]);
        if (!std::isfinite(rounded)) {
            cursor_.fail("a colour or texture coordinate is not a finite number");
        }
        return static_cast<float>(rounded);
    }

    void read_faces() {
        mesh_.faces.reserve(std::min(faces_, cursor_.bytes_left() / least_triangle_line + 1));
        for (std::uint64_t i = 0; i < faces_; ++i) {
            begin_line("faces", i, faces_);
            read_corners();
            mesh_.add_polygon(corners_);
            skip_numbers();
        }
        if (mesh_.faces.size() > max_faces) {
            cursor_.fail("the faces are too many");
        }
    }

    void read_corners() {
        corners_.clear();
        const std::uint64_t length = count("the length of a face");
        for (std::uint64_t i = 0; i < length; ++i) {
            const std::int64_t index = cursor_.integer("a vertex index");
            if (static_cast<std::uint64_t>(index) >= vertices_) { // negative ones too, which become huge
                cursor_.fail(out_of_range_text(index, vertices_));
            }
            corners_.push_back(static_cast<std::int32_t>(index));
        }
    }

    TextCursor cursor_;
    Content content_;
    RawMesh mesh_;
    bool has_texture_coordinates_ = false;
    bool has_normals_ = false;
    std::uint64_t vertices_ = 0;
    std::uint64_t faces_ = 0;
    std::vector<std::int32_t> corners_;
    std::vector<double> extras_;
};

} // namespace

RawMesh read_off(std::string_view text, const std::string& name, Content content) {
    return OffReader(text, name, content).read();
}

} // namespace foldless
