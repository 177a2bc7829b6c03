#include <foldless/verify/sampling.h>

#include <cmath>

namespace foldless::verification {
namespace {

/// A number in [0, 1) that looks random. (Steele, Lea, Flood 2014, "Fast splittable pseudorandom number generators")
double hashed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
    x ^= x >> 31U;
    return static_cast<double>(x >> 11U) * 0x1p-53;
}

/// The inner point of the unit square's lower triangle, or of its mirror image.
Vec3 folded(double u, double v) {
    if (u + v > 1.0) {
        u = 1.0 - u;
        v = 1.0 - v;
    }
    return {1.0 - u - v, u, v};
}

double fraction(double x) {
    return x - std::floor(x);
}

} // namespace

Vec3 low_discrepancy_point(std::uint64_t seed, int i) {
    // The inverses of the plastic number 1.3247... and of its square.
    constexpr double step_u = 0.7548776662466927;
    constexpr double step_v = 0.5698402909980532;
    return folded(fraction(hashed(2 * seed) + i * step_u), fraction(hashed(2 * seed + 1) + i * step_v));
}

Vec3 stratified_point(std::uint64_t seed, int side, int i) {
    // Row r has 2 r + 1 subtriangles, so row and column of the i-th are the square root and what is left; even columns
    // point like the triangle itself, odd ones are turned by half a turn.
    int row = static_cast<int>(std::sqrt(static_cast<double>(i)));
    row -= row * row > i ? 1 : 0;
    row += (row + 1) * (row + 1) <= i ? 1 : 0;
    const int column = i - row * row;
    const std::uint64_t key = seed * 0x100000001b3U + static_cast<std::uint64_t>(i);
    const Vec3 inner = folded(hashed(2 * key), hashed(2 * key + 1));
    const double left = column / 2;
    // Corners of an upright subtriangle, as (row, column) in units of 1 / side: (row, left), (row + 1, left),
    // (row + 1, left + 1); of a turned one: (row + 1, left + 1), (row, left + 1), (row, left).
    const bool upright = column % 2 == 0;
    const double down = upright ? row + inner[1] + inner[2] : row + inner[0];
    const double along = upright ? left + inner[2] : left + inner[0] + inner[1];
    const double v = along / side;
    const double u = down / side - v;
    return {1.0 - down / side, u, v};
}

} // namespace foldless::verification
