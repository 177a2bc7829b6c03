/// \file
/// The real roots of a cubic whose coefficients are known up to rounding.
#pragma once

#include <array>
#include <cmath>
#include <optional>

namespace foldless {

/// The polynomial a t^3 + b t^2 + c t + d. Any coefficient may be zero.
struct Cubic {
    double a = 0.0;
    double b = 0.0;
    double c = 0.0;
    double d = 0.0;

    [[nodiscard]] double value(double t) const { return ((a * t + b) * t + c) * t + d; }
    [[nodiscard]] double slope(double t) const { return (3.0 * a * t + 2.0 * b) * t + c; }
};

/// Up to three real roots in ascending order.
struct RealRoots {
    std::array<double, 3> t{};
    int count = 0;
    bool everywhere = false; ///< the polynomial vanishes identically, and `count` is 0

    [[nodiscard]] const double* begin() const { return t.data(); }
    [[nodiscard]] const double* end() const { return t.data() + count; }
};

/// The bound |a| |t|^3 + |b| t^2 + |c| |t| + |d| on how far a polynomial moves when each coefficient moves by at most
/// the one of `error`.
[[nodiscard]] inline double error_at(const Cubic& error, double t) {
    return error.value(std::abs(t));
}

/// The real roots of `cubic`, whose coefficients are known with the absolute errors `error` (each >= 0).
///
/// A leading coefficient that is hidden by its error is taken as zero, so that the degree drops as far as it may. A
/// local extremum whose value is hidden is one root, reported once: a double root is neither missed nor doubled. A
/// triple root may appear as a cluster as wide as the errors allow. Coefficients that are not finite have no roots.
///
/// Closed form (Cardano; Vieta's cosines) for the root farthest from the inflection, which is the well-conditioned
/// one; deflation in the direction that is backward stable (Kahan 1986, "To solve a real cubic equation"); Newton's
/// method on the polynomial itself for every root. No allocation, constant time.
[[nodiscard]] RealRoots real_roots(const Cubic& cubic, const Cubic& error);

/// The same for coefficients that are exact.
[[nodiscard]] RealRoots real_roots(const Cubic& cubic);

/// Steps of Newton's method in a range: at worst each halves it.
inline constexpr int most_newton_steps = 100;

/// The last step, relative to t: the one after would be of the size of its square.
inline constexpr double last_newton_step = 1e-9;

/// The roots in a range over which the cubic certainly rises, of which there is at most one; nothing if it
/// may not rise everywhere, or may be zero at an end. Newton's method from where the chord of the range is zero, kept
/// within the range. Far cheaper than all roots.
[[nodiscard]] std::optional<RealRoots> rising_root(const Cubic& cubic, const Cubic& error, double lo, double hi);

} // namespace foldless
