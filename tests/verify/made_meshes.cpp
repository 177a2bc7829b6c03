#include "made_meshes.h"

#include "../subdivided.h"

#include <cmath>
#include <numbers>

namespace foldless::test {
namespace {

const std::vector<Vec3> axes{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
const std::vector<Triangle> octants{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};

Scan sphere(int levels, const Eigen::Matrix3d& turn) {
    Scan result{axes, octants, false};
    for (int level = 0; level < levels; ++level) {
        result = subdivided(result);
    }
    for (Vec3& p : result.positions) {
        p = turn * p * (1 + 0.05 * std::sin(5 * p.x()) * std::cos(4 * p.y()));
    }
    return result;
}

/// The polygon of a double pyramid.
struct Waist {
    int corners;
    int laps;
    double turn;
    double height;
};

Scan bipyramid(const std::vector<Vec3>& poles, const Waist& waist) {
    Scan scan{poles, {}, false};
    for (int k = 0; k < waist.corners; ++k) {
        const double angle = 2 * std::numbers::pi * waist.laps * k / waist.corners + waist.turn;
        scan.positions.emplace_back(std::cos(angle), std::sin(angle), waist.height);
        const std::int32_t a = 2 + k;
        const std::int32_t b = 2 + (k + 1) % waist.corners;
        scan.faces.push_back({0, a, b});
        scan.faces.push_back({1, b, a});
    }
    return scan;
}

} // namespace

BaseMesh octahedron(Range range) {
    BaseMesh base;
    base.positions = axes;
    base.directions = axes;
    base.scan_vertex.assign(axes.size(), -1);
    base.faces = octants;
    base.ranges.assign(octants.size(), range);
    return base;
}

Scan turned_sphere(int levels) {
    return sphere(levels, Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix());
}

Scan aligned_sphere(int levels) {
    return sphere(levels, Eigen::Matrix3d::Identity());
}

BaseMesh square(Range range) {
    BaseMesh base;
    base.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    base.directions.assign(4, {0, 0, 1});
    base.scan_vertex = {0, 1, 2, 3};
    base.faces = {{0, 1, 2}, {0, 2, 3}};
    base.ranges.assign(2, range);
    return base;
}

Scan pyramid(const Vec3& top) {
    Scan scan{square().positions, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
    scan.positions.push_back(top);
    return scan;
}

Scan grid(int side, double low, double high, double height) {
    Scan scan;
    for (int j = 0; j <= side; ++j) {
        for (int i = 0; i <= side; ++i) {
            const double x = low + (high - low) * i / side;
            const double y = low + (high - low) * j / side;
            scan.positions.emplace_back(x, y, height * x * y);
        }
    }
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const std::int32_t a = j * (side + 1) + i;
            const std::int32_t c = a + side + 2;
            scan.faces.push_back({a, a + 1, c});
            scan.faces.push_back({a, c, c - 1});
        }
    }
    return scan;
}

Scan bipyramid(int corners, int laps) {
    return bipyramid({{0, 0, 1}, {0, 0, -1}}, {corners, laps, 0, 0});
}

Scan bipyramid_off_centre(int corners, int laps) {
    return bipyramid({{0.011, 0.007, 1}, {0.005, -0.003, -1}}, {corners, laps, 0.1, 0.013});
}

} // namespace foldless::test
