/// \file
/// The answer of a predicate.
#pragma once

#include <limits>

namespace foldless {

/// The sign of a real number that is computed from exact inputs. A predicate that cannot tell says `undecided`; it
/// never guesses, and every guard refuses on it.
enum class Sign { negative, zero, positive, undecided };

/// The sign of the opposite number.
[[nodiscard]] constexpr Sign operator-(Sign sign) {
    switch (sign) {
    case Sign::negative: return Sign::positive;
    case Sign::positive: return Sign::negative;
    default: return sign;
    }
}

/// The sign of a number known as `value` with an absolute error of at most `error` (>= 0). NaN is undecided, and so is
/// infinity: of a sum with terms of both signs, one that overflowed hides the others.
[[nodiscard]] constexpr Sign sign_within(double value, double error) {
    constexpr double largest = std::numeric_limits<double>::max();
    if (value > error) {
        return value <= largest ? Sign::positive : Sign::undecided;
    }
    if (value < -error) {
        return value >= -largest ? Sign::negative : Sign::undecided;
    }
    return value == 0.0 && error == 0.0 ? Sign::zero : Sign::undecided;
}

} // namespace foldless
