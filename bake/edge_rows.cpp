#include <foldless/bake/edge_rows.h>

#include <algorithm>
#include <cmath>

namespace foldless {
namespace {

/// From one sample of a row to where alpha_1 is larger by 1.
const Vec3 row_step(-1.0, 1.0, 0.0);

/// The part of the span outside which a x^2 + b x + c is negative. Where it is negative in the middle only, nothing is
/// cut off.
Span where_not_negative(Span span, double a, double b, double c) {
    const double discriminant = b * b - 4.0 * a * c;
    if (discriminant <= 0.0) {
        return a < 0.0 || (a == 0.0 && c < 0.0) ? Span{1.0, 0.0} : span; // a <= 0 is a constant or has its peak below
    }
    // The root of larger size first: nothing cancels. The other is c / (a r), which is -c / b for a = 0.
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    const double first = a == 0.0 ? std::copysign(HUGE_VAL, b) : q / a;
    const double second = q == 0.0 ? 0.0 : c / q;
    if (a == 0.0) {
        return b > 0.0 ? Span{std::max(span.lo, second), span.hi} : Span{span.lo, std::min(span.hi, second)};
    }
    const auto [least, most] = std::minmax(first, second);
    if (a < 0.0) {
        return {std::max(span.lo, least), std::min(span.hi, most)};
    }
    if (least < span.lo && most > span.lo) {
        span.lo = most;
    }
    if (most > span.hi && least < span.hi) {
        span.hi = least;
    }
    return span;
}

} // namespace

EdgeRows::EdgeRows(const BaseTriangle& triangle, const ScanTriangle& scan) {
    for (int k = 0; k < 3; ++k) {
        const Vec3 a = scan[(k + 1) % 3];
        const Vec3 edge = scan[(k + 2) % 3] - a;
        // With y = a - X: det(y, y + edge, d) = d.(y x edge), linear in y and in d.
        std::array<Vec3, 3> turned; // y_i x edge
        double size = 0.0;
        for (int i = 0; i < 3; ++i) {
            const Vec3 y = a - triangle.v[i];
            turned[i] = y.cross(edge);
            size = std::max(size, (y.norm() + a.norm() + triangle.v[i].norm()) * triangle.d[i].norm());
        }
        Form& form = forms_[k];
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                form.matrix(i, j) = 0.5 * (triangle.d[i].dot(turned[j]) + triangle.d[j].dot(turned[i]));
            }
        }
        form.along = form.matrix * row_step;
        form.bend = row_step.dot(form.along);
        constexpr double share = 1e-13; // some hundred roundings
        form.margin = share * size * (edge.norm() + a.norm());
    }
}

Span EdgeRows::narrowed(Span within, double alpha2) const {
    const Vec3 start(1.0 - alpha2, 0.0, alpha2);
    for (const Form& form : forms_) {
        if (within.empty()) {
            break;
        }
        const double value = start.dot(form.matrix * start) + form.margin;
        within = where_not_negative(within, form.bend, 2.0 * start.dot(form.along), value);
    }
    return within;
}

} // namespace foldless
