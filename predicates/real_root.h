/// \file
/// Real roots of polynomials with exact coefficients: signs at them and comparisons between them are decided exactly,
/// with no separation bound. For the sources of this layer only.
#pragma once

#include <foldless/predicates/polynomial.h>
#include <foldless/predicates/sign.h>

#include <vector>

namespace foldless {

/// One simple root of a polynomial.
class RealRoot {
public:
    /// A number as such.
    explicit RealRoot(const Exact& value);
    /// The only root of f strictly between lo and hi, where f has opposite signs at both. \pre that is so
    RealRoot(ExactPolynomial f, const Exact& lo, const Exact& hi);

    [[nodiscard]] bool is_rational_value() const { return is_value_; }
    [[nodiscard]] const Exact& lo() const { return lo_; }
    [[nodiscard]] const Exact& hi() const { return hi_; }
    [[nodiscard]] const ExactPolynomial& polynomial() const { return f_; }

    /// Halves the interval.
    void refine();

private:
    ExactPolynomial f_;
    Exact lo_, hi_;
    Sign at_lo_ = Sign::zero;
    bool is_value_;
};

/// The sign of g at the root. A gcd with its polynomial decides zero; else the interval is halved until the Bernstein
/// coefficients of g over it have one sign.
[[nodiscard]] Sign sign_at(const RealRoot& root, const ExactPolynomial& g);

/// The sign of a - b.
[[nodiscard]] Sign compare(RealRoot a, RealRoot b);

/// The distinct roots of f in [lo, hi], ascending, whatever their multiplicity. \pre f is not zero, lo <= hi
[[nodiscard]] std::vector<RealRoot> real_roots_in(const ExactPolynomial& f, const Exact& lo, const Exact& hi);

} // namespace foldless
