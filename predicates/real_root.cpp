#include <foldless/predicates/real_root.h>

#include <algorithm>
#include <utility>

namespace foldless {
namespace {

Exact middle(const Exact& a, const Exact& b) {
    return (a + b) * Exact(0.5);
}

/// The one sign of all coefficients that are not zero, or undecided: a polynomial has that sign strictly between the
/// ends of the interval of its Bernstein form.
Sign common_sign(const std::vector<Exact>& coefficients) {
    Sign common = Sign::undecided;
    for (const Exact& x : coefficients) {
        const Sign sign = sign_of(x);
        if (sign == Sign::zero) {
            continue;
        }
        if (common != Sign::undecided && common != sign) {
            return Sign::undecided;
        }
        common = sign;
    }
    return common;
}

/// Whether the polynomials have a common root strictly between lo and hi, where f has exactly one, a simple one, and is
/// not zero at the ends.
bool have_common_root(const ExactPolynomial& f, const ExactPolynomial& g, const Exact& lo, const Exact& hi) {
    const ExactPolynomial common = gcd(f, g);
    return common.degree() > 0 && common.sign_at(lo) != common.sign_at(hi);
}

const Exact& larger(const Exact& a, const Exact& b) {
    return sign_of(a - b) == Sign::negative ? b : a;
}
const Exact& smaller(const Exact& a, const Exact& b) {
    return sign_of(a - b) == Sign::negative ? a : b;
}

/// Descartes' method: f has simple roots only.
void isolate(const ExactPolynomial& f, const Exact& lo, const Exact& hi, std::vector<RealRoot>& roots) {
    const int changes = sign_changes(f.bernstein(lo, hi));
    if (changes == 0) {
        return;
    }
    const Sign at_lo = f.sign_at(lo);
    const Sign at_hi = f.sign_at(hi);
    if (changes == 1 && at_lo != Sign::zero && at_hi != Sign::zero) {
        roots.emplace_back(f, lo, hi);
        return;
    }
    const Exact mid = middle(lo, hi);
    isolate(f, lo, mid, roots);
    if (f.sign_at(mid) == Sign::zero) {
        roots.emplace_back(mid);
    }
    isolate(f, mid, hi, roots);
}

} // namespace

RealRoot::RealRoot(const Exact& value) : lo_(value), hi_(value), is_value_(true) {}

RealRoot::RealRoot(ExactPolynomial f, const Exact& lo, const Exact& hi)
    : f_(std::move(f)), lo_(lo), hi_(hi), at_lo_(f_.sign_at(lo)), is_value_(false) {}

void RealRoot::refine() {
    if (is_value_) {
        return;
    }
    const Exact mid = middle(lo_, hi_);
    const Sign sign = f_.sign_at(mid);
    if (sign == Sign::zero) {
        lo_ = mid;
        hi_ = mid;
        is_value_ = true;
    } else {
        (sign == at_lo_ ? lo_ : hi_) = mid;
    }
}

Sign sign_at(const RealRoot& root, const ExactPolynomial& g) {
    if (g.is_zero()) {
        return Sign::zero;
    }
    RealRoot at = root;
    for (bool first = true; !at.is_rational_value(); first = false) {
        const Sign sign = common_sign(g.bernstein(at.lo(), at.hi()));
        if (sign != Sign::undecided) {
            return sign;
        }
        if (first && have_common_root(at.polynomial(), g, at.lo(), at.hi())) {
            return Sign::zero;
        }
        at.refine();
    }
    return g.sign_at(at.lo());
}

Sign compare(RealRoot a, RealRoot b) {
    for (bool first = true; !a.is_rational_value() || !b.is_rational_value(); first = false) {
        // The intervals are open, or one number and an open interval: they are disjoint if they touch.
        if (sign_of(a.hi() - b.lo()) != Sign::positive) {
            return Sign::negative;
        }
        if (sign_of(b.hi() - a.lo()) != Sign::positive) {
            return Sign::positive;
        }
        if (a.is_rational_value() || b.is_rational_value()) {
            const RealRoot& value = a.is_rational_value() ? a : b;
            const RealRoot& other = a.is_rational_value() ? b : a;
            if (other.polynomial().sign_at(value.lo()) == Sign::zero) {
                return Sign::zero; // the only root within the open interval that holds the value
            }
        } else if (first &&
                   have_common_root(a.polynomial(), b.polynomial(), larger(a.lo(), b.lo()), smaller(a.hi(), b.hi()))) {
            return Sign::zero;
        }
        a.refine();
        b.refine();
    }
    return sign_of(a.lo() - b.lo());
}

std::vector<RealRoot> real_roots_in(const ExactPolynomial& f, const Exact& lo, const Exact& hi) {
    const bool has_one =
        sign_changes(f.bernstein(lo, hi)) == 1 && f.sign_at(lo) != Sign::zero && f.sign_at(hi) != Sign::zero;
    if (has_one) { // a simple one, by Descartes' rule: nearly always
        return {RealRoot(f, lo, hi)};
    }
    const ExactPolynomial repeated = gcd(f, f.derivative());
    const ExactPolynomial simple = repeated.degree() > 0 ? pseudo_quotient(f, repeated) : f;
    std::vector<RealRoot> roots;
    if (simple.sign_at(lo) == Sign::zero) {
        roots.emplace_back(lo);
    }
    if (sign_of(hi - lo) == Sign::positive) {
        isolate(simple, lo, hi, roots);
        if (simple.sign_at(hi) == Sign::zero) {
            roots.emplace_back(hi);
        }
    }
    return roots;
}

} // namespace foldless
