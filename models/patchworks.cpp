#include <foldless/models/patchworks.h>

#include <foldless/models/blocks.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace foldless {

namespace {

using std::numbers::pi;

/// One box from `lower` to `upper` on each axis.
BlockSurface box(double lower, double upper) {
    const BlockAxis axis{{lower, upper}, {1}};
    return surface_of({{axis, axis, axis}, {{0, 0, 0}}});
}

Vec3 sphere_point(const BlockSurface& box, const SurfacePlace& place) {
    const Vec3 angles = pi / 4 * box.point(place);
    return Vec3(std::tan(angles.x()), std::tan(angles.y()), std::tan(angles.z())).normalized();
}

struct Bump {
    double height;
    double x, y, z; ///< radians per unit of length
    double phase;
};

/// The heights add up to a third. Nothing in the directions is symmetric.
constexpr std::array<Bump, 5> bumps = {{{0.14, 2.3, -1.1, 0.7, 0.4},
                                        {0.09, -1.7, 3.9, 2.3, 1.3},
                                        {0.06, 5.1, 4.3, -3.7, 2.2},
                                        {0.03, -7.9, 6.1, 8.3, 0.9},
                                        {0.013, 13.7, -15.1, 11.3, 2.9}}};

double bumpy_radius(const Vec3& direction) {
    double radius = 1;
    for (const Bump& bump : bumps) {
        radius += bump.height *
                  std::sin(bump.x * direction.x() + bump.y * direction.y() + bump.z * direction.z() + bump.phase);
    }
    return radius;
}

/// The tori of genus2, of columns x rows patches each. The window is patch (0, 0), centred on the outer side.
constexpr int torus_columns = 8;
constexpr int torus_rows = 4;
constexpr int torus_corners = torus_columns * torus_rows;
constexpr int torus_patches = torus_corners - 1;
constexpr double torus_centre = 1.5;       ///< distance of either centre from the middle of the neck
constexpr double torus_minor_radius = 0.4; ///< the major radius being 1

/// The first torus, its window facing +x; column and row in units of patches.
Vec3 first_torus(double column, double row) {
    const double theta = 2 * pi * (column - 0.5) / torus_columns;
    const double phi = 2 * pi * (row - 0.5) / torus_rows;
    const double distance = 1 + torus_minor_radius * std::cos(phi);
    return {distance * std::cos(theta) - torus_centre, distance * std::sin(theta), torus_minor_radius * std::sin(phi)};
}

/// The second torus is the first one turned by half a turn about z. The neck joins each point of the first window's rim
/// to its mirror image in x = 0; its projection along x is the window's, so it meets neither torus elsewhere.
Vec3 genus2_point(const SurfacePlace& place) {
    const int torus = place.patch / torus_patches;
    if (torus < 2) {
        const int cell = place.patch % torus_patches + 1;
        const int column = cell % torus_columns;
        const int row = cell / torus_columns;
        const Vec3 point = first_torus(column + place.u, row + place.v);
        return torus == 0 ? point : Vec3(-point.x(), -point.y(), point.z());
    }
    const double u = place.u;
    const std::array<std::array<double, 2>, 4> rim = {{{u, 0}, {1, u}, {1 - u, 1}, {0, 1 - u}}};
    const auto [column, row] = rim[place.patch - 2 * torus_patches];
    const Vec3 start = first_torus(column, row);
    return {start.x() * (1 - 2 * place.v), start.y(), start.z()};
}

/// The corners of a cell of the first or the second torus.
std::array<int, 4> torus_cell(int torus, int column, int row) {
    const auto corner = [torus](int i, int j) {
        return torus * torus_corners + (j % torus_rows) * torus_columns + i % torus_columns;
    };
    return {corner(column, row), corner(column + 1, row), corner(column + 1, row + 1), corner(column, row + 1)};
}

std::vector<QuiltPatch> genus2_patches() {
    std::vector<QuiltPatch> patches;
    for (int torus = 0; torus < 2; ++torus) {
        for (int cell = 1; cell < torus_corners; ++cell) {
            patches.push_back({torus_cell(torus, cell % torus_columns, cell / torus_columns)});
        }
    }
    const auto window = torus_cell(0, 0, 0);
    const auto other = torus_cell(1, 0, 0);
    const std::array<int, 4> mirrored = {other[1], other[0], other[3], other[2]}; // y changes sign between the tori
    for (int side = 0; side < 4; ++side) {
        const int next = (side + 1) % 4;
        patches.push_back({{window[side], window[next], mirrored[next], mirrored[side]}});
    }
    return patches;
}

constexpr int tube_columns = 12;
constexpr int tube_rows = 5;
constexpr double tube_height = 2.6; ///< makes the patches of the unit tube square: 5/12 of its circumference

/// Column and row of each hole: no two touch, none touches an end of the tube.
constexpr std::array<std::array<int, 2>, 4> holes = {{{0, 1}, {3, 3}, {6, 1}, {9, 2}}};

std::vector<std::array<int, 2>> tube_cells() {
    std::vector<std::array<int, 2>> cells;
    for (int row = 0; row < tube_rows; ++row) {
        for (int column = 0; column < tube_columns; ++column) {
            bool is_hole = false;
            for (const auto& [hole_column, hole_row] : holes) {
                is_hole = is_hole || (column == hole_column && row == hole_row);
            }
            if (!is_hole) {
                cells.push_back({column, row});
            }
        }
    }
    return cells;
}

/// Bends what is above z = 0 towards +y. A shear, so nothing can meet that did not; z^2 leaves no crease at z = 0.
Vec3 bent(const Vec3& point) {
    constexpr double bend = 0.3; // per unit of length: the tips lean by 0.19
    const double height = std::max(point.z(), 0.0);
    return point + bend * height * height * Vec3::UnitY();
}

/// Shears the half space z > 0 towards +x and the half space y > 0 towards -x. Both are one-to-one and continuous.
Vec3 leaning(const Vec3& point) {
    constexpr double lean = 0.5; // a slope of 1 : 2
    const double shift = lean * (std::max(point.z(), 0.0) - std::max(point.y(), 0.0));
    return point + shift * Vec3::UnitX();
}

/// n times u = i / n is i but for rounding. Places between vertices, for slopes, are a quarter off and kept.
double snapped(double x) {
    constexpr double rounding = 0x1p-20; // far above the error of a product below 2^31, far below a quarter
    const double whole = std::round(x);
    return std::abs(x - whole) < rounding ? whole : x;
}

} // namespace

