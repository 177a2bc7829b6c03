#include "exact_root.h"

#include <algorithm>
#include <utility>

namespace foldless::oracle {
namespace {

int sign(const Number& x) {
    return x > 0 ? 1 : x < 0 ? -1 : 0;
}

Polynomial derivative(const Polynomial& p) {
    std::vector<Number> c;
    for (int k = 1; k <= p.degree(); ++k) {
        c.push_back(Number(k) * p[k]);
    }
    return c;
}

struct Division {
    Polynomial quotient;
    Polynomial remainder;
};

Division divide(const Polynomial& a, const Polynomial& b) {
    std::vector<Number> rest = a.coefficients();
    std::vector<Number> quotient(static_cast<std::size_t>(std::max(0, a.degree() - b.degree() + 1)), Number(0));
    for (int k = a.degree() - b.degree(); k >= 0; --k) {
        quotient[k] = rest[k + b.degree()] / b[b.degree()];
        for (int i = 0; i <= b.degree(); ++i) {
            rest[k + i] -= quotient[k] * b[i];
        }
    }
    return {quotient, rest};
}

Polynomial monic(const Polynomial& p) {
    return p.is_zero() ? p : (Number(1) / p[p.degree()]) * p;
}

Polynomial common_divisor(Polynomial a, Polynomial b) {
    while (!b.is_zero()) {
        a = std::exchange(b, monic(divide(a, b).remainder));
    }
    return monic(a);
}

/// Sturm's chain of a polynomial without multiple roots.
class Sturm {
public:
    explicit Sturm(const Polynomial& p) : chain_{p, derivative(p)} {
        while (chain_.back().degree() > 0) {
            const Polynomial rest = divide(chain_[chain_.size() - 2], chain_.back()).remainder;
            chain_.push_back(Number(-1) * rest);
        }
    }

    /// The number of roots between two points that are none.
    [[nodiscard]] int count(const Number& a, const Number& b) const { return changes(a) - changes(b); }

private:
    [[nodiscard]] int changes(const Number& x) const {
        int last = 0;
        int result = 0;
        for (const Polynomial& p : chain_) {
            const int here = p.sign_at(x);
            result += here != 0 && last != 0 && here != last ? 1 : 0;
            last = here != 0 ? here : last;
        }
        return result;
    }

