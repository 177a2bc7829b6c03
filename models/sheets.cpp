#include <foldless/models/sheets.h>

#include <array>
#include <cmath>
#include <numbers>

namespace foldless {

namespace {

using std::numbers::pi;

constexpr double turn = 2 * pi;

Vec3 torus_point(const SurfacePlace& place) {
    constexpr double major_radius = 1;
    constexpr double minor_radius = 0.4;
    const double theta = turn * place.u;
    const double phi = turn * place.v;
    const double distance = major_radius + minor_radius * std::cos(phi);
    return {distance * std::cos(theta), distance * std::sin(theta), minor_radius * std::sin(phi)};
}

constexpr double tube_radius = 0.5;

/// The length of the trefoil, the integral of sqrt(4 (2 + cos 3t)^2 + 9) over a turn.
constexpr double knot_length = 31.8986;

/// The trefoil winds on a torus of radii 2 and 1, whose normal is across the curve everywhere: with the tangent it
/// gives a frame that closes after a turn, which a frame of the curve's own curvature would not do so simply.
Vec3 knot_point(const SurfacePlace& place) {
    const double t = turn * place.u;
    const double phi = turn * place.v;
    const double c2 = std::cos(2 * t);
    const double s2 = std::sin(2 * t);
    const double c3 = std::cos(3 * t);
    const double s3 = std::sin(3 * t);
    const double distance = 2 + c3;
    const Vec3 centre(distance * c2, distance * s2, s3);
    const Vec3 tangent(-3 * s3 * c2 - 2 * distance * s2, -3 * s3 * s2 + 2 * distance * c2, 3 * c3);
    const Vec3 normal(c3 * c2, c3 * s2, s3);
    const Vec3 binormal = normal.cross(tangent.normalized());
    return centre + tube_radius * (std::cos(phi) * normal + std::sin(phi) * binormal);
}

struct Wave {
    double height;
    double x, y; ///< radians per unit of length
    double phase;
};

/// Each wave about twice as fine and half as high as the one before, in directions that have no symmetry.
constexpr std::array<Wave, 6> terrain_waves = {{{0.15, 2.1, 1.3, 0.3},
                                                {0.08, -2.9, 4.7, 1.1},
                                                {0.04, 9.7, 5.3, 2.0},
                                                {0.02, -14.1, 17.3, 0.7},
                                                {0.01, 31.7, -29.3, 2.6},
                                                {0.005, 53.1, 71.9, 1.9}}};

Vec3 terrain_point(const SurfacePlace& place) {
    const double x = 2 * place.u - 1;
    const double y = 2 * place.v - 1;
    double height = 0;
    for (const Wave& wave : terrain_waves) {
        height += wave.height * std::sin(wave.x * x + wave.y * y + wave.phase);
    }
    return {x, y, height};
}

constexpr double fold_width = 2;
constexpr double fold_radius = 0.15;
constexpr double fold_bend = pi * fold_radius;
constexpr double fold_lower = 2; ///< from x = 0 to 2
constexpr double fold_back = 1;  ///< from x = 2 back to 1
constexpr double fold_upper = 2; ///< from x = 1 to 3
constexpr double fold_length = fold_lower + fold_bend + fold_back + fold_bend + fold_upper;

/// The S by its arc length; going along +x the sheet faces up.
Vec3 fold_profile(double length) {
    constexpr double right = fold_lower;
    constexpr double left = right - fold_back;
    if (length < fold_lower) {
        return {length, 0, 0};
    }
    length -= fold_lower;
    if (length < fold_bend) {
        const double angle = length / fold_radius;
        return {right + fold_radius * std::sin(angle), 0, fold_radius * (1 - std::cos(angle))};
    }
    length -= fold_bend;
    if (length < fold_back) {
        return {right - length, 0, 2 * fold_radius};
    }
    length -= fold_back;
    if (length < fold_bend) {
        const double angle = length / fold_radius;
        return {left - fold_radius * std::sin(angle), 0, fold_radius * (3 - std::cos(angle))};
    }
    return {left + (length - fold_bend), 0, 4 * fold_radius};
}

Vec3 fold_point(const SurfacePlace& place) {
    return fold_profile(fold_length * place.u) + fold_width * place.v * Vec3::UnitY();
}

} // namespace

Sheet torus() {
    return {torus_point, 1 / 0.4, true, true};
}

Sheet knot() {
    return {knot_point, knot_length / (turn * tube_radius), true, true};
}

Sheet terrain() {
    return {terrain_point, 1, false, false};
}

Sheet fold() {
    return {fold_point, fold_length / fold_width, false, false};
}

} // namespace foldless
