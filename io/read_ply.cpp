#include <foldless/io/read_ply.h>

#include <foldless/io/errors.h>
#include <foldless/io/float32.h>
#include <foldless/io/ply_header.h>
#include <foldless/io/ply_source.h>
#include <foldless/io/printable.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace foldless {

namespace {

/// What a property means to us.
enum class Role {
    none,
    x,
    y,
    z,
    nx,
    ny,
    nz,
    scan_vertex,
    t_min,
    t_max,
    red,
    green,
    blue,
    u,
    v,
    texture_number,
    texture_corners,
    indices
};

constexpr std::size_t role_count = static_cast<std::size_t>(Role::indices) + 1;

constexpr bool is_list(Role role) {
    return role == Role::indices || role == Role::texture_corners;
}

struct RoleName {
    std::string_view name;
    Role role;
    bool base_mesh_only;
};

constexpr std::array<RoleName, 7> vertex_roles{{
    {"x", Role::x, false},
    {"y", Role::y, false},
    {"z", Role::z, false},
    {"nx", Role::nx, true},
    {"ny", Role::ny, true},
    {"nz", Role::nz, true},
    {"scan_vertex", Role::scan_vertex, true},
}};

constexpr std::array<RoleName, 7> face_roles{{
    {"vertex_indices", Role::indices, false},
    {"vertex_index", Role::indices, false},
    {"nx", Role::nx, true},
    {"ny", Role::ny, true},
    {"nz", Role::nz, true},
    {"t_min", Role::t_min, true},
    {"t_max", Role::t_max, true},
}};

// Several programs, several names; the first set that is there whole is taken.
constexpr std::array<Role, 3> colour_roles{Role::red, Role::green, Role::blue};
constexpr std::array<std::array<std::string_view, 3>, 3> colour_names{{
    {"red", "green", "blue"},
    {"diffuse_red", "diffuse_green", "diffuse_blue"},
    {"r", "g", "b"},
}};
constexpr std::array<Role, 2> texture_roles{Role::u, Role::v};
constexpr std::array<std::array<std::string_view, 2>, 3> texture_names{{
    {"s", "t"},
    {"u", "v"},
    {"texture_u", "texture_v"},
}};

struct IgnoredName {
    std::string_view name;
    std::string_view note;
};

// The usual names of what we read over; everything else is noted by its own name.
constexpr std::array<IgnoredName, 18> ignored_names{{
    {"nx", "normals"},
    {"ny", "normals"},
    {"nz", "normals"},
    {"red", "colours"},
    {"green", "colours"},
    {"blue", "colours"},
    {"alpha", "colours"},
    {"diffuse_red", "colours"},
    {"diffuse_green", "colours"},
    {"diffuse_blue", "colours"},
    {"s", "texture coordinates"},
    {"t", "texture coordinates"},
    {"u", "texture coordinates"},
    {"v", "texture coordinates"},
    {"texture_u", "texture coordinates"},
    {"texture_v", "texture coordinates"},
    {"texcoord", "texture coordinates"},
    {"texnumber", "texture coordinates"},
}};

/// What is noted of a property of a coloured scan by another name, for part of what is meant is read.
std::string_view note_of_coloured(const PlyElement& element, std::string_view name, std::string_view note) {
    if (note == "colours") {
        return element.name == "face" ? "face colours" : name == "alpha" ? "alpha" : note;
    }
    return name == "texnumber" ? "texture numbers" : note;
}

/// The type of one of the properties of this name; no value if there is none, or if it is a list.
std::optional<PlyType> scalar_type(const PlyElement& element, std::string_view name) {
    const auto named = std::ranges::find(element.properties, name, &PlyProperty::name);
    if (named == element.properties.end() || named->count_type) {
        return std::nullopt;
    }
    return named->type;
}

/// True if all these properties are there, with the same type.
bool has_all(const PlyElement& element, std::span<const std::string_view> names) {
    const std::optional<PlyType> type = scalar_type(element, names[0]);
    return type &&
           std::ranges::all_of(names, [&](std::string_view name) { return scalar_type(element, name) == type; });
}

/// Appends the roles of the first set of names that the element has.
template <std::size_t size, std::size_t sets>
void add_roles(const PlyElement& element, const std::array<std::array<std::string_view, size>, sets>& names,
               const std::array<Role, size>& roles, std::vector<RoleName>& known) {
    const auto found = std::ranges::find_if(names, [&](const auto& set) { return has_all(element, set); });
    for (std::size_t i = 0; found != names.end() && i < size; ++i) {
        known.push_back({(*found)[i], roles[i], false});
    }
}

/// The brightest colour; no value for numbers that are not integers, of which the type does not say it.
std::optional<float> colour_unit(PlyType type) {
    constexpr float byte_unit = 255.0F;
    constexpr float short_unit = 65535.0F;
    if (!is_integer(type)) {
        return std::nullopt;
    }
    return type == PlyType::uint16 ? short_unit : byte_unit;
}

/// The properties of an element with their roles.
struct Layout {
    std::vector<Role> roles; ///< one per property
    std::array<bool, role_count> present{};
    [[nodiscard]] bool has(Role role) const { return present[static_cast<std::size_t>(role)]; }
    [[nodiscard]] bool has_normal() const { return has(Role::nx) && has(Role::ny) && has(Role::nz); }
    // Of colours and texture coordinates all have a role, or none.
    [[nodiscard]] bool has_colour() const { return has(Role::red); }
    [[nodiscard]] bool has_texture_coordinate() const { return has(Role::u); }
    [[nodiscard]] bool has_appearance() const {
        return has_colour() || has_texture_coordinate() || has(Role::texture_corners) || has(Role::texture_number);
    }
};

/// One vertex or face: the value of each role, and the lists.
struct Instance {
    std::array<double, role_count> values{};
    std::vector<std::int32_t> indices;
    std::vector<float> texture_corners; ///< u and v in turn
    [[nodiscard]] double operator[](Role role) const { return values[static_cast<std::size_t>(role)]; }
    [[nodiscard]] Vec3 normal() const { return {(*this)[Role::nx], (*this)[Role::ny], (*this)[Role::nz]}; }
};

template <class Source>
class PlyReader {
public:
    PlyReader(Source source, const PlyHeader& header, Content content)
        : source_(std::move(source)), header_(header), content_(content) {}

