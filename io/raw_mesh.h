/// \file
/// A mesh as it comes out of a reader, before it becomes a scan or a base mesh.
#pragma once

#include <foldless/io/base_mesh.h>
#include <foldless/io/raw_appearance.h>
#include <foldless/io/read_mesh.h>
#include <foldless/io/scan.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foldless {

/// What a reader is asked to keep; the rest is noted as ignored.
enum class Content {
    scan,          ///< positions and faces
    coloured_scan, ///< colours, texture coordinates and materials too
    base_mesh,     ///< positions and faces, directions, ranges and scan vertices
};

/// A polygon of more than three corners, fanned from its first vertex into corners - 2 consecutive faces.
struct PolygonFan {
    std::size_t first_face;
    std::size_t corners;
};

/// Everything that the readers find. All indices are in range.
struct RawMesh {
    std::vector<Vec3> positions;
    std::vector<Vec3> normals;             ///< one per vertex, or empty
    std::vector<std::int32_t> scan_vertex; ///< one per vertex, or empty
    std::vector<Triangle> faces;
    std::vector<Range> ranges;        ///< one per face, or empty
    std::vector<Vec3> face_normals;   ///< one per face, or empty
    std::vector<PolygonFan> fans;     ///< in order of first_face
    std::size_t short_faces = 0;      ///< faces of fewer than three corners, which are not in `faces`
    std::size_t corner_conflicts = 0; ///< vertices to which the faces give different normals
    std::size_t missing_normals = 0;  ///< vertices to which a face gives no normal, while others have one
    RawAppearance appearance;         ///< of a coloured scan
    ReadNotes notes;

    /// Appends a polygon as a fan; returns how many faces that makes.
    std::size_t add_polygon(std::span<const std::int32_t> corners);
    /// Notes that the reader ignored something; each thing is noted once.
    void ignore(std::string_view what);
};

inline constexpr std::uint64_t max_vertices = 0x7fffffff; ///< an index is an int32
inline constexpr std::uint64_t max_faces = 0x55555555;    ///< the number of a face corner is an uint32

/// The message "vertex index 40000 is out of range (35947 vertices)".
[[nodiscard]] std::string out_of_range_text(std::int64_t index, std::uint64_t vertices);

/// The counts of polygons that are no convex planar polygons and of faces of fewer than three corners, "" if none.
[[nodiscard]] std::string refused_polygons_text(const RawMesh& mesh);

} // namespace foldless
