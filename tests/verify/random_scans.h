/// \file
/// Small scans at random, all coordinates float32.
#pragma once

#include <foldless/io/scan.h>

#include <cstdint>
#include <random>

namespace foldless::test {

using Random = std::mt19937_64;

/// A number of [lo, hi), the same with every library: distributions of the standard are not.
[[nodiscard]] double uniform(Random& random, double lo, double hi);
/// A number of 0 to n - 1.
[[nodiscard]] int index(Random& random, std::size_t n);

/// A closed scan of 20 to 200 faces: a sphere or a torus with bumps, stretched, turned, its vertices shaken, and here
/// and there a face split into three. Every position differs from every other.
[[nodiscard]] Scan random_closed_scan(Random& random);

/// The same with one border: a height field, or a closed one without the star of a vertex.
[[nodiscard]] Scan random_open_scan(Random& random);

/// The scan with its vertices in another order.
[[nodiscard]] Scan renumbered(const Scan& scan, Random& random);

/// The scan with its faces in another order, and other corners first.
[[nodiscard]] Scan reordered(const Scan& scan, Random& random);

/// The mirror image in the plane x = 0, every face turned over.
[[nodiscard]] Scan mirrored(const Scan& scan);

[[nodiscard]] Scan scaled(const Scan& scan, double factor);

/// Leaves out the faces around a vertex; the vertex stays, unused.
[[nodiscard]] Scan without_star(const Scan& scan, std::int32_t vertex);

} // namespace foldless::test
