/// \file
/// The floating-point environment that all bounds on rounding rely on.
#pragma once

#include <cfenv>

namespace foldless {

/// While it lives, the thread rounds to nearest and keeps denormal numbers, whatever its caller has set; then the
/// caller's environment is back, its exception flags included. Threads of a TBB arena take over what was set where the
/// arena was made.
class DefaultArithmetic {
public:
    DefaultArithmetic() {
        std::fegetenv(&callers_);
        std::fesetenv(FE_DFL_ENV);
    }
    ~DefaultArithmetic() { std::fesetenv(&callers_); }
    DefaultArithmetic(const DefaultArithmetic&) = delete;
    DefaultArithmetic& operator=(const DefaultArithmetic&) = delete;

private:
    std::fenv_t callers_{};
};

} // namespace foldless
