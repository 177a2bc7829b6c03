#include <foldless/predicates/pillar.h>

#include <foldless/predicates/filtered.h>
#include <foldless/predicates/prismoid_polynomials.h>
#include <foldless/predicates/scan_normal.h>

#include <limits>
#include <type_traits>

namespace foldless {
namespace {

/// l and m of the displaced point v + t d over the plane of the triangle: l + t m is its height times |n|.
template <class Number>
struct Height {
    Number l;
    Number m;

    Height(const DisplacedVertex& vertex, const ScanTriangle& triangle) {
        const VectorOf<Number> q0 = exactly<Number>(triangle[0]);
        const VectorOf<Number> n = normal_of<Number>(triangle);
        l = dot(exactly<Number>(vertex.v) - q0, n);
        m = dot(exactly<Number>(vertex.d), n);
    }
};

/// The sign of the height at displacement t.
Sign height_at(const DisplacedVertex& vertex, const ScanTriangle& triangle, double t) {
    return filtered([&](const auto& zero) {
        using Number = std::decay_t<decltype(zero)>;
        const Height<Number> height(vertex, triangle);
        return sign_of(height.l + Number(t) * height.m);
    });
}

} // namespace

Sign pierces(const DisplacedVertex& vertex, const ScanTriangle& q) {
    if (seen_along(vertex.d, q) != Sign::positive) {
        return Sign::negative;
    }
    // Seen along the direction, the triangle is counter-clockwise; the pillar is a point, to the left of all edges.
    Sign result = Sign::positive;
    for (int k = 0; k < 3; ++k) {
        const Sign side = seen_along(vertex.d, {q[k], q[(k + 1) % 3], vertex.v});
        if (side == Sign::negative) {
            return Sign::negative;
        }
        if (side != Sign::positive) {
            result = Sign::zero;
        }
    }
    return result;
}

bool meets_plane_within(const DisplacedVertex& vertex, const ScanTriangle& triangle, Range range) {
    return height_at(vertex, triangle, range.lo) != Sign::positive &&
           height_at(vertex, triangle, range.hi) != Sign::negative;
}

Range displacement_at_plane(const DisplacedVertex& vertex, const ScanTriangle& triangle) {
    const UpwardRounding upward;
    const Height<Interval> height(vertex, triangle);
    if (!(height.m.inf() > 0)) {
        const double infinity = std::numeric_limits<double>::infinity();
        return {-infinity, infinity};
    }
    const Interval t = -height.l / height.m;
    return {t.inf(), t.sup()};
}

Sign turn_from_base_edge(const DisplacedVertex& vertex, const DisplacedVertex& end, const Displacement& t,
                         const ScanLine& scan_edge) {
    return sign_at(t, [&](const auto& zero) {
        using Number = std::decay_t<decltype(zero)>;
        const VectorOf<Number> d = exactly<Number>(vertex.d);
        const VectorOf<Number> e = exactly<Number>(*scan_edge.to) - exactly<Number>(*scan_edge.from);
        const VectorOf<Number> at_0 = exactly<Number>(end.v) - exactly<Number>(vertex.v);
        const VectorOf<Number> per_t = exactly<Number>(end.d) - d;
        return Coefficients<Number, 2>{dot(d, cross(at_0, e)), dot(d, cross(per_t, e))};
    });
}

Sign leaves_wall_into(const BaseTriangle& triangle, int corner, const Displacement& t, const ScanLine& scan_edge) {
    // On the line side_k(t') = (t' - t)^2 e.(d_i x d_j), and alpha_k = side_k/w has its sign times that of w = N.e.
    const Sign bend = sign_at(Displacement(), [&](const auto& zero) {
        using Number = std::decay_t<decltype(zero)>;
        const VectorOf<Number> e = exactly<Number>(*scan_edge.to) - exactly<Number>(*scan_edge.from);
        return Coefficients<Number, 1>{
            dot(e, cross(exactly<Number>(triangle.d[corner]), exactly<Number>(triangle.d[(corner + 1) % 3])))};
    });
    const Sign rising =
        sign_at(t, [&](const auto& zero) { return rise<std::decay_t<decltype(zero)>>(triangle, scan_edge); });
    if (bend == Sign::zero || rising == Sign::zero) {
        return Sign::zero;
    }
    return bend == rising ? Sign::positive : Sign::negative;
}

} // namespace foldless
