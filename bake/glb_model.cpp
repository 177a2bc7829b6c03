#include <foldless/bake/glb_model.h>

#include <foldless/bake/split_vertices.h>
#include <foldless/bake/vertex_frames.h>
#include <foldless/io/byte_order.h>

#include <limits>
#include <string_view>

namespace foldless {

namespace {

// glTF wants the numbers of a view at a multiple of their size, at most this.
constexpr std::size_t alignment = 4; // bytes

/// Adds a view of the bytes, aligned, and returns its number. `target` is what they are for, 0 for pictures.
int add_view(tinygltf::Model& model, std::string_view bytes, int target) {
    std::vector<unsigned char>& data = model.buffers[0].data;
    data.resize((data.size() + alignment - 1) / alignment * alignment);
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = data.size();
    view.byteLength = bytes.size();
    view.target = target;
    data.insert(data.end(), bytes.begin(), bytes.end());
    model.bufferViews.push_back(view);
    return static_cast<int>(model.bufferViews.size()) - 1;
}

int add_accessor(tinygltf::Model& model, tinygltf::Accessor accessor, std::string_view bytes, int target) {
    accessor.bufferView = add_view(model, bytes, target);
    model.accessors.push_back(std::move(accessor));
    return static_cast<int>(model.accessors.size()) - 1;
}

/// Adds an attribute of the vertices; `value(vertex)` is a vector of floats.
template <class Value>
int add_attribute(tinygltf::Model& model, std::size_t vertices, const Value& value) {
    tinygltf::Accessor accessor;
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
    accessor.count = vertices;
    accessor.type = static_cast<int>(value(0).size()); // tinygltf's types of vectors are their lengths
    std::string bytes;
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
        const auto floats = value(vertex);
        for (const float number : floats) {
            append_little_endian(bytes, number);
        }
    }
    return add_accessor(model, std::move(accessor), bytes, TINYGLTF_TARGET_ARRAY_BUFFER);
}

static_assert(TINYGLTF_TYPE_VEC2 == 2 && TINYGLTF_TYPE_VEC3 == 3 && TINYGLTF_TYPE_VEC4 == 4);

/// glTF demands the bounds of the positions, exactly as stored.
void set_bounds(tinygltf::Accessor& accessor, const BaseMesh& base, const SplitVertices& split) {
    Eigen::Array3f least = Eigen::Array3f::Constant(std::numeric_limits<float>::infinity());
    Eigen::Array3f most = -least;
    for (const std::int32_t vertex : split.base_vertex) {
        const Eigen::Array3f position = base.positions[vertex].cast<float>();
        least = least.min(position);
        most = most.max(position);
    }
    accessor.minValues.assign(least.begin(), least.end());
    accessor.maxValues.assign(most.begin(), most.end());
}

template <class Index>
int add_indices(tinygltf::Model& model, const SplitVertices& split, int component_type) {
    tinygltf::Accessor accessor;
    accessor.componentType = component_type;
    accessor.count = 3 * split.faces.size();
    accessor.type = TINYGLTF_TYPE_SCALAR;
    std::string bytes;
    for (const auto& face : split.faces) {
        for (const std::uint32_t vertex : face) {
            append_little_endian(bytes, static_cast<Index>(vertex));
        }
    }
    return add_accessor(model, std::move(accessor), bytes, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
}

/// The largest index of a type is not for a vertex: hardware starts anew at it.
int add_indices(tinygltf::Model& model, const SplitVertices& split) {
    return split.uv.size() <= std::numeric_limits<std::uint16_t>::max()
               ? add_indices<std::uint16_t>(model, split, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT)
               : add_indices<std::uint32_t>(model, split, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
}

tinygltf::Primitive add_primitive(tinygltf::Model& model, const TexturedMesh& mesh, bool tangents) {
    const SplitVertices split = split_vertices(mesh);
    const std::size_t vertices = split.uv.size();
    const auto of_base_vertex = [&](const std::vector<Vec3>& values) {
        return [&](std::size_t vertex) { return Eigen::Vector3f(values[split.base_vertex[vertex]].cast<float>()); };
    };
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.attributes["POSITION"] = add_attribute(model, vertices, of_base_vertex(mesh.base->positions));
    set_bounds(model.accessors.back(), *mesh.base, split);
    const std::vector<Vec3> normals = vertex_normals(*mesh.base);
    primitive.attributes["NORMAL"] = add_attribute(model, vertices, of_base_vertex(normals));
    if (tangents) {
        const std::vector<Eigen::Vector4d> values = vertex_tangents(*mesh.base, split, normals);
        primitive.attributes["TANGENT"] = add_attribute(
            model, vertices, [&](std::size_t vertex) { return Eigen::Vector4f(values[vertex].cast<float>()); });
    }
    primitive.attributes["TEXCOORD_0"] =
        add_attribute(model, vertices, [&](std::size_t vertex) { return split.uv[vertex]; });
    if (!mesh.base->directions.empty()) {
        primitive.attributes["_DISPLACEMENT_DIRECTION"] =
            add_attribute(model, vertices, of_base_vertex(mesh.base->directions));
    }
    primitive.indices = add_indices(model, split);
    return primitive;
}

/// Adds a picture with its sampler and returns the number of the texture.
int add_texture(tinygltf::Model& model, const std::string& png) {
    if (model.samplers.empty()) {
        tinygltf::Sampler sampler;
        sampler.minFilter = sampler.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
        sampler.wrapS = sampler.wrapT = TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
        model.samplers.push_back(sampler);
    }
    tinygltf::Image image;
    image.mimeType = "image/png";
    image.bufferView = add_view(model, png, 0);
    model.images.push_back(image);
    tinygltf::Texture texture;
    texture.sampler = 0;
    texture.source = static_cast<int>(model.images.size()) - 1;
    model.textures.push_back(texture);
    return static_cast<int>(model.textures.size()) - 1;
}

tinygltf::Material material(tinygltf::Model& model, const GlbPictures& pictures) {
    tinygltf::Material material;
    material.pbrMetallicRoughness.metallicFactor = 0;
    material.pbrMetallicRoughness.roughnessFactor = 1;
    if (pictures.colour_png) {
        material.pbrMetallicRoughness.baseColorTexture.index = add_texture(model, *pictures.colour_png);
    }
    if (pictures.normal_png) {
        material.normalTexture.index = add_texture(model, *pictures.normal_png);
    }
    return material;
}

} // namespace

tinygltf::Model glb_model(const TexturedMesh& mesh, const GlbPictures& pictures) {
    tinygltf::Model model;
    model.buffers.emplace_back();
    model.meshes.emplace_back().primitives.push_back(add_primitive(model, mesh, pictures.normal_png.has_value()));
    model.meshes[0].primitives[0].material = 0;
    model.materials.push_back(material(model, pictures));
    model.nodes.emplace_back().mesh = 0;
    model.scenes.emplace_back().nodes = {0};
    model.defaultScene = 0;
    return model;
}

} // namespace foldless
