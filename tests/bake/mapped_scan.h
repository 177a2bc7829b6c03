/// \file
/// Decimated scans with the map that verify gives, for the tests of baking.
#pragma once

#include <foldless/decimate/decimate.h>
#include <foldless/io/scan.h>
#include <foldless/models/shape.h>
#include <foldless/verify/surface_map.h>

#include <cstddef>
#include <cstdint>

namespace foldless::test {

struct MappedScan {
    Scan scan;
    BaseMesh base;
    SurfaceMap map;
};

/// Of a base mesh that is certified; a test fails if this one is not.
[[nodiscard]] MappedScan mapped(const Scan& scan, const BaseMesh& base);

/// Decimated on one thread.
[[nodiscard]] MappedScan decimated(const Scan& scan, DecimateOptions options);

/// A generated model of at most so many faces, decimated to so many, or as far as it goes.
[[nodiscard]] MappedScan decimated_model(Shape shape, std::int64_t faces, std::size_t target);

} // namespace foldless::test
