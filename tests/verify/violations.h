/// \file
/// Reading verification results in tests.
#pragma once

#include <foldless/verify/verify.h>

#include <gmock/gmock.h>

#include <ostream>
#include <string>

namespace foldless {

inline void PrintTo(const VerifyResult& result, std::ostream* out) {
    for (std::size_t kind = 0; kind < violation_count; ++kind) {
        if (result.violations[kind] > 0) {
            *out << name(static_cast<Violation>(kind)) << " " << result.violations[kind] << "; ";
        }
    }
    *out << result.ambiguous_vertices << " ambiguous, " << result.uncovered_fraction << " uncovered";
}

namespace test {

inline std::size_t count(const VerifyResult& result, Violation violation) {
    return result.violations[static_cast<std::size_t>(violation)];
}

/// The result has violations of this kind.
MATCHER_P(Has, violation, std::string("has ") + std::string(name(violation))) {
    return count(arg, violation) > 0;
}

/// The result has violations of this kind and of no other.
MATCHER_P(HasOnly, violation, std::string("has only ") + std::string(name(violation))) {
    return count(arg, violation) > 0 && count(arg, violation) == arg.violation_total();
}

MATCHER(IsCertified, "is certified") {
    return arg.certified();
}

} // namespace test
} // namespace foldless
