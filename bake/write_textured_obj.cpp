#include <foldless/bake/write_textured_obj.h>

#include <foldless/bake/require_textured_mesh.h>
#include <foldless/io/comment_line.h>
#include <foldless/io/file_type.h>
#include <foldless/io/printable.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <string_view>
#include <utility>

namespace foldless {

namespace {

constexpr const char* material_name = "base";

/// True for a name that every reader takes for one name.
bool is_plain(std::string_view name) {
    const auto harmless = [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte > ' ' && byte != 0x7F && c != '#' && c != '\\' && c != '"';
    };
    return !name.empty() && name.front() != '-' && std::ranges::all_of(name, harmless);
}

void require_plain(const std::filesystem::path& path, const std::string& name) {
    if (!is_plain(name)) {
        refuse_to_write(path, fmt::format("the name \"{}\" cannot stand in OBJ and MTL files, where blanks and some "
                                          "signs end it",
                                          printable(name)));
    }
}

void require_obj(const std::filesystem::path& path, const TexturedMesh& mesh, const MtlPictures& pictures) {
    if (file_type(path) != FileType::obj) {
        refuse_to_write(path, "the name of an OBJ file ends in .obj");
    }
    require_textured_mesh(path, mesh);
    if (!mesh.base->face_directions.empty()) {
        refuse_to_write(path, "OBJ has no room for constant face directions");
    }
    for (const auto& name : {pictures.colour, pictures.normal, pictures.displacement}) {
        if (name) {
            require_plain(path, *name);
        }
    }
}

/// Writes lines that are formatted one at a time.
class LineWriter {
public:
    explicit LineWriter(AtomicFile& file) : file_(file) {}

    template <class... Arguments>
    void write(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        line_.clear();
        fmt::format_to(std::back_inserter(line_), format, std::forward<Arguments>(arguments)...);
        file_.write({line_.data(), line_.size()});
    }

private:
    AtomicFile& file_;
    fmt::memory_buffer line_;
};

void write_vectors(LineWriter& lines, const char* keyword, const std::vector<Vec3>& vectors) {
    for (const Vec3& v : vectors) {
        lines.write("{} {} {} {}\n", keyword, v.x(), v.y(), v.z());
    }
}

/// Writes the texture coordinates, each pair once, and returns the number of the first pair, for the corners of each
/// face.
std::vector<std::array<std::size_t, 3>> write_texture_coordinates(LineWriter& lines, const TexturedMesh& mesh) {
    std::map<std::pair<double, double>, std::size_t> known;
    const auto number = [&](const Eigen::Vector2d& uv) {
        const auto [entry, is_new] = known.try_emplace({uv.x(), uv.y()}, known.size() + 1);
        if (is_new) {
            lines.write("vt {} {}\n", uv.x(), 1 - uv.y());
        }
        return entry->second;
    };
    std::vector<std::array<std::size_t, 3>> numbers;
    numbers.reserve(mesh.uv.size());
    for (const auto& [a, b, c] : mesh.uv) {
        const std::size_t first = number(a);
        const std::size_t second = number(b);
        numbers.push_back({first, second, number(c)});
    }
    return numbers;
}

void write_faces(LineWriter& lines, const BaseMesh& base, const std::vector<std::array<std::size_t, 3>>& textures) {
    for (std::size_t face = 0; face < base.faces.size(); ++face) {
        lines.write("f");
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::int64_t vertex = base.faces[face][corner] + std::int64_t{1};
            lines.write(" {}/{}", vertex, textures[face][corner]);
            if (!base.directions.empty()) {
                lines.write("/{}", vertex);
            }
        }
        lines.write("\n");
    }
}

void write_geometry(AtomicFile& file, const TexturedMesh& mesh, const std::string& mtl_name) {
    LineWriter lines(file);
    lines.write("mtllib {}\n", mtl_name);
    write_vectors(lines, "v", mesh.base->positions);
    const auto textures = write_texture_coordinates(lines, mesh);
    write_vectors(lines, "vn", mesh.base->directions);
    lines.write("usemtl {}\n", material_name);
    write_faces(lines, *mesh.base, textures);
}

/// White and not shining where there is no picture.
void write_mtl(AtomicFile& file, const MtlPictures& pictures) {
    LineWriter lines(file);
    lines.write("newmtl {}\nKd 1 1 1\nKs 0 0 0\nillum 1\n", material_name);
    const auto write = [&](const char* keyword, const std::optional<std::string>& name) {
        if (name) {
            lines.write("{} {}\n", keyword, *name);
        }
    };
    write("map_Kd", pictures.colour);
    write("norm", pictures.normal);
    write("map_Bump", pictures.normal);
    write("disp", pictures.displacement);
}

} // namespace

std::vector<AtomicFile> stage_textured_obj(const std::filesystem::path& path, const TexturedMesh& mesh,
                                           const MtlPictures& pictures, const std::vector<std::string>& comments) {
    require_obj(path, mesh, pictures);
    const std::filesystem::path mtl_path = std::filesystem::path(path).replace_extension(".mtl");
    const std::string mtl_name = mtl_path.filename().string();
    require_plain(path, mtl_name);
    std::vector<AtomicFile> files;
    write_mtl(files.emplace_back(mtl_path), pictures);
    AtomicFile& obj = files.emplace_back(path);
    for (const std::string& comment : comments) {
        obj.write("# " + comment_line(comment) + "\n");
    }
    write_geometry(obj, mesh, mtl_name);
    for (AtomicFile& file : files) {
        file.finish();
    }
    return files;
}

} // namespace foldless
