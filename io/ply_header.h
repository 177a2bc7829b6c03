/// \file
/// The header of a PLY file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace foldless {

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Bytes of a value in a binary file.
[[nodiscard]] std::size_t size(PlyType type);

[[nodiscard]] bool is_integer(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type;
    std::optional<PlyType> count_type; ///< of a list; no value: a scalar
};

struct PlyElement {
    std::string name;
    std::uint64_t count;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyFormat format;
    std::vector<PlyElement> elements;  ///< in the order of the file
    std::vector<std::string> textures; ///< the pictures of `comment TextureFile PICTURE`, as VCGLIB writes it
    std::size_t bytes;                 ///< where the data begins
    std::size_t lines;                 ///< lines of the header, `end_header` included
};

/// Reads the header at the start of `bytes`. Lines end at LF, CR LF or CR.
/// \throws UnreadableFile, with `name` as the file.
[[nodiscard]] PlyHeader parse_ply_header(std::string_view bytes, const std::string& name);

} // namespace foldless
