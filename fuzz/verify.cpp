// Small base meshes, right and wrong, against their scans: the verifier says the same with filters and without, on one
// thread and on two.

#include "drawn_scan.h"
#include "require.h"

#include <foldless/decimate/decimate.h>
#include <foldless/io/errors.h>
#include <foldless/io/float32.h>
#include <foldless/predicates/sign_counts.h>
#include <foldless/verify/verify.h>

#include <cstdint>
#include <optional>
#include <utility>

namespace foldless::fuzz {
namespace {

/// Spoils one number or index, or leaves out an array. \pre base has a face
void spoil(BaseMesh& base, ByteSource& bytes) {
    const std::size_t vertex = bytes.bits<std::uint8_t>() % base.positions.size();
    const std::size_t face = bytes.bits<std::uint8_t>() % base.faces.size();
    const Vec3 change = 0.0625 * drawn_vector(bytes, Grain::fine);
    switch (bytes.below(9)) {
    case 0: base.positions[vertex] += change; break;
    case 1: base.directions[vertex] += change; break;
    case 2: base.directions[vertex] = -base.directions[vertex]; break;
    case 3: base.ranges[face].hi += std::abs(change.x()); break;
    case 4: base.ranges[face] = {0.5 * base.ranges[face].lo, 0.5 * base.ranges[face].hi}; break;
    case 5: base.scan_vertex[vertex] = bytes.below(8) - 1; break;
    case 6: std::swap(base.faces[face][0], base.faces[face][1]); break;
    case 7: base.faces[face][0] = static_cast<std::int32_t>(vertex); break;
    default: base.positions[vertex] = base.positions[static_cast<std::size_t>(base.faces[face][0])]; break;
    }
}

std::optional<VerifyResult> verified(const BaseMesh& base, const Scan& scan, int threads) {
    VerifyOptions options;
    options.threads = threads;
    try {
        return verify(base, scan, options);
    } catch (const RefusedMesh&) {
        return std::nullopt;
    }
}

void require_same(const std::optional<VerifyResult>& a, const std::optional<VerifyResult>& b, const char* what) {
    require(a.has_value() == b.has_value(), what);
    require(!a || (a->violations == b->violations && a->level == b->level &&
                   a->ambiguous_vertices == b->ambiguous_vertices && a->frozen_faces == b->frozen_faces),
            what);
}

std::optional<BaseMesh> decimated(const Scan& scan, DecimateOptions options) {
    if (options.directions == Directions::face) { // which are not proven exactly
        options.directions = Directions::visible;
    }
    try {
        return decimate(scan, options).base;
    } catch (const RefusedMesh&) {
        return std::nullopt;
    }
}

} // namespace
} // namespace foldless::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace foldless;
    using namespace foldless::fuzz;
    const DrawnCase drawn{ByteSource(data, size)};
    const Scan& scan = drawn.scan;
    std::optional<BaseMesh> base = decimated(scan, drawn.options);
    if (!base) {
        return 0;
    }
    ByteSource spoiling(data, size); // the same bytes once more: the scan may have taken all of them
    for (int faults = spoiling.below(4); faults > 0; --faults) {
        spoil(*base, spoiling);
    }
    if (spoiling.below(8) == 0) {
        base->ranges.clear();
    }
    const std::optional<VerifyResult> result = verified(*base, scan, 1);
    require_same(result, verified(*base, scan, 2), "the verdict does not depend on the number of threads");
    set_filters_enabled(false);
    require_same(result, verified(*base, scan, 1), "the verdict does not depend on filters");
    set_filters_enabled(true);
    return 0;
}
