/// \file
/// Writes a textured base mesh as OBJ with a material file.
#pragma once

#include <foldless/bake/textured_mesh.h>
#include <foldless/io/atomic_file.h>
#include <foldless/io/errors.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace foldless {

/// Names of picture files, relative to the folder of the material file.
struct MtlPictures {
    std::optional<std::string> colour; ///< `map_Kd`
    std::optional<std::string> normal; ///< `norm` and `map_Bump`: half of the readers know the one, half the other
    std::optional<std::string> displacement; ///< `disp`
};

/// Writes PATH.obj and, beside it, PATH.mtl under temporary names. The result holds the material file first, then the
/// OBJ, so that commit_all() never leaves an OBJ without its materials.
///
/// The OBJ has `v`, all of the base mesh in its order; `vt` with v *up*, each pair of numbers once; `vn`, the
/// displacement directions as stored, if the base mesh has them; and `f v/vt/vn`. read_base_mesh() reads the same base
/// mesh back. Numbers are the shortest decimals that read back as the same double. `comments` go to the head of the
/// OBJ, one line each.
///
/// Readers disagree on whether a blank ends a name in these files. So a name with blanks is *refused*, and so is one
/// with
/// `#`, `\`, quotes or control characters, or a `-` in front, be it that of the material file or of a picture. The
/// folders on the way to PATH may have any name.
///
/// \throws UnwritableFile if the system refuses; if PATH does not end in .obj, or a name is refused; if the arrays
/// differ in length, an index is out of range, a number is not finite, or the base mesh has directions of faces.
[[nodiscard]] std::vector<AtomicFile> stage_textured_obj(const std::filesystem::path& path, const TexturedMesh& mesh,
                                                         const MtlPictures& pictures,
                                                         const std::vector<std::string>& comments);

} // namespace foldless
