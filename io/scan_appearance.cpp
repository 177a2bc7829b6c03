#include <foldless/io/scan_appearance.h>

#include <foldless/io/complete_appearance.h>
#include <foldless/io/file_bytes.h>
#include <foldless/io/material_library.h>
#include <foldless/io/printable.h>
#include <foldless/io/read_raw.h>
#include <foldless/predicates/default_arithmetic.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <unordered_map>
#include <utility>

namespace foldless {

namespace {

/// The path that a file names, which may have been written on Windows.
std::filesystem::path named_path(std::string name) {
    std::ranges::replace(name, '\\', '/');
    return name;
}

bool is_file(const std::filesystem::path& path) {
    std::error_code unknown; // is no file then
    return std::filesystem::is_regular_file(path, unknown);
}

/// Where a picture is that a file in this folder names: there, or in the folder under its last name alone, for a file
/// may name the place on the machine that it comes from.
std::filesystem::path picture_path(const std::filesystem::path& folder, const std::string& name) {
    const std::filesystem::path named = named_path(name);
    const std::filesystem::path beside = folder / named.filename();
    return !is_file(folder / named) && is_file(beside) ? beside : folder / named;
}

/// The names of one `mtllib`: a single one with blanks, if there is such a file, else those between the blanks.
std::vector<std::string> library_names(const std::filesystem::path& folder, const std::string& statement) {
    if (is_file(folder / named_path(statement))) {
        return {statement};
    }
    std::vector<std::string> names;
    for (std::size_t at = 0; at < statement.size();) {
        const std::size_t end = std::min(statement.find_first_of(" \t", at), statement.size());
        if (end > at) {
            names.push_back(statement.substr(at, end - at));
        }
        at = end + 1;
    }
    return names;
}

/// Finds the pictures of the materials of a mesh, and where they are.
class TextureFinder {
public:
    TextureFinder(std::filesystem::path folder, RawMesh& mesh) : folder_(std::move(folder)), mesh_(mesh) {}

    void find(ScanAppearance& appearance) {
        read_libraries();
        for (const RawMaterial& material : mesh_.appearance.materials) {
            textures_.push_back(texture_of(material, appearance.textures));
        }
        if (!appearance.textures.empty()) {
            appearance.texture_of_face = std::move(mesh_.appearance.material_of_face);
        }
        for (std::int32_t& number : appearance.texture_of_face) {
            number = number < 0 ? -1 : textures_[static_cast<std::size_t>(number)];
        }
    }

private:
    void read_libraries() {
        std::set<std::string> read;
        for (std::size_t i = 0; i < mesh_.appearance.materials.size(); ++i) {
            numbers_.emplace(mesh_.appearance.materials[i].name, i);
        }
        for (const std::string& statement : mesh_.appearance.material_libraries) {
            if (!read.insert(statement).second) {
                continue;
            }
            for (const std::string& name : library_names(folder_, statement)) {
                read_library(name);
            }
        }
    }

    void read_library(const std::string& name) {
        const std::filesystem::path path = folder_ / named_path(name);
        try {
            const FileBytes file(path);
            for (const Material& material : read_material_library(file.bytes(), printable(path))) {
                assign(material, named_path(name).parent_path());
            }
        } catch (const UnreadableFile&) {
            mesh_.ignore(fmt::format("material library {}, which cannot be read", in_quotes(name)));
        }
    }

    /// The first library that has a picture for the material decides. Its folder comes first, then that of the mesh.
    void assign(const Material& material, const std::filesystem::path& library_folder) {
        const auto used = numbers_.find(material.name);
        if (used == numbers_.end() || !mesh_.appearance.materials[used->second].picture.empty()) {
            return;
        }
        const std::filesystem::path beside = library_folder / named_path(material.picture);
        mesh_.appearance.materials[used->second].picture =
            is_file(folder_ / beside) ? beside.string() : material.picture;
        if (material.has_options) {
            mesh_.ignore("texture options");
        }
    }

    /// The number of the picture among the textures, or -1.
    std::int32_t texture_of(const RawMaterial& material, std::vector<std::filesystem::path>& textures) {
        if (material.picture.empty()) {
            mesh_.ignore("materials without a picture");
            return -1;
        }
        const auto [known, is_new] = known_.emplace(material.picture, static_cast<std::int32_t>(textures.size()));
        if (is_new) {
            textures.push_back(picture_path(folder_, material.picture));
        }
        return known->second;
    }

    std::filesystem::path folder_;
    RawMesh& mesh_;
    std::unordered_map<std::string, std::size_t> numbers_; ///< of the materials, by name
    std::map<std::string, std::int32_t> known_;            ///< the textures by the names of their pictures
    std::vector<std::int32_t> textures_;                   ///< of the materials
};

} // namespace

ReadColouredScan read_coloured_scan(const std::filesystem::path& path) {
    const DefaultArithmetic arithmetic; // for the numbers in text
    RawMesh mesh = read_raw(path, Content::coloured_scan);
    complete_appearance(mesh);
    ReadColouredScan read;
    read.appearance.vertex_colours = std::move(mesh.appearance.colours);
    read.appearance.texture_coordinates = std::move(mesh.appearance.texture_coordinates);
    TextureFinder(path.parent_path(), mesh).find(read.appearance);
    read.scan = take_scan(mesh);
    read.notes = std::move(mesh.notes);
    return read;
}

} // namespace foldless
