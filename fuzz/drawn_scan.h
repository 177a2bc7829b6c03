/// \file
/// Small scans and options for the decimator.
#pragma once

#include "byte_source.h"

#include <foldless/decimate/decimate.h>
#include <foldless/io/scan.h>

namespace foldless::fuzz {

/// A height field, a closed surface or a torus of up to about a hundred vertices, with a few faces taken out, split or
/// glued; or faces without any order, of which most are refused. Coordinates are of one grain, in any unit.
[[nodiscard]] Scan drawn_scan(ByteSource& bytes);

/// All options but those of time; on one thread.
[[nodiscard]] DecimateOptions drawn_options(ByteSource& bytes);

/// What the fuzzers `decimate` and `verify` make of an input.
struct DrawnCase {
    int further; ///< 0 to 63: what else to ask
    DecimateOptions options;
    Scan scan; ///< last, since it may take all bytes

    explicit DrawnCase(ByteSource bytes)
        : further(bytes.below(64)), options(drawn_options(bytes)), scan(drawn_scan(bytes)) {}
};

} // namespace foldless::fuzz
