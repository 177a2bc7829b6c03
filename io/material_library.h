/// \file
/// Reads the pictures of an OBJ's materials. (Bourke, "MTL material format"; Wavefront, Advanced Visualizer, appendix
/// B5)
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace foldless {

struct Material {
    std::string name;
    std::string picture;      ///< its last `map_Kd`, as the file names it; "" if it has none
    bool has_options = false; ///< the picture is to be scaled, moved, ...: which, is not read
};

/// Reads `newmtl` and `map_Kd`, whatever their case; every other statement is passed over. Names go to the end of the
/// line and may have blanks. Time O(n).
///
/// \throws UnreadableFile if the bytes are not text, with `name` as the file.
[[nodiscard]] std::vector<Material> read_material_library(std::string_view text, const std::string& name);

} // namespace foldless
