#include <foldless/predicates/polynomial.h>

#include <algorithm>
#include <utility>

namespace foldless {
namespace {

struct Division {
    ExactPolynomial quotient;
    ExactPolynomial remainder;
};

/// lc(g)^k f = quotient g + remainder, with k the number of steps.
Division pseudo_divide(const ExactPolynomial& f, const ExactPolynomial& g) {
    std::vector<Exact> rest = f.coefficients();
    const std::vector<Exact>& divisor = g.coefficients();
    std::vector<Exact> quotient(rest.size() >= divisor.size() ? rest.size() - divisor.size() + 1 : 0, Exact(0));
    while (rest.size() >= divisor.size()) {
        const Exact lead = rest.back();
        const std::size_t shift = rest.size() - divisor.size();
        for (Exact& x : quotient) {
            x = x * divisor.back();
        }
        quotient[shift] = quotient[shift] + lead;
        for (Exact& x : rest) {
            x = x * divisor.back();
        }
        for (std::size_t i = 0; i < divisor.size(); ++i) {
            rest[shift + i] = rest[shift + i] - lead * divisor[i];
        }
        rest.pop_back(); // zero by construction
    }
    return {ExactPolynomial(std::move(quotient)), ExactPolynomial(std::move(rest))};
}

/// p(x + t) in place, by repeated synthetic division.
void shift(std::vector<Exact>& p, const Exact& x) {
    for (std::size_t i = 0; i + 1 < p.size(); ++i) {
        for (std::size_t k = p.size() - 1; k-- > i;) {
            p[k] = p[k] + x * p[k + 1];
        }
    }
}

} // namespace

ExactPolynomial::ExactPolynomial(std::vector<Exact> coefficients) : c_(std::move(coefficients)) {
    while (!c_.empty() && sign_of(c_.back()) == Sign::zero) {
        c_.pop_back();
    }
}

Exact ExactPolynomial::value(const Exact& t) const {
    Exact result(0);
    for (std::size_t i = c_.size(); i-- > 0;) {
        result = result * t + c_[i];
    }
    return result;
}

ExactPolynomial ExactPolynomial::derivative() const {
    std::vector<Exact> result;
    for (std::size_t i = 1; i < c_.size(); ++i) {
        result.push_back(c_[i] * Exact(static_cast<double>(i)));
    }
    return ExactPolynomial(std::move(result));
}

std::vector<Exact> ExactPolynomial::bernstein(const Exact& lo, const Exact& hi) const {
    // p(u) = f(lo + (hi - lo) u); then (1 + u)^n p(1 / (1 + u)) has the coefficients binomial(n, k) b_k.
    std::vector<Exact> p = c_;
    shift(p, lo);
    const Exact width = hi - lo;
    Exact power(1);
    for (Exact& x : p) {
        x = x * power;
        power = power * width;
    }
    std::reverse(p.begin(), p.end());
    shift(p, Exact(1));
    return p;
}

int sign_changes(const std::vector<Exact>& coefficients) {
    int changes = 0;
    Sign last = Sign::zero;
    for (const Exact& x : coefficients) {
        const Sign sign = sign_of(x);
        if (sign == Sign::zero) {
            continue;
        }
        changes += last != Sign::zero && last != sign ? 1 : 0;
        last = sign;
    }
    return changes;
}

ExactPolynomial gcd(const ExactPolynomial& f, const ExactPolynomial& g) {
    ExactPolynomial a = f;
    ExactPolynomial b = g;
    while (!b.is_zero()) {
        ExactPolynomial rest = pseudo_divide(a, b).remainder;
        a = std::exchange(b, std::move(rest));
    }
    return a;
}

ExactPolynomial pseudo_quotient(const ExactPolynomial& f, const ExactPolynomial& g) {
    return pseudo_divide(f, g).quotient;
}

} // namespace foldless
