#include <foldless/io/read_ply.h>

#include <foldless/io/errors.h>
#include <foldless/io/ply_header.h>
#include <foldless/io/ply_source.h>
#include <foldless/io/printable.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

namespace foldless {

namespace {

/// What a property means to us.
enum class Role { none, x, y, z, nx, ny, nz, scan_vertex, t_min, t_max, indices };

constexpr std::size_t role_count = static_cast<std::size_t>(Role::indices) + 1;

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

/// The properties of an element with their roles.
struct Layout {
    std::vector<Role> roles; ///< one per property
    std::array<bool, role_count> present{};
    [[nodiscard]] bool has(Role role) const { return present[static_cast<std::size_t>(role)]; }
    [[nodiscard]] bool has_normal() const { return has(Role::nx) && has(Role::ny) && has(Role::nz); }
};

/// One vertex or face: the value of each role, and the list of indices.
struct Instance {
    std::array<double, role_count> values{};
    std::vector<std::int32_t> indices;
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
            const Role role = role_of(property, names);
            const bool twice = role != Role::none && found.has(role);
            if (twice || (role != Role::none && (role == Role::indices) != property.count_type.has_value())) {
                source_.fail(fmt::format("property {} of element '{}' is {}", in_quotes(property.name), next.name,
                                         twice ? "declared twice" : "of the wrong kind"));
            }
            found.roles.push_back(role);
            found.present[static_cast<std::size_t>(role)] = true;
        }
        return found;
    }

    Role role_of(const PlyProperty& property, std::span<const RoleName> names) {
        for (const RoleName& known : names) {
            if (known.name == property.name && (content_ == Content::base_mesh || !known.base_mesh_only)) {
                return known.role;
            }
        }
        ignore(property);
        return Role::none;
    }

    void ignore(const PlyProperty& property) {
        for (const IgnoredName& known : ignored_names) {
            if (known.name == property.name) {
                mesh_.ignore(known.note);
                return;
            }
        }
        mesh_.ignore(fmt::format("property {}", in_quotes(property.name)));
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

    void read_vertices(const PlyElement& next) {
        if (read_vertices_) {
            source_.fail("element 'vertex' is declared twice");
        }
        read_vertices_ = true;
        const Layout found = layout(next, vertex_roles);
        require(found, Role::x, "element 'vertex' has no property 'x'");
        require(found, Role::y, "element 'vertex' has no property 'y'");
        require(found, Role::z, "element 'vertex' has no property 'z'");
        reserve_vertices(next, found);
        Instance instance;
        for (std::uint64_t i = 0; i < next.count; ++i) {
            source_.begin(next, i);
            read_instance(next, found, instance);
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

    std::int32_t scan_vertex(double value) {
        // Written so that NaN fails too.
        const bool fits = value >= -1.0 && value <= static_cast<double>(std::numeric_limits<std::int32_t>::max());
        if (!fits || value != static_cast<double>(static_cast<std::int32_t>(value))) {
            source_.fail(fmt::format("scan_vertex {} is neither a vertex nor -1", value));
        }
        return static_cast<std::int32_t>(value);
    }

    void read_faces(const PlyElement& next) {
        if (read_faces_) {
            source_.fail("element 'face' is declared twice");
        }
        read_faces_ = true;
        const Layout found = layout(next, face_roles);
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
        for (std::uint64_t i = 0; i < next.count; ++i) {
            source_.begin(next, i);
            read_instance(next, found, instance);
            store_face(found, instance);
            source_.end();
        }
    }

    void require_integer_indices(const PlyElement& next, const Layout& found) {
        const auto at = std::ranges::find(found.roles, Role::indices) - found.roles.begin();
        if (!is_integer(next.properties[static_cast<std::size_t>(at)].type)) {
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
