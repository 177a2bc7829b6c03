// Small scans under all options: what is decimated is certified, keeps to its options, and does not depend on the
// number of threads.

#include "drawn_scan.h"
#include "require.h"
#include "same_base.h"

#include <foldless/decimate/decimate.h>
#include <foldless/io/defects.h>
#include <foldless/io/errors.h>
#include <foldless/verify/verify.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace foldless::fuzz {
namespace {

std::optional<DecimateResult> decimated(const Scan& scan, const DecimateOptions& options) {
    try {
        return decimate(scan, options);
    } catch (const RefusedMesh&) {
        require(inspect(scan).defects.any(), "only what has a defect is refused");
        return std::nullopt;
    }
}

std::string first_violation(const VerifyResult& result) {
    const auto found = std::ranges::find_if(result.violations, [](std::size_t count) { return count > 0; });
    return found == result.violations.end()
               ? ""
               : std::string(name(static_cast<Violation>(found - result.violations.begin())));
}

void require_certified(const DecimateResult& result, const Scan& scan, const DecimateOptions& options) {
    VerifyOptions verify_options;
    verify_options.threads = 1;
    const VerifyResult proof = verify(result.base, scan, verify_options);
    require(proof.certified(), "what is decimated is certified: " + first_violation(proof));
    require(proof.level == (options.directions == Directions::face ? Level::vertices : Level::surface),
            "the whole surface is certified");
    if (options.max_displacement) {
        // The displacements that are measured are rounded.
        const double most = *options.max_displacement * (1 + 1e-12);
        require(-most <= proof.min_displacement && proof.max_displacement <= most, "displacements are bounded");
    }
}

void require_options_kept(const DecimateResult& result, const Scan& scan, const DecimateOptions& options) {
    require(!options.target_faces || result.base.faces.size() <= *options.target_faces ||
                result.stop_reason == StopReason::every_edge_refused,
            "the target is reached or every edge is refused");
    const Correspondence& places = result.correspondence;
    require(places.base_face.size() == scan.positions.size() && places.alpha.size() == scan.positions.size() &&
                places.t.size() == scan.positions.size(),
            "every scan vertex has an entry");
    for (std::size_t v = 0; v < scan.positions.size(); ++v) {
        const std::int32_t face = places.base_face[v];
        require(face >= -1 && face < static_cast<std::int32_t>(result.base.faces.size()), "an entry names a face");
        require(face < 0 || (places.alpha[v].allFinite() && std::isfinite(places.t[v])), "an entry is made of numbers");
    }
}

/// Two threads, and a callback that ends it after a while: each state is valid.
void require_any_state_certified(const Scan& scan, DecimateOptions options, const BaseMesh& base, int calls) {
    options.threads = 2;
    require(is_same(decimate(scan, options).base, base), "the result does not depend on the number of threads");
    options.progress = [&calls](const Progress&) { return calls-- > 0; };
    require_certified(decimate(scan, options), scan, options);
}

} // namespace
} // namespace foldless::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace foldless;
    using namespace foldless::fuzz;
    const auto [further, options, scan] = DrawnCase(ByteSource(data, size));
    const std::optional<DecimateResult> result = decimated(scan, options);
    if (result) {
        require_options_kept(*result, scan, options);
        require_certified(*result, scan, options);
        if (further < 8) {
            require_any_state_certified(scan, options, result->base, further);
        }
    }
    return 0;
}
