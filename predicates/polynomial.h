/// \file
/// Polynomials in one variable with exact coefficients, of the small degrees that displacements have. For the sources
/// of this layer only.
#pragma once

#include <foldless/predicates/filtered.h>

#include <cstddef>
#include <vector>

namespace foldless {

/// c[0] + c[1] t + ... The last coefficient is not zero; no coefficients are the zero polynomial.
class ExactPolynomial {
public:
    ExactPolynomial() = default;
    explicit ExactPolynomial(std::vector<Exact> coefficients);

    [[nodiscard]] bool is_zero() const { return c_.empty(); }
    /// -1 for the zero polynomial.
    [[nodiscard]] int degree() const { return static_cast<int>(c_.size()) - 1; }
    [[nodiscard]] const std::vector<Exact>& coefficients() const { return c_; }

    [[nodiscard]] Exact value(const Exact& t) const;
    [[nodiscard]] Sign sign_at(const Exact& t) const { return sign_of(value(t)); }
    [[nodiscard]] ExactPolynomial derivative() const;

    /// The Bernstein coefficients over [lo, hi], each times a positive integer: they have the signs of those.
    [[nodiscard]] std::vector<Exact> bernstein(const Exact& lo, const Exact& hi) const;

private:
    std::vector<Exact> c_;
};

/// How often the signs of the coefficients change, zeros left out: at least the number of roots strictly inside the
/// interval of a Bernstein form, and exactly that if it is 0 or 1. (Descartes' rule of signs)
[[nodiscard]] int sign_changes(const std::vector<Exact>& coefficients);

/// A greatest common divisor, by Euclid's algorithm with pseudo-remainders. \pre not both are zero
[[nodiscard]] ExactPolynomial gcd(const ExactPolynomial& f, const ExactPolynomial& g);

/// f divided by g times a power of the leading coefficient of g. \pre g divides f, and is not zero
[[nodiscard]] ExactPolynomial pseudo_quotient(const ExactPolynomial& f, const ExactPolynomial& g);

} // namespace foldless