    RawMesh read() {
        vertices_ = element("vertex").count;
        for (const PlyElement& next : header_.elements) {
            require_space(next);
            if (next.name == "vertex") {
                read_vertices(next);
            } else if (next.name == "face") {
                read_faces(next);
            } else {
                skip(next);
            }
        }
        source_.require_end();
        if (content_ == Content::coloured_scan) {
            store_textures();
        }
        return std::move(mesh_);
    }

private:
    const PlyElement& element(std::string_view name) {
        const auto named = [&](const PlyElement& e) { return e.name == name; };
        const auto found = std::ranges::find_if(header_.elements, named);
        if (found == header_.elements.end()) {
            source_.fail(fmt::format("the header has no element '{}'", name));
        }
        return *found;
    }

    /// Before anything is reserved for an element: its instances must fit into what is left of the file.
    void require_space(const PlyElement& next) {
        const std::size_t least = Source::least_space(next);
        if (least > 0 && next.count > source_.space_left() / least) {
            source_.fail(fmt::format("element {} cannot have {} instances in the {} bytes that are left",
                                     in_quotes(next.name), next.count, source_.space_left()));
        }
    }

    void skip(const PlyElement& next) {
        if (next.count > 0) {
            mesh_.ignore(fmt::format("element {}", in_quotes(next.name)));
        }
        if (!next.properties.empty()) {
            source_.skip(next);
        }
    }

    Layout layout(const PlyElement& next, std::span<const RoleName> names) {
        Layout found;
        for (const PlyProperty& property : next.properties) {
            const Role role = role_of(next, property, names);
            const bool twice = role != Role::none && found.has(role);
            if (twice || (role != Role::none && is_list(role) != property.count_type.has_value())) {
                source_.fail(fmt::format("property {} of element '{}' is {}", in_quotes(property.name), next.name,
                                         twice ? "declared twice" : "of the wrong kind"));
            }
            found.roles.push_back(role);
            found.present[static_cast<std::size_t>(role)] = true;
        }
        return found;
    }

