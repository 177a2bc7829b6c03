/// \file
/// What a fuzzer holds against the code.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace foldless::fuzz {

/// Ends the program, which libFuzzer takes for a failure and keeps the input of, if what must hold does not.
inline void require(bool holds, const std::string& what) {
    if (!holds) {
        std::fprintf(stderr, "does not hold: %s\n", what.c_str());
        std::abort();
    }
}

} // namespace foldless::fuzz
