/// \file
/// How many cases a test runs.
#pragma once

#include <algorithm>
#include <cstdlib>

namespace foldless {

/// A hundredth of `full`, or the share that FOLDLESS_SOAK says: 100 for all. At least one. The seeds of the tests are
/// fixed, so that fewer cases are the first of more.
inline int soak(int full) {
    const char* text = std::getenv("FOLDLESS_SOAK");
    const double factor = text == nullptr ? 1.0 : std::atof(text);
    return std::max(1, static_cast<int>(full * factor / 100));
}

} // namespace foldless
