#include <foldless/io/read_obj.h>

#include <foldless/io/float32.h>
#include <foldless/io/numbers.h>
#include <foldless/io/printable.h>
#include <foldless/io/text_cursor.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace foldless {

namespace {

struct IgnoredStatement {
    std::string_view keyword;
    std::string_view note;
};

constexpr std::array<IgnoredStatement, 10> ignored_statements{{
    {"vt", "texture coordinates"},
    {"vn", "normals"},
    {"usemtl", "materials"},
    {"mtllib", "materials"},
    {"o", "object names"},
    {"g", "groups"},
    {"s", "smoothing groups"},
    {"p", "points"},
    {"l", "lines"},
    {"vp", "free-form geometry"},
}};

bool is_letter_or_underscore(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// The texts of a face corner `v`, `v/vt`, `v//vn` or `v/vt/vn`; no value where there is none.
struct Corner {
    std::string_view vertex;
    std::optional<std::string_view> texture;
    std::optional<std::string_view> normal;
};

Corner split(std::string_view token) {
    const std::size_t first = token.find('/');
    if (first == std::string_view::npos) {
        return {token, std::nullopt, std::nullopt};
    }
    const std::string_view rest = token.substr(first + 1);
    const std::size_t second = rest.find('/');
    if (second == std::string_view::npos) {
        return {token.substr(0, first), rest, std::nullopt};
    }
    Corner corner{token.substr(0, first), rest.substr(0, second), rest.substr(second + 1)};
    if (second == 0) {
        corner.texture.reset();
    }
    return corner;
}

/// Resolves the indices into one array, which may still grow, and remembers the largest until it can be checked.
class IndexResolver {
public:
    explicit IndexResolver(const char* what, const char* plural) : what_(what), plural_(plural) {}

    /// The index from 0 that `text` means when `count` entries are known.
    std::int32_t resolve(const TextCursor& cursor, std::string_view text, std::size_t count) {
        const std::int64_t written = integer(cursor, text);
        const auto known = static_cast<std::int64_t>(count);
        const bool relative = written < 0 && written >= -known;
        if (!relative && written <= 0) {
            cursor.fail(message(written, count));
        }
        // One that is too large for an int32 is not used: it is the largest, and out of range when all is read.
        const std::int64_t index = relative ? known + written : written - 1;
        if (index > largest_) {
            largest_ = index;
            line_ = cursor.line();
        }
        return static_cast<std::int32_t>(index);
    }

    /// To be called when the array is complete.
    void require_in_range(const TextCursor& cursor, std::size_t count) const {
        if (largest_ >= static_cast<std::int64_t>(count)) {
            cursor.fail_at(line_, message(largest_ + 1, count));
        }
    }

    /// True if there was one.
    [[nodiscard]] bool any() const { return largest_ >= 0; }

    [[nodiscard]] std::int64_t integer(const TextCursor& cursor, std::string_view text) const {
        const auto parsed = parse_integer(text);
        if (!parsed.ok()) {
            cursor.fail(fmt::format("{} for a {} index is not an integer", in_quotes(text), what_));
        }
        return parsed.value;
    }

private:
    [[nodiscard]] std::string message(std::int64_t index, std::size_t count) const {
        return fmt::format("{} index {} is out of range ({} {})", what_, index, count, plural_);
    }

    const char* what_;
    const char* plural_;
    std::int64_t largest_ = -1;
    std::size_t line_ = 0;
};

constexpr std::int32_t no_normal = -1;
constexpr std::int32_t no_texture = -1;
constexpr std::int32_t no_material = -1;

// Numbers behind the three coordinates of a vertex.
constexpr std::size_t colour_size = 3;
constexpr std::size_t colour_size_with_alpha = 4;

class ObjReader {
public:
    ObjReader(std::string_view text, const std::string& name, Content content)
        : cursor_(text, name, {.comments = true, .continuations = true}), content_(content) {}

    RawMesh read() {
        while (cursor_.next_line()) {
            read_statement(cursor_.token());
        }
        require_known_statement();
        vertices_.require_in_range(cursor_, mesh_.positions.size());
        normals_.require_in_range(cursor_, normal_values_.size());
        if (content_ == Content::base_mesh) {
            assign_normals();
        }
        if (content_ == Content::coloured_scan) {
            assign_appearance();
        }
        return std::move(mesh_);
    }

private:
    void read_statement(std::string_view keyword) {
        if (keyword == "v") {
            read_vertex();
        } else if (keyword == "f" || keyword == "fo") { // fo: the old name of f
            read_face();
        } else if (keyword == "vn" && content_ == Content::base_mesh) {
            normal_values_.push_back(read_vector());
            cursor_.require_end_of_line();
        } else if (content_ != Content::coloured_scan || !read_appearance(keyword)) {
            ignore(keyword);
        }
    }

    /// Reads a statement about the appearance; false if it is none.
    bool read_appearance(std::string_view keyword) {
        if (keyword == "vt") {
            read_texture_coordinate();
        } else if (keyword == "usemtl") {
            use_material(std::string(cursor_.rest_of_line()));
        } else if (keyword == "mtllib") {
            mesh_.appearance.material_libraries.emplace_back(cursor_.rest_of_line());
        } else {
            return false;
        }
        return true;
    }

    /// `u [v [w]]`: the v of a picture that is one line is 0, and pictures have no w.
    void read_texture_coordinate() {
        const float u = finite(cursor_.real("u"), "u");
        const float v = cursor_.peek().empty() ? 0.0F : finite(cursor_.real("v"), "v");
        texture_values_.emplace_back(u, v);
    }

    void use_material(const std::string& name) {
        std::vector<RawMaterial>& materials = mesh_.appearance.materials;
        const auto number = static_cast<std::int32_t>(materials.size());
        const auto [known, is_new] = material_numbers_.emplace(name, number);
        if (is_new) {
            materials.push_back({name, ""});
        }
        material_ = known->second;
    }

    float finite(double value, std::string_view what) {
        const double rounded = to_float32(value);
        if (!std::isfinite(rounded)) {
            cursor_.fail(fmt::format("{} is not a finite number", what));
        }
        return static_cast<float>(rounded);
    }

    Vec3 read_vector() {
        const double x = cursor_.real("x");
        const double y = cursor_.real("y");
        const double z = cursor_.real("z");
        return {x, y, z};
    }

    void read_vertex() {
        if (mesh_.positions.size() == max_vertices) {
            cursor_.fail("the vertices are too many");
        }
        mesh_.positions.push_back(read_vector());
        if (content_ == Content::coloured_scan) {
            read_colour();
            return;
        }
        std::size_t more = 0;
        for (; !cursor_.peek().empty(); ++more) {
            static_cast<void>(cursor_.real("a colour or weight"));
        }
        if (more > 0) {
            mesh_.ignore(more == 1 ? "vertex weights" : "colours");
        }
    }

    /// The numbers behind the coordinates: a weight, or a colour with or without alpha.
    void read_colour() {
        std::array<double, colour_size> colour{};
        std::size_t more = 0;
        for (; !cursor_.peek().empty(); ++more) {
            const double value = cursor_.real("a colour or weight");
            if (more < colour.size()) {
                colour[more] = value;
            }
        }
        if (more == colour_size || more == colour_size_with_alpha) {
            const auto value = [&](std::size_t i) { return finite(colour[i], "a colour"); };
            mesh_.appearance.colours.emplace_back(value(0), value(1), value(2));
        } else if (more > 0) {
            mesh_.ignore(more == 1 ? "vertex weights" : "colours");
        }
        if (more == colour_size_with_alpha) {
            mesh_.ignore("alpha");
        }
    }

    void read_face() {
        corners_.clear();
        corner_normals_.clear();
        corner_textures_.clear();
        for (std::string_view token = cursor_.token(); !token.empty(); token = cursor_.token()) {
            read_corner(split(token));
        }
        const std::size_t added = mesh_.add_polygon(corners_);
        if (mesh_.faces.size() > max_faces) {
            cursor_.fail("the faces are too many");
        }
        if (content_ == Content::base_mesh) {
            for (std::size_t i = 1; i <= added; ++i) {
                face_normals_.push_back({corner_normals_[0], corner_normals_[i], corner_normals_[i + 1]});
            }
        }
        if (content_ == Content::coloured_scan) {
            for (std::size_t i = 1; i <= added; ++i) {
                face_textures_.push_back({corner_textures_[0], corner_textures_[i], corner_textures_[i + 1]});
                mesh_.appearance.material_of_face.push_back(material_);
            }
        }
    }

    void read_corner(const Corner& corner) {
        corners_.push_back(vertices_.resolve(cursor_, corner.vertex, mesh_.positions.size()));
        if (content_ == Content::coloured_scan) {
            corner_textures_.push_back(
                corner.texture ? textures_.resolve(cursor_, *corner.texture, texture_values_.size()) : no_texture);
        } else if (corner.texture) {
            static_cast<void>(textures_.integer(cursor_, *corner.texture));
        }
        if (content_ != Content::base_mesh) {
            if (corner.normal) {
                static_cast<void>(normals_.integer(cursor_, *corner.normal));
            }
            return;
        }
        corner_normals_.push_back(corner.normal ? normals_.resolve(cursor_, *corner.normal, normal_values_.size())
                                                : no_normal);
    }

    void ignore(std::string_view keyword) {
        for (const IgnoredStatement& known : ignored_statements) {
            if (known.keyword == keyword) {
                mesh_.ignore(known.note);
                return;
            }
        }
        if (!is_letter_or_underscore(keyword[0])) {
            cursor_.fail(no_statement_text(keyword));
        }
        if (unknown_statement_.empty()) {
            unknown_statement_ = keyword;
            unknown_line_ = cursor_.line();
        }
        mesh_.ignore(fmt::format("{} statements", in_quotes(keyword)));
    }

    static std::string no_statement_text(std::string_view keyword) {
        return fmt::format("{} is no OBJ statement", in_quotes(keyword));
    }

    /// A statement that we do not know may be skipped; a file of another kind must not pass for an empty mesh.
    void require_known_statement() const {
        const bool empty = mesh_.positions.empty() && mesh_.faces.empty() && mesh_.short_faces == 0;
        if (empty && !unknown_statement_.empty()) {
            cursor_.fail_at(unknown_line_, no_statement_text(unknown_statement_));
        }
    }

    /// The normals that the corners name, gathered per vertex.
    void assign_normals() {
        std::vector<std::int32_t> normal(mesh_.positions.size(), no_normal);
        std::vector<bool> bare(mesh_.positions.size(), false);
        std::vector<bool> conflict(mesh_.positions.size(), false);
        for (std::size_t face = 0; face < mesh_.faces.size(); ++face) {
            for (std::size_t i = 0; i < 3; ++i) {
                const auto vertex = static_cast<std::size_t>(mesh_.faces[face][i]);
                const std::int32_t named = face_normals_[face][i];
                bare[vertex] = bare[vertex] || named == no_normal;
                conflict[vertex] = conflict[vertex] || differ(normal[vertex], named);
                normal[vertex] = named == no_normal ? normal[vertex] : named;
            }
        }
        if (std::ranges::all_of(normal, [](std::int32_t index) { return index == no_normal; })) {
            return;
        }
        mesh_.missing_normals = static_cast<std::size_t>(std::ranges::count(bare, true));
        mesh_.corner_conflicts = static_cast<std::size_t>(std::ranges::count(conflict, true));
        store_normals(normal);
    }

    [[nodiscard]] bool differ(std::int32_t a, std::int32_t b) const {
        return a != no_normal && b != no_normal && a != b &&
               normal_values_[static_cast<std::size_t>(a)] != normal_values_[static_cast<std::size_t>(b)];
    }

    /// A vertex that no face uses has the normal of its own number if there are as many normals as vertices.
    void store_normals(const std::vector<std::int32_t>& normal) {
        const bool paired = normal_values_.size() == mesh_.positions.size();
        for (std::size_t vertex = 0; vertex < normal.size(); ++vertex) {
            const std::size_t unused = paired ? vertex : normal_values_.size();
            const std::size_t index = normal[vertex] == no_normal ? unused : static_cast<std::size_t>(normal[vertex]);
            mesh_.normals.push_back(index < normal_values_.size() ? normal_values_[index] : Vec3(Vec3::Zero()));
        }
    }

    /// There are programs that write the indices and not the values.
    void assign_appearance() {
        if (texture_values_.empty()) {
            if (textures_.any()) {
                mesh_.ignore("texture indices that name nothing");
            }
            return;
        }
        textures_.require_in_range(cursor_, texture_values_.size());
        const auto value = [&](std::int32_t index) {
            return index == no_texture ? no_texture_coordinate() : texture_values_[static_cast<std::size_t>(index)];
        };
        mesh_.appearance.texture_coordinates.reserve(face_textures_.size());
        for (const auto& [a, b, c] : face_textures_) {
            mesh_.appearance.texture_coordinates.push_back({value(a), value(b), value(c)});
        }
    }

    TextCursor cursor_;
    Content content_;
    RawMesh mesh_;
    std::string_view unknown_statement_; ///< the first, if any
    std::size_t unknown_line_ = 0;
    IndexResolver vertices_{"vertex", "vertices"};
    IndexResolver textures_{"texture", "texture coordinates"};
    IndexResolver normals_{"normal", "normals"};
    std::vector<Vec3> normal_values_;
    std::vector<Triangle> face_normals_; ///< for a base mesh: the normals of the corners of each face
    std::vector<std::int32_t> corners_;
    std::vector<std::int32_t> corner_normals_;
    std::vector<Eigen::Vector2f> texture_values_;
    std::vector<Triangle> face_textures_; ///< for a coloured scan: the texture coordinates of the corners of each face
    std::vector<std::int32_t> corner_textures_;
    std::unordered_map<std::string, std::int32_t> material_numbers_;
    std::int32_t material_ = no_material; ///< of the faces that come next
};

} // namespace

RawMesh read_obj(std::string_view text, const std::string& name, Content content) {
    return ObjReader(text, name, content).read();
}

} // namespace foldless
