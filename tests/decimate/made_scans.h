/// \file
/// Scans for the tests of decimation: a few written out, the others made by a formula. All coordinates are float32.
#pragma once

#include <foldless/io/scan.h>

namespace foldless::test {

/// A roof over the square [0, 1]^2 at z = 0: its corners 0 to 3 and the given top 4, which may lie anywhere.
///
///     3 ----- 2
///     | \   / |
///     |   4   |
///     | /   \ |
///     0 ----- 1
[[nodiscard]] Scan pyramid(const Vec3& top);

/// A closed surface around the origin: an octahedron, split `levels` times, turned, with bumps. 8 * 4^levels faces.
[[nodiscard]] Scan bumpy_sphere(int levels);

/// A torus of around * across cells about the z axis, radii 1 and 0.4; genus 1.
[[nodiscard]] Scan torus(int around, int across);

/// A height field over [0, 1]^2 of side * side cells and the given amplitude; 0 makes it flat, all ties.
[[nodiscard]] Scan terrain(int side, double amplitude);

/// Four unit cubes around the origin such that faces with the normals +y and -y meet there: no direction sees all faces
/// at the origin, and it is the only such vertex. Every side is cut into k * k cells; 36 k^2 faces, closed, genus 0.
[[nodiscard]] Scan skew_cubes(int k);

/// A closed scan around the z axis: poles 0 and 1, and `count` vertices that go `turns` times round between them.
[[nodiscard]] Scan spindle(int count, int turns);

/// The vertex with the given position, or -1.
[[nodiscard]] std::int32_t vertex_at(const Scan& scan, const Vec3& position);

} // namespace foldless::test
