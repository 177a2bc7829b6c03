#include <foldless/predicates/line_sides.h>

#include <foldless/predicates/prismoid_polynomials.h>
#include <foldless/predicates/rounding.h>

#include <algorithm>
#include <limits>

namespace foldless {

LineSides::LineSides(const BaseTriangle& triangle, const ScanLine& line)
    : sides{}, rise{}, vanishes{}, is_flat{}, x_size(0), d_size(0) {
    const Vec3 e = *line.to - *line.from;
    std::array<Vec3, 3> x; // v_i - q
    std::array<Vec3, 3> ex;
    std::array<Vec3, 3> ed;
    for (int i = 0; i < 3; ++i) {
        x[i] = triangle.v[i] - *line.from;
        ex[i] = e.cross(x[i]);
        ed[i] = e.cross(triangle.d[i]);
        x_size = std::max(x_size, max_norm(x[i]));
        d_size = std::max(d_size, max_norm(triangle.d[i]));
    }
    // side_k = (e x (x_i + t d_i)).(x_j + t d_j). With u the rounding, a component of e x x is the difference of two
    // products of two rounded differences: 4 u on 2 |e||x|. Its product with a rounded difference adds 2 u, the sum of
    // three 2 u: 8 u on 6 |e||x||x'|. 64 instead of 48 covers the second order and what makes an interval of it. The
    // sum of three: three times the error, and the rounding of two sums of three such terms.
    e_size = max_norm(e);
    const bool counted = std::min({e_size, x_size, d_size}) >= least_length;
    unit = counted ? 64 * unit_roundoff * e_size : std::numeric_limits<double>::infinity();
    const bool is_across_an_axis = e[0] == 0 || e[1] == 0 || e[2] == 0;
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3;
        const int j = (k + 2) % 3;
        vanishes[k] = is_across_an_axis && lie_across_an_axis(triangle, k, line);
        is_flat[k] = triangle.d[i] == triangle.d[j];
        if (vanishes[k]) {
            continue;
        }
        sides[k] = {ex[i].dot(x[j]), ex[i].dot(triangle.d[j]) + ed[i].dot(x[j]),
                    is_flat[k] ? 0.0 : ed[i].dot(triangle.d[j])};
        for (std::size_t n = 0; n < 3; ++n) {
            rise[n] += sides[k][n];
        }
    }
}

} // namespace foldless
