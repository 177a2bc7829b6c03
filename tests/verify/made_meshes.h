/// \file
/// Small base meshes and scans that they represent by construction.
#pragma once

#include <foldless/io/base_mesh.h>
#include <foldless/io/scan.h>

namespace foldless::test {

struct Pair {
    BaseMesh base;
    Scan scan;
};

/// An octahedron with its vertices at distance 1 and directions d_i = v_i: the point X moves to (1 + t) X, so the
/// prismoids are the eight octants and every star-shaped closed surface around the origin is represented. Ranges as
/// given.
[[nodiscard]] BaseMesh octahedron(Range range = {-0.5, 1.5});

/// A subdivided octahedron on a bumpy sphere of radius about 1, turned so that none of its elements meets a wall or
/// pillar of octahedron() by symmetry. 8 * 4^levels faces.
[[nodiscard]] Scan turned_sphere(int levels);

/// The same without the turn: scan vertices on every pillar and many on the walls, scan edges in the walls.
[[nodiscard]] Scan aligned_sphere(int levels);

/// A square of two triangles, [0, 1]^2 at z = 0, its corners kept as the scan vertices 0 to 3; directions up.
///
///     3 --- 2
///     |   / |
///     | /   |
///     0 --- 1
[[nodiscard]] BaseMesh square(Range range = {-1, 1});

/// The square with one more vertex inside, at the given position: four triangles, the border that of square().
[[nodiscard]] Scan pyramid(const Vec3& top);

/// A grid of side^2 cells over [low, high]^2 at height z(x, y) = height x y.
[[nodiscard]] Scan grid(int side, double low, double high, double height);

/// A double pyramid, its poles first, over a polygon that goes `laps` times round the axis.
[[nodiscard]] Scan bipyramid(int corners, int laps);

/// The same with nothing exactly over another: its poles are off the axis, its polygon is turned and lifted.
[[nodiscard]] Scan bipyramid_off_centre(int corners, int laps);

} // namespace foldless::test
