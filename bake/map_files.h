/// \file
/// The maps of an atlas as files in a folder.
#pragma once

#include <foldless/bake/atlas.h>
#include <foldless/bake/atlas_maps.h>

#include <foldless/images/image.h>
#include <foldless/io/atomic_file.h>
#include <foldless/io/base_mesh.h>

#include <filesystem>
#include <string>
#include <vector>

namespace foldless {

/// What a base mesh was baked to.
struct BakedAtlas {
    const BaseMesh* base;
    const Atlas* atlas;
    const AtlasMaps* maps;
};

/// Stages in the folder, which exists:
///  - `displacement.exr`: t, in units of the interpolated direction, float32, channel Y;
///  - `displacement.png`: the same in 16 bits: t = scale (value - mid_level);
///  - `mask.png`: 1 where the scan covers the base mesh, else 0; 8 bits;
///  - `vector.exr`: the displacement t d in model units as scale (value - 0.5), channels R, G, B, in the axes of the
///    base mesh, if the maps have it;
///  - `normal_object.png`: (n + 1) / 2 for the normal n of the scan, 8 bits, if the maps have it;
///  - `normal_tangent.png`: the same in the frames of `base.glb` (tangent_frames.h);
///  - `color.png`: the scan's colours, 8 bits, if the maps have them;
///  - `base.obj` and `base.mtl`: the base mesh with texture coordinates;
///  - `base.glb`: the same in float32, with directions, normals in their frames and colours;
///  - `maps.json`: what these are, with scales, mid-levels and the charts. docs/formats.md describes it.
/// Scale and mid-level stand in the images too.
///
/// \param generator the name and version of the program
/// \throws UnwritableFile
[[nodiscard]] std::vector<AtomicFile> stage_maps(const std::filesystem::path& folder, const BakedAtlas& baked,
                                                 const std::string& generator);

/// What a scan is given back from.
struct DisplacementMaps {
    Atlas atlas;
    Image displacement;
    Image mask;
};

/// Reads `maps.json`, `displacement.exr` and `mask.png` from a folder.
/// \param faces of the base mesh
/// \throws UnreadableFile if one cannot be read, they do not fit each other, or the charts are not those of a base mesh
/// of so many faces.
[[nodiscard]] DisplacementMaps read_maps(const std::filesystem::path& folder, std::size_t faces);

} // namespace foldless
