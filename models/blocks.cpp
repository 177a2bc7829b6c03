#include <foldless/models/blocks.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>

namespace foldless {

namespace {

using GridPoint = std::array<int, 3>;

/// A rectangle of the boundary: its corners counterclockwise from outside.
struct Rectangle {
    std::array<GridPoint, 4> corners;
    int weight_u;
    int weight_v;
};

/// The order of the corners' numbers: z, then y, then x.
struct ByHeight {
    bool operator()(const GridPoint& a, const GridPoint& b) const {
        return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
    }
};

/// The sides of a box: an axis, and whether it is the upper end.
constexpr std::array<std::pair<int, bool>, 6> sides{
    {{0, false}, {0, true}, {1, false}, {1, true}, {2, false}, {2, true}}};

/// The side of a box across `axis`, at its upper end or its lower one.
///
/// With u and v the next two axes, e_u x e_v = e_axis points out of the upper side; for the lower one u and v swap.
Rectangle side_of(const Blocks& blocks, const GridPoint& box, int axis, bool upper) {
    int u = (axis + 1) % 3;
    int v = (axis + 2) % 3;
    if (!upper) {
        std::swap(u, v);
    }
    GridPoint origin = box;
    origin[axis] += upper ? 1 : 0;
    const auto moved = [](GridPoint point, int along) {
        ++point[along];
        return point;
    };
    return {{origin, moved(origin, u), moved(moved(origin, u), v), moved(origin, v)},
            blocks.axes[u].weights[box[u]],
            blocks.axes[v].weights[box[v]]};
}

bool is_filled(const Blocks& blocks, const GridPoint& box) {
    return std::find(blocks.filled.begin(), blocks.filled.end(), box) != blocks.filled.end();
}

std::vector<Rectangle> boundary_of(const Blocks& blocks) {
    std::vector<Rectangle> boundary;
    for (const GridPoint& box : blocks.filled) {
        for (const auto& [axis, upper] : sides) {
            GridPoint neighbour = box;
            neighbour[axis] += upper ? 1 : -1;
            if (!is_filled(blocks, neighbour)) {
                boundary.push_back(side_of(blocks, box, axis, upper));
            }
        }
    }
    return boundary;
}

} // namespace

Vec3 BlockSurface::point(const SurfacePlace& place) const {
    const auto& c = patches[place.patch].corners;
    const Vec3 lower = corners[c[0]] + place.u * (corners[c[1]] - corners[c[0]]);
    const Vec3 upper = corners[c[3]] + place.u * (corners[c[2]] - corners[c[3]]);
    return lower + place.v * (upper - lower);
}

BlockSurface surface_of(const Blocks& blocks) {
    const std::vector<Rectangle> boundary = boundary_of(blocks);
    std::map<GridPoint, int, ByHeight> numbers;
    for (const Rectangle& rectangle : boundary) {
        for (const GridPoint& corner : rectangle.corners) {
            numbers.emplace(corner, 0);
        }
    }

    BlockSurface surface;
    for (auto& [point, number] : numbers) {
        number = static_cast<int>(surface.corners.size());
        surface.corners.emplace_back(blocks.axes[0].cuts[point[0]], blocks.axes[1].cuts[point[1]],
                                     blocks.axes[2].cuts[point[2]]);
    }
    for (const Rectangle& rectangle : boundary) {
        QuiltPatch patch{{}, rectangle.weight_u, rectangle.weight_v};
        for (std::size_t i = 0; i < patch.corners.size(); ++i) {
            patch.corners[i] = numbers.at(rectangle.corners[i]);
        }
        surface.patches.push_back(patch);
    }
    return surface;
}

} // namespace foldless
