#include "read_glb.h"

#include <foldless/io/byte_order.h>

#include <map>
#include <stdexcept>

namespace foldless {

namespace {

constexpr std::uint32_t magic = 0x46546C67;      // "glTF"
constexpr std::uint32_t json_chunk = 0x4E4F534A; // "JSON"
constexpr std::uint32_t binary_chunk = 0x004E4942;
constexpr int type_uint16 = 5123;
constexpr int type_uint32 = 5125;
constexpr int type_float = 5126;

void require(bool condition, const char* what) {
    if (!condition) {
        throw std::runtime_error(what);
    }
}

template <class Number>
Number number_at(const std::string& bytes, std::size_t offset) {
    require(offset + sizeof(Number) <= bytes.size(), "a number beyond the end");
    return load<Number>(bytes.data() + offset, std::endian::little);
}

/// The content of the chunk at `offset`, which it moves to the end of the chunk.
std::string chunk(const std::string& file, std::size_t& offset, std::uint32_t type) {
    const auto length = number_at<std::uint32_t>(file, offset);
    require(length % 4 == 0, "a chunk that is not aligned");
    require(number_at<std::uint32_t>(file, offset + 4) == type, "a chunk of another type");
    require(offset + 8 + length <= file.size(), "a chunk beyond the end");
    const std::string content = file.substr(offset + 8, length);
    offset += 8 + length;
    return content;
}

const nlohmann::json& primitive(const Glb& glb) {
    require(glb.json.at("meshes").size() == 1 && glb.json["meshes"][0].at("primitives").size() == 1, "not one mesh");
    return glb.json["meshes"][0]["primitives"][0];
}

template <class Number>
std::vector<Number> numbers(const Glb& glb, const nlohmann::json& accessor, std::size_t components) {
    const std::string bytes = view_bytes(glb, accessor.at("bufferView"));
    const std::size_t count = accessor.at("count").get<std::size_t>() * components;
    require(bytes.size() == count * sizeof(Number), "a view of another length");
    std::vector<Number> read;
    for (std::size_t i = 0; i < count; ++i) {
        read.push_back(number_at<Number>(bytes, i * sizeof(Number)));
    }
    return read;
}

} // namespace

Glb parse_glb(const std::string& file) {
    require(number_at<std::uint32_t>(file, 0) == magic, "no GLB");
    require(number_at<std::uint32_t>(file, 4) == 2, "not version 2");
    require(number_at<std::uint32_t>(file, 8) == file.size(), "another length");
    std::size_t offset = 12;
    Glb glb;
    glb.json = nlohmann::json::parse(chunk(file, offset, json_chunk));
    glb.bytes = chunk(file, offset, binary_chunk);
    require(offset == file.size(), "something behind the last chunk");
    return glb;
}

std::string view_bytes(const Glb& glb, int view) {
    const nlohmann::json& entry = glb.json.at("bufferViews").at(view);
    require(entry.at("buffer") == 0 && !entry.contains("byteStride"), "an unusual view");
    const auto offset = entry.value("byteOffset", std::size_t{0});
    const auto length = entry.at("byteLength").get<std::size_t>();
    require(offset + length <= glb.json.at("buffers").at(0).at("byteLength").get<std::size_t>(),
            "a view beyond the end");
    return glb.bytes.substr(offset, length);
}

std::vector<std::vector<float>> attribute(const Glb& glb, const std::string& name) {
    static const std::map<std::string, std::size_t> lengths{{"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
    const nlohmann::json& accessor = glb.json.at("accessors").at(primitive(glb).at("attributes").at(name).get<int>());
    require(accessor.at("componentType") == type_float, "not of floats");
    const std::size_t length = lengths.at(accessor.at("type"));
    const auto read = numbers<float>(glb, accessor, length);
    std::vector<std::vector<float>> vectors;
    for (auto first = read.begin(); first != read.end(); first += static_cast<std::ptrdiff_t>(length)) {
        vectors.emplace_back(first, first + static_cast<std::ptrdiff_t>(length));
    }
    return vectors;
}

std::vector<std::uint32_t> indices(const Glb& glb) {
    const nlohmann::json& accessor = glb.json.at("accessors").at(primitive(glb).at("indices").get<int>());
    require(accessor.at("type") == "SCALAR", "indices that are vectors");
    if (accessor.at("componentType") == type_uint16) {
        const auto read = numbers<std::uint16_t>(glb, accessor, 1);
        return {read.begin(), read.end()};
    }
    require(accessor.at("componentType") == type_uint32, "indices of an unusual type");
    return numbers<std::uint32_t>(glb, accessor, 1);
}

} // namespace foldless