    Role role_of(const PlyElement& next, const PlyProperty& property, std::span<const RoleName> names) {
        for (const RoleName& known : names) {
            if (known.name == property.name && (content_ == Content::base_mesh || !known.base_mesh_only)) {
                return known.role;
            }
        }
        ignore(next, property);
        return Role::none;
    }

    void ignore(const PlyElement& next, const PlyProperty& property) {
        for (const IgnoredName& known : ignored_names) {
            if (known.name == property.name) {
                mesh_.ignore(content_ == Content::coloured_scan ? note_of_coloured(next, known.name, known.note)
                                                                : known.note);
                return;
            }
        }
        mesh_.ignore(fmt::format("property {}", in_quotes(property.name)));
    }

    [[nodiscard]] std::vector<RoleName> vertex_names(const PlyElement& next) const {
        std::vector<RoleName> names(vertex_roles.begin(), vertex_roles.end());
        if (content_ == Content::coloured_scan) {
            add_roles(next, colour_names, colour_roles, names);
            add_roles(next, texture_names, texture_roles, names);
        }
        return names;
    }

    [[nodiscard]] std::vector<RoleName> face_names(const PlyElement& next) const {
        std::vector<RoleName> names(face_roles.begin(), face_roles.end());
        if (content_ == Content::coloured_scan) {
            // What is a list in one file and a number in another has a meaning in one of them only.
            if (!scalar_type(next, "texcoord")) {
                names.push_back({"texcoord", Role::texture_corners, false});
            }
            if (scalar_type(next, "texnumber") && !header_.textures.empty()) {
                names.push_back({"texnumber", Role::texture_number, false});
            }
        }
        return names;
    }

    void require(const Layout& found, Role role, std::string_view text) {
        if (!found.has(role)) {
            source_.fail(text);
        }
    }

    void read_instance(const PlyElement& next, const Layout& found, Instance& instance) {
        for (std::size_t i = 0; i < found.roles.size(); ++i) {
            const PlyProperty& property = next.properties[i];
            if (!property.count_type) {
                instance.values[static_cast<std::size_t>(found.roles[i])] = source_.value(property);
            } else if (found.roles[i] == Role::indices) {
                read_indices(property, instance);
            } else if (found.roles[i] == Role::texture_corners) {
                read_texture_corners(property, instance);
            } else {
                for (std::size_t left = source_.list_length(property); left > 0; --left) {
                    static_cast<void>(source_.value(property));
                }
            }
        }
    }

    void read_indices(const PlyProperty& property, Instance& instance) {
        instance.indices.clear();
        for (std::size_t left = source_.list_length(property); left > 0; --left) {
            const std::int64_t index = source_.index(property);
            if (static_cast<std::uint64_t>(index) >= vertices_) { // negative ones too, which become huge
                source_.fail(out_of_range_text(index, vertices_));
            }
            instance.indices.push_back(static_cast<std::int32_t>(index));
        }
    }

    void read_texture_corners(const PlyProperty& property, Instance& instance) {
        instance.texture_corners.clear();
        for (std::size_t left = source_.list_length(property); left > 0; --left) {
            instance.texture_corners.push_back(finite(source_.value(property), "a texture coordinate"));
        }
    }

    /// As float32.
    float finite(double value, std::string_view what) {
        const double rounded = to_float32(value);
        if (!std::isfinite(rounded)) {
            source_.fail(fmt::format("{} is not a finite number", what));
        }
        return static_cast<float>(rounded);
    }

