#include <foldless/bake/write_glb.h>

#include <foldless/bake/glb_model.h>
#include <foldless/bake/require_textured_mesh.h>
#include <foldless/io/float32.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <ostream>
#include <streambuf>

namespace foldless {

namespace {

/// A stream into an AtomicFile, whose exceptions pass through it.
class FileStreamBuffer final : public std::streambuf {
public:
    explicit FileStreamBuffer(AtomicFile& file) : file_(file) {}

protected:
    int_type overflow(int_type character) override {
        if (!traits_type::eq_int_type(character, traits_type::eof())) {
            const char byte = traits_type::to_char_type(character);
            file_.write({&byte, 1});
        }
        return traits_type::not_eof(character);
    }

    std::streamsize xsputn(const char* bytes, std::streamsize count) override {
        file_.write({bytes, static_cast<std::size_t>(count)});
        return count;
    }

private:
    AtomicFile& file_;
};

// Lengths and offsets are ints in tinygltf; and few readers take more.
constexpr std::size_t most_bytes = std::numeric_limits<int>::max();

constexpr std::size_t most_bytes_per_corner = (3 + 3 + 4 + 2 + 3) * sizeof(float) + sizeof(std::uint32_t);

/// Counts each corner of a face as a vertex, so that nothing has to be built to know.
bool fits(const TexturedMesh& mesh, const GlbPictures& pictures) {
    const std::size_t normal = pictures.normal_png ? pictures.normal_png->size() : 0;
    const std::size_t colour = pictures.colour_png ? pictures.colour_png->size() : 0;
    return normal < most_bytes && colour < most_bytes - normal &&
           mesh.base->faces.size() < (most_bytes - normal - colour) / (3 * most_bytes_per_corner);
}

bool finite_as_float32(const Vec3& value) {
    return to_float32(value).allFinite();
}

bool finite_as_float32(const TexturedMesh& mesh) {
    const auto finite = [](const Vec3& value) { return finite_as_float32(value); };
    return std::ranges::all_of(mesh.base->positions, finite) && std::ranges::all_of(mesh.base->directions, finite) &&
           std::ranges::all_of(mesh.uv, [](const auto& corners) {
               return std::ranges::all_of(
                   corners, [](const Eigen::Vector2d& uv) { return finite_as_float32(Vec3(uv.x(), uv.y(), 0)); });
           });
}

void require_glb(const std::filesystem::path& path, const TexturedMesh& mesh, const GlbPictures& pictures) {
    require_textured_mesh(path, mesh);
    if (!finite_as_float32(mesh)) {
        refuse_to_write(path, "the textured mesh has numbers beyond those of float32");
    }
    if (mesh.base->faces.empty()) {
        refuse_to_write(path, "glTF has no meshes without faces");
    }
    if (!fits(mesh, pictures)) {
        refuse_to_write(path, "the mesh and its pictures are too large for one file of 2 GiB");
    }
}

tinygltf::Value value_of(const nlohmann::json& json) {
    switch (json.type()) {
    case nlohmann::json::value_t::object: {
        tinygltf::Value::Object members;
        for (const auto& [name, member] : json.items()) {
            members[name] = value_of(member);
        }
        return tinygltf::Value(std::move(members));
    }
    case nlohmann::json::value_t::array: {
        tinygltf::Value::Array elements;
        std::ranges::transform(json, std::back_inserter(elements), value_of);
        return tinygltf::Value(std::move(elements));
    }
    case nlohmann::json::value_t::string: return tinygltf::Value(json.get<std::string>());
    case nlohmann::json::value_t::boolean: return tinygltf::Value(json.get<bool>());
    default: break;
    }
    if (!json.is_number()) {
        return {};
    }
    const auto number = json.get<double>();
    const bool is_int = json.is_number_integer() && number >= std::numeric_limits<int>::min() &&
                        number <= std::numeric_limits<int>::max();
    return is_int ? tinygltf::Value(json.get<int>()) : tinygltf::Value(number);
}

tinygltf::Value extras(const std::filesystem::path& path, const std::string& text) {
    const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
    if (!json.is_object()) {
        refuse_to_write(path, "what is to be said about the mesh is no JSON object");
    }
    return value_of({{"foldless", json}});
}

} // namespace

AtomicFile stage_glb(const std::filesystem::path& path, const TexturedMesh& mesh, const GlbPictures& pictures,
                     const GlbNotes& notes) {
    require_glb(path, mesh, pictures);
    AtomicFile file(path);
    tinygltf::Model model = glb_model(mesh, pictures);
    model.asset.generator = notes.generator;
    if (notes.extras_json) {
        model.meshes[0].extras = extras(path, *notes.extras_json);
    }
    FileStreamBuffer buffer(file);
    std::ostream stream(&buffer);
    stream.exceptions(std::ios::badbit);
    tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, stream, false, true);
    file.finish();
    return file;
}

} // namespace foldless
