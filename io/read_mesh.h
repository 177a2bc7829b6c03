/// \file
/// Reading meshes: PLY, OBJ, OFF and STL by extension.
#pragma once

#include <foldless/io/base_mesh.h>
#include <foldless/io/errors.h>
#include <foldless/io/scan.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace foldless {

/// What a reader did that the user should know of.
struct ReadNotes {
    std::size_t fanned_polygons = 0;  ///< convex planar polygons that were fanned from their first vertex
    std::vector<std::string> ignored; ///< e.g. "colours", "texture coordinates", "materials"; each once, 20 at most
    std::size_t welded_vertices = 0;  ///< STL only: corners that were merged into others at exactly equal positions
};

struct ReadScan {
    Scan scan;
    ReadNotes notes;
};

/// Reads a mesh. Vertices and faces keep the order of the file, a fan standing in the place of its polygon; nothing is
/// welded, except that STL, which has no indices, is welded at exactly equal positions in order of first appearance.
/// Text without a declared type is read as double. The mesh may have defects (see defects.h), but indices are in range.
///
/// \throws UnreadableFile if the file cannot be read, or its bytes are not numbers and indices in range.
/// \throws RefusedMesh if polygons are not convex and planar (see polygon.h), or have fewer than three corners.
/// Memory is bounded by a multiple of the size of the file, whatever its header claims. Time O(n), for STL O(n log n).
[[nodiscard]] ReadScan read_scan(const std::filesystem::path& path);

struct ReadBaseMesh {
    BaseMesh base;
    ReadNotes notes;
};

/// Reads a base mesh: PLY with `nx ny nz` per vertex, or else per face, and optionally `t_min t_max` per face and
/// `scan_vertex` per vertex; or OBJ where all corners of a vertex name one `vn`. Without ranges in the file `ranges` is
/// empty; without scan vertices `scan_vertex` holds -1 for each vertex.
///
/// \throws UnreadableFile as read_scan, and if a scan_vertex is neither -1 nor the number of a vertex.
/// \throws RefusedMesh as read_scan, and if the mesh has no directions, several at a vertex, one that is not finite, or
/// a range that is not finite or has t_min > t_max.
[[nodiscard]] ReadBaseMesh read_base_mesh(const std::filesystem::path& path);

} // namespace foldless