    void read_vertices(const PlyElement& next) {
        if (read_vertices_) {
            source_.fail("element 'vertex' is declared twice");
        }
        read_vertices_ = true;
        const Layout found = layout(next, vertex_names(next));
        require(found, Role::x, "element 'vertex' has no property 'x'");
        require(found, Role::y, "element 'vertex' has no property 'y'");
        require(found, Role::z, "element 'vertex' has no property 'z'");
        reserve_vertices(next, found);
        if (found.has_colour()) {
            mesh_.appearance.colour_unit = colour_unit(type_of(next, found, Role::red));
        }
        Instance instance;
        const bool has_appearance = found.has_appearance(); // asked once, for most have none
        for (std::uint64_t i = 0; i < next.count; ++i) {
            source_.begin(next, i);
            read_instance(next, found, instance);
            if (has_appearance) {
                store_vertex_appearance(found, instance); // which fails inside the vertex
            }
            source_.end();
            store_vertex(found, instance);
        }
    }

    void reserve_vertices(const PlyElement& next, const Layout& found) {
        if (next.count > max_vertices) {
            source_.fail(fmt::format("{} vertices are too many", next.count));
        }
        const auto count = static_cast<std::size_t>(next.count);
        mesh_.positions.reserve(count);
        mesh_.normals.reserve(found.has_normal() ? count : 0);
        mesh_.scan_vertex.reserve(found.has(Role::scan_vertex) ? count : 0);
        mesh_.appearance.colours.reserve(found.has_colour() ? count : 0);
        mesh_.appearance.vertex_texture_coordinates.reserve(found.has_texture_coordinate() ? count : 0);
    }

    static PlyType type_of(const PlyElement& next, const Layout& found, Role role) {
        const auto at = std::ranges::find(found.roles, role) - found.roles.begin();
        return next.properties[static_cast<std::size_t>(at)].type;
    }

    void store_vertex_appearance(const Layout& found, const Instance& instance) {
        if (found.has_colour()) {
            const auto colour = [&](Role role) { return finite(instance[role], "a colour"); };
            mesh_.appearance.colours.emplace_back(colour(Role::red), colour(Role::green), colour(Role::blue));
        }
        if (found.has_texture_coordinate()) {
            const auto coordinate = [&](Role role) { return finite(instance[role], "a texture coordinate"); };
            mesh_.appearance.vertex_texture_coordinates.emplace_back(coordinate(Role::u), coordinate(Role::v));
        }
    }

    void store_vertex(const Layout& found, const Instance& instance) {
        mesh_.positions.emplace_back(instance[Role::x], instance[Role::y], instance[Role::z]);
        if (found.has_normal()) {
            mesh_.normals.push_back(instance.normal());
        }
        if (found.has(Role::scan_vertex)) {
            mesh_.scan_vertex.push_back(scan_vertex(instance[Role::scan_vertex]));
        }
    }

    /// An index of which -1 means none; any other number is no value.
    static std::optional<std::int32_t> optional_index(double value) {
        // Written so that NaN fails too.
        const bool fits = value >= -1.0 && value <= static_cast<double>(std::numeric_limits<std::int32_t>::max());
        if (!fits || value != static_cast<double>(static_cast<std::int32_t>(value))) {
            return std::nullopt;
        }
        return static_cast<std::int32_t>(value);
    }

    std::int32_t scan_vertex(double value) {
        const std::optional<std::int32_t> index = optional_index(value);
        if (!index) {
            source_.fail(fmt::format("scan_vertex {} is neither a vertex nor -1", value));
        }
        return *index;
    }

    std::int32_t texture_number(double value) {
        const std::optional<std::int32_t> index = optional_index(value);
        if (!index || *index >= static_cast<std::int64_t>(header_.textures.size())) {
            source_.fail(fmt::format("texnumber {} is neither a texture nor -1 ({})", value,
                                     counted(header_.textures.size(), "texture", "textures")));
        }
        return *index;
    }

    void read_faces(const PlyElement& next) {
        if (read_faces_) {
            source_.fail("element 'face' is declared twice");
        }
        read_faces_ = true;
        const Layout found = layout(next, face_names(next));
        if (next.count == 0) {
            return;
        }
        require(found, Role::indices, "element 'face' has no list 'vertex_indices'");
        require_integer_indices(next, found);
        if (found.has(Role::t_min) != found.has(Role::t_max)) {
            source_.fail("element 'face' has only one of 't_min' and 't_max'");
        }
        reserve_faces(next, found);
        Instance instance;
        const bool has_appearance = found.has_appearance();
        for (std::uint64_t i = 0; i < next.count; ++i) {
            source_.begin(next, i);
            read_instance(next, found, instance);
            store_face(found, instance);
            if (has_appearance) {
                store_face_appearance(found, instance);
            }
            source_.end();
        }
    }