    std::vector<Polynomial> chain_;
};

/// Appends the roots in the open interval, whose ends are none. \pre no multiple roots
void isolate(const Polynomial& p, const Number& lo, const Number& hi, std::vector<Root>& out) {
    if (p.degree() < 1) {
        return;
    }
    if (p.degree() == 1) {
        const Number root = -p[0] / p[1];
        if (lo < root && root < hi) {
            out.emplace_back(root);
        }
        return;
    }
    const int count = Sturm(p).count(lo, hi);
    if (count == 0) {
        return;
    }
    if (count == 1) {
        out.emplace_back(p, lo, hi);
        return;
    }
    const Number mid = (lo + hi) / 2;
    Polynomial rest = p;
    if (p.sign_at(mid) == 0) {
        rest = divide(p, Polynomial({-mid, Number(1)})).quotient;
        out.emplace_back(mid);
    }
    isolate(rest, lo, mid, out);
    isolate(rest, mid, hi, out);
}

/// Takes the root x out of the polynomial, if it is one.
bool take_out(Polynomial& p, const Number& x) {
    if (p.sign_at(x) != 0) {
        return false;
    }
    p = divide(p, Polynomial({-x, Number(1)})).quotient;
    return true;
}

/// Whether Bernstein coefficients show that there is no root in [lo, hi]: most polynomials have none.
bool has_none(const Polynomial& p, const Number& lo, const Number& hi) {
    const int n = p.degree();
    if (n > 3) {
        return false;
    }
    // p(lo + u h) = sum c_k u^k, whose Bernstein coefficients are b_i = sum_{k <= i} C(i,k)/C(n,k) c_k.
    static constexpr int binomial[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};
    std::vector<Number> c = p.coefficients();
    for (int i = 0; i < n; ++i) {
        for (int k = n - 1; k >= i; --k) {
            c[k] += lo * c[k + 1];
        }
    }
    const Number h = hi - lo;
    Number power(1);
    for (int k = 0; k <= n; ++k, power *= h) {
        c[k] = c[k] * power / Number(binomial[n][k]);
    }
    const int first = sign(c[0]);
    for (int i = 0; i <= n; ++i) {
        Number b(0);
        for (int k = 0; k <= i; ++k) {
            b += Number(binomial[i][k]) * c[k];
        }
        if (first == 0 || sign(b) != first) {
            return false;
        }
    }
    return true;
}

} // namespace

Polynomial::Polynomial(std::vector<Number> coefficients) : c_(std::move(coefficients)) {
    while (!c_.empty() && c_.back() == 0) {
        c_.pop_back();
    }
}

Number Polynomial::at(const Number& x) const {
    Number result(0);
    for (int k = degree(); k >= 0; --k) {
        result = result * x + c_[k];
    }
    return result;
}

int Polynomial::sign_at(const Number& x) const {
    return sign(at(x));
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
    std::vector<Number> c(static_cast<std::size_t>(std::max(a.degree(), b.degree()) + 1), Number(0));
    for (int k = 0; k <= a.degree(); ++k) {
        c[k] += a[k];
    }
    for (int k = 0; k <= b.degree(); ++k) {
        c[k] += b[k];
    }
    return c;
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) {
    return a + Number(-1) * b;
}

Polynomial operator*(const Number& a, const Polynomial& b) {
    std::vector<Number> c = b.coefficients();
    for (Number& x : c) {
        x *= a;
    }
    return c;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    if (a.is_zero() || b.is_zero()) {
        return {};
    }
    std::vector<Number> c(static_cast<std::size_t>(a.degree() + b.degree() + 1), Number(0));
    for (int i = 0; i <= a.degree(); ++i) {
        for (int k = 0; k <= b.degree(); ++k) {
            c[i + k] += a[i] * b[k];
        }
    }
    return c;
}

Root::Root(Polynomial of, const Number& lo, const Number& hi)
    : of_(std::move(of)), sign_at_lo_(of_.sign_at(lo)), lo_(lo), hi_(hi) {}

void Root::narrow() {
    if (is_rational()) {
        return;
    }
    const Number mid = (lo_ + hi_) / 2;
    const int here = of_.sign_at(mid);
    if (here == 0) {
        lo_ = hi_ = mid;
    } else if (here == sign_at_lo_) {
        lo_ = mid;
    } else {
        hi_ = mid;
    }
}

int Root::sign_of(const Polynomial& f) {
    if (f.degree() < 1) {
        return f.is_zero() ? 0 : sign(f[0]);
    }
    bool is_apart = false; // known not to be a root of f
    for (int round = 0;; ++round) {
        if (is_rational()) {
            return f.sign_at(lo_);
        }
        // Horner's rule on the interval moved to zero: f(lo + u), 0 <= u <= h, is f(lo) plus what its other
        // coefficients allow.
        std::vector<Number> c = f.coefficients();
        for (int i = 0; i < f.degree(); ++i) {
            for (int k = f.degree() - 1; k >= i; --k) {
                c[k] += lo_ * c[k + 1];
            }
        }
        const Number h = hi_ - lo_;
        Number low = c[0];
        Number high = c[0];
        Number power = h;
        for (int k = 1; k <= f.degree(); ++k, power *= h) {
            (c[k] < 0 ? low : high) += c[k] * power;
        }
        if (low > 0 || high < 0) {
            return sign(low > 0 ? low : high);
        }
        if (!is_apart && round == 40) {
            const Polynomial both = common_divisor(of_, f);
            if (both.degree() > 0 && both.sign_at(lo_) != both.sign_at(hi_)) {
                return 0;
            }
            is_apart = true;
        }
        narrow();
    }
}

int Root::compare(Root& other) {
    constexpr int rounds_before_equality = 40;
    bool are_different = false;
    for (int round = 0;; ++round) {
        if (is_rational() && other.is_rational()) {
            return sign(lo_ - other.lo_);
        }
        if (hi_ <= other.lo_) {
            return -1; // one of them lies inside its open interval
        }
        if (other.hi_ <= lo_) {
            return 1;
        }
        const bool is_inside = other.lo_ < lo_ && hi_ < other.hi_;
        if (!are_different && other.is_rational() && of_.sign_at(other.lo_) == 0) {
            return 0; // the intervals meet, and each holds no other root
        }
        if (!are_different && is_rational() && other.of_.sign_at(lo_) == 0) {
            return 0;
        }
        are_different = are_different || is_rational() || other.is_rational();
        if (!are_different && is_inside && round >= rounds_before_equality) {
            if (sign_of(other.of_) == 0) {
                return 0;
            }
            are_different = true;
        }
        narrow();
        other.narrow();
        if (!are_different && round >= rounds_before_equality) {
            narrow(); // so that this interval gets inside the other
        }
    }
}

std::vector<Root> roots(const Polynomial& p, const Number& lo, const Number& hi) {
    if (p.degree() < 1 || lo > hi || has_none(p, lo, hi)) {
        return {};
    }
    Polynomial rest = divide(p, common_divisor(p, derivative(p))).quotient;
    std::vector<Root> result;
    for (const Number& x : {lo, hi, Number(0)}) { // kept vertices make zero a common root
        if (lo <= x && x <= hi && take_out(rest, x)) {
            result.emplace_back(x);
        }
    }
    if (lo < hi) {
        isolate(rest, lo, hi, result);
    }
    std::sort(result.begin(), result.end(), [](const Root& a, const Root& b) {
        Root x = a;
        Root y = b;
        return x.compare(y) < 0;
    });
    return result;
}

Number between(Root& a, Root& b) {
    while (a.hi() >= b.lo()) {
        a.narrow();
        b.narrow();
    }
    return (a.hi() + b.lo()) / 2;
}

} // namespace foldless::oracle
