/// \file
/// Reads GLB files by the words of the specification, without the library that wrote them.
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace foldless {

struct Glb {
    nlohmann::json json;
    std::string bytes; ///< the binary chunk, with its padding
};

/// \throws std::runtime_error if the header or a chunk is not as specified (glTF 2.0, 4.4)
[[nodiscard]] Glb parse_glb(const std::string& file);

/// The bytes of a buffer view.
[[nodiscard]] std::string view_bytes(const Glb& glb, int view);

/// The vectors of an attribute of the only primitive; their length is that of the accessor's type.
/// \throws std::exception if there is no such attribute, or it is not of floats
[[nodiscard]] std::vector<std::vector<float>> attribute(const Glb& glb, const std::string& name);

/// The indices of the only primitive.
[[nodiscard]] std::vector<std::uint32_t> indices(const Glb& glb);

} // namespace foldless