    void require_integer_indices(const PlyElement& next, const Layout& found) {
        if (!is_integer(type_of(next, found, Role::indices))) {
            source_.fail("the vertex indices are not integers");
        }
    }

    void reserve_faces(const PlyElement& next, const Layout& found) {
        // Lists may be empty, so the count alone could ask for many times the size of the file; three corners cannot.
        constexpr std::size_t least_triangle = 3;
        const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(
            {next.count, source_.space_left() / (Source::least_space(next) + least_triangle), max_faces}));
        mesh_.faces.reserve(count);
        mesh_.ranges.reserve(has_ranges(found) ? count : 0);
        mesh_.face_normals.reserve(found.has_normal() ? count : 0);
        mesh_.appearance.texture_coordinates.reserve(found.has(Role::texture_corners) ? count : 0);
        mesh_.appearance.material_of_face.reserve(found.has(Role::texture_number) ? count : 0);
    }

    /// With t_max, as read_faces() has found.
    static bool has_ranges(const Layout& found) { return found.has(Role::t_min); }

    void store_face(const Layout& found, const Instance& instance) {
        const std::size_t added = mesh_.add_polygon(instance.indices);
        if (mesh_.faces.size() > max_faces) {
            source_.fail("the faces are too many");
        }
        if (has_ranges(found)) {
            mesh_.ranges.insert(mesh_.ranges.end(), added, Range{instance[Role::t_min], instance[Role::t_max]});
        }
        if (found.has_normal()) {
            mesh_.face_normals.insert(mesh_.face_normals.end(), added, instance.normal());
        }
    }

    /// For the faces that store_face() has added.
    void store_face_appearance(const Layout& found, const Instance& instance) {
        if (found.has(Role::texture_corners)) {
            store_texture_corners(instance);
        }
        if (found.has(Role::texture_number)) {
            mesh_.appearance.material_of_face.resize(mesh_.faces.size(),
                                                     texture_number(instance[Role::texture_number]));
        }
    }

    /// In the fan of RawMesh::add_polygon(). A face without texture has an empty list.
    void store_texture_corners(const Instance& instance) {
        const std::vector<float>& values = instance.texture_corners;
        const std::size_t corners = instance.indices.size();
        if (!values.empty() && values.size() != 2 * corners) {
            source_.fail(fmt::format("texcoord has {} values for {} corners", values.size(), corners));
        }
        const auto corner = [&](std::size_t i) {
            return values.empty() ? no_texture_coordinate() : Eigen::Vector2f(values[2 * i], values[2 * i + 1]);
        };
        for (std::size_t i = 1; i + 1 < corners; ++i) {
            mesh_.appearance.texture_coordinates.push_back({corner(0), corner(i), corner(i + 1)});
        }
    }

    /// Faces without a number have the first texture, as in the programs that write them.
    void store_textures() {
        RawAppearance& appearance = mesh_.appearance;
        for (const std::string& picture : header_.textures) {
            appearance.materials.push_back({"", picture});
        }
        if (appearance.material_of_face.empty() && !appearance.materials.empty()) {
            appearance.material_of_face.assign(mesh_.faces.size(), 0);
            if (appearance.materials.size() > 1) {
                mesh_.ignore("textures but the first");
            }
        }
    }

    Source source_;
    const PlyHeader& header_;
    Content content_;
    RawMesh mesh_;
    std::uint64_t vertices_ = 0;
    bool read_vertices_ = false;
    bool read_faces_ = false;
};

} // namespace

RawMesh read_ply(std::string_view bytes, const std::string& name, Content content) {
    const PlyHeader header = parse_ply_header(bytes, name);
    if (header.format == PlyFormat::ascii) {
        return PlyReader(PlyText(bytes, name, header), header, content).read();
    }
    return PlyReader(PlyBytes(bytes, name, header), header, content).read();
}

} // namespace foldless
