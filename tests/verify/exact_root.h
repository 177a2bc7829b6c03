/// \file
/// Polynomials with rational coefficients and their real roots, for the oracle of surfaces. Slow, plain, and of no use
/// to anything else: it shares no code with the library.
#pragma once

#include <CGAL/Gmpq.h>

#include <vector>

namespace foldless::oracle {

using Number = CGAL::Gmpq;

/// Coefficients from the constant upwards; the last one is not zero, so that the zero polynomial has none.
class Polynomial {
public:
    Polynomial() = default;
    Polynomial(std::vector<Number> coefficients);

    [[nodiscard]] bool is_zero() const { return c_.empty(); }
    [[nodiscard]] int degree() const { return static_cast<int>(c_.size()) - 1; }
    [[nodiscard]] const Number& operator[](int k) const { return c_[k]; }
    [[nodiscard]] const std::vector<Number>& coefficients() const { return c_; }
    [[nodiscard]] Number at(const Number& x) const;
    [[nodiscard]] int sign_at(const Number& x) const;

private:
    std::vector<Number> c_;
};

Polynomial operator+(const Polynomial& a, const Polynomial& b);
Polynomial operator-(const Polynomial& a, const Polynomial& b);
Polynomial operator*(const Polynomial& a, const Polynomial& b);
Polynomial operator*(const Number& a, const Polynomial& b);

/// The only root of a polynomial without multiple roots in an open interval, or a rational number (lo = hi). Questions
/// narrow the interval.
class Root {
public:
    explicit Root(const Number& rational) : lo_(rational), hi_(rational) {}
    Root(Polynomial of, const Number& lo, const Number& hi);

    [[nodiscard]] bool is_rational() const { return lo_ == hi_; }
    [[nodiscard]] const Number& lo() const { return lo_; }
    [[nodiscard]] const Number& hi() const { return hi_; }
    [[nodiscard]] double approximate() const { return CGAL::to_double(lo_); }

    /// Halves the interval.
    void narrow();
    /// The sign of another polynomial there.
    [[nodiscard]] int sign_of(const Polynomial& f);
    /// -1, 0, 1 as this is below, at or above the other.
    [[nodiscard]] int compare(Root& other);

private:
    Polynomial of_;
    int sign_at_lo_ = 0;
    Number lo_;
    Number hi_;
};

/// All different roots in [lo, hi], ascending. \pre p is not zero
[[nodiscard]] std::vector<Root> roots(const Polynomial& p, const Number& lo, const Number& hi);

/// A rational number strictly between two roots, a < b.
[[nodiscard]] Number between(Root& a, Root& b);

} // namespace foldless::oracle