Patchwork sphere() {
    const BlockSurface surface = box(-1, 1);
    return {surface.patches, [surface](const SurfacePlace& place) { return sphere_point(surface, place); }};
}

Patchwork bumpy_sphere() {
    const BlockSurface surface = box(-1, 1);
    return {surface.patches, [surface](const SurfacePlace& place) -> Vec3 {
                const Vec3 direction = sphere_point(surface, place);
                return bumpy_radius(direction) * direction;
            }};
}

Patchwork genus2() {
    return {genus2_patches(), genus2_point};
}

Patchwork cylinder() {
    const std::vector<std::array<int, 2>> cells = tube_cells();
    std::vector<QuiltPatch> patches;
    for (const auto& [column, row] : cells) {
        const int below = row * tube_columns;
        const int above = below + tube_columns;
        const int next = (column + 1) % tube_columns;
        patches.push_back({{below + column, below + next, above + next, above + column}});
    }
    return {std::move(patches), [cells](const SurfacePlace& place) -> Vec3 {
                const auto& [column, row] = cells[place.patch];
                const double theta = 2 * pi * (column + place.u) / tube_columns;
                return {std::cos(theta), std::sin(theta), tube_height * (row + place.v) / tube_rows};
            }};
}

/// Lengths of about 0.2 per unit of weight, but 0.04 across the flaps.
Patchwork ears() {
    const Blocks blocks{
        {{{{0, 0.2, 0.8, 1}, {1, 3, 1}}, {{0, 0.3, 0.34, 0.66, 0.7, 1}, {2, 1, 2, 1, 2}}, {{-1, 0, 0.8}, {5, 4}}}},
        {{0, 0, 0},
         {1, 0, 0},
         {2, 0, 0},
         {0, 1, 0},
         {1, 1, 0},
         {2, 1, 0},
         {0, 2, 0},
         {1, 2, 0},
         {2, 2, 0},
         {0, 3, 0},
         {1, 3, 0},
         {2, 3, 0},
         {0, 4, 0},
         {1, 4, 0},
         {2, 4, 0},
         {1, 1, 1},
         {1, 3, 1}}};
    const BlockSurface surface = surface_of(blocks);
    return {surface.patches, [surface](const SurfacePlace& place) { return bent(surface.point(place)); }};
}

/// Seen from above, boxes A, B, C below z = 0 and D on top of A:
///
///          |  C        Around the origin there are faces of A and D facing +y, of C facing -x, of B and C facing +z,
///     -----o-----      and of D facing +x. The shears make the normals of those of C and D proportional to
///      A,D |  B        (-1, -1/2, 0) and (1, 0, -1/2).
///
/// (1, 0, -1/2) + (-1, -1/2, 0) + 1/2 (0, 0, 1) + 1/2 (0, 1, 0) = 0: a direction with positive products with all four
/// would have a positive product with 0. The four span space, so this survives small noise.
Patchwork spike() {
    const BlockAxis across{{-1, 0, 1}, {1, 1}};
    const BlockAxis up{{-1, 0, 2}, {1, 2}};
    const BlockSurface surface = surface_of({{across, across, up}, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 1}}});
    return {surface.patches, [surface](const SurfacePlace& place) { return leaning(surface.point(place)); }};
}

Patchwork cube(std::int64_t n) {
    const BlockSurface surface = box(0, 1);
    return {surface.patches, [surface, n](const SurfacePlace& place) -> Vec3 {
                const Vec3 point = static_cast<double>(n) * surface.point(place);
                return {snapped(point.x()), snapped(point.y()), snapped(point.z())};
            }};
}

} // namespace foldless
