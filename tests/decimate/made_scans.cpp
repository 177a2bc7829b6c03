#include "made_scans.h"

#include "../subdivided.h"

#include <foldless/io/float32.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace foldless::test {
namespace {

constexpr double pi = std::numbers::pi;

void round_to_float32(Scan& scan) {
    for (Vec3& p : scan.positions) {
        p = to_float32(p);
    }
}

/// Appends the quadrilateral a, b, c, d, cut from a to c.
void add_quad(Scan& scan, const std::array<std::int32_t, 4>& corners) {
    scan.faces.push_back({corners[0], corners[1], corners[2]});
    scan.faces.push_back({corners[0], corners[2], corners[3]});
}

/// The surface of a set of lattice cells, vertices by lattice point.
class CellSurface {
public:
    explicit CellSurface(double scale) : scale_(scale) {}

    using Point = std::array<int, 3>;

    /// Adds the side of the cell with its lowest corner at `cell` that faces along +axis or -axis.
    void add_side(const Point& cell, int axis, bool upper) {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        Point corner = cell;
        corner[axis] += upper ? 1 : 0;
        std::array<std::int32_t, 4> quad{};
        constexpr std::array<std::array<int, 2>, 4> round{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
        for (int k = 0; k < 4; ++k) {
            Point p = corner;
            p[u] += round[k][0];
            p[v] += round[k][1];
            quad[upper ? k : 3 - k] = vertex(p);
        }
        add_quad(scan_, quad);
    }

    [[nodiscard]] Scan scan() const { return scan_; }

private:
    std::int32_t vertex(const Point& p) {
        const auto [entry, is_new] = numbers_.try_emplace(p, static_cast<std::int32_t>(scan_.positions.size()));
        if (is_new) {
            scan_.positions.push_back(scale_ * Vec3(p[0], p[1], p[2]));
        }
        return entry->second;
    }

    double scale_;
    Scan scan_;
    std::map<Point, std::int32_t> numbers_;
};

} // namespace

Scan pyramid(const Vec3& top) {
    return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, top}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}, false};
}

Scan bumpy_sphere(int levels) {
    Scan scan{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
              {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
    for (int level = 0; level < levels; ++level) {
        scan = subdivided(scan);
    }
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    for (Vec3& p : scan.positions) {
        p = turn * p * (1 + 0.1 * std::sin(5 * p.x()) * std::cos(4 * p.y()));
    }
    round_to_float32(scan);
    return scan;
}

Scan torus(int around, int across) {
    Scan scan;
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            const double u = 2 * pi * i / around;
            const double v = 2 * pi * j / across;
            const double r = 1 + 0.4 * std::cos(v);
            scan.positions.emplace_back(r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v));
        }
    }
    const auto at = [&](int i, int j) { return (i % around) * across + j % across; };
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            add_quad(scan, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    round_to_float32(scan);
    return scan;
}

Scan terrain(int side, double amplitude) {
    Scan scan;
    for (int j = 0; j <= side; ++j) {
        for (int i = 0; i <= side; ++i) {
            const double x = static_cast<double>(i) / side;
            const double y = static_cast<double>(j) / side;
            scan.positions.emplace_back(x, y, amplitude * std::sin(7 * x + 1) * std::cos(5 * y - 2 * x));
        }
    }
    const auto at = [&](int i, int j) { return j * (side + 1) + i; };
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            add_quad(scan, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    round_to_float32(scan);
    return scan;
}

Scan skew_cubes(int k) {
    // A path of four octants, each beside the one before it: (---), (+--), (++-), (+++).
    const auto solid = [&](const std::array<int, 3>& cell) {
        const bool x = cell[0] >= 0;
        const bool y = cell[1] >= 0;
        const bool z = cell[2] >= 0;
        const bool near = std::all_of(cell.begin(), cell.end(), [&](int c) { return c >= -k && c < k; });
        return near && (x || !y) && (y || !z);
    };
    CellSurface surface(1.0 / k);
    for (int z = -k; z < k; ++z) {
        for (int y = -k; y < k; ++y) {
            for (int x = -k; x < k; ++x) {
                const std::array<int, 3> cell{x, y, z};
                for (int side = 0; side < 6 && solid(cell); ++side) {
                    std::array<int, 3> beside = cell;
                    beside[side / 2] += side % 2 == 1 ? 1 : -1;
                    if (!solid(beside)) {
                        surface.add_side(cell, side / 2, side % 2 == 1);
                    }
                }
            }
        }
    }
    Scan scan = surface.scan();
    round_to_float32(scan);
    return scan;
}

Scan spindle(int count, int turns) {
    Scan scan{{{0, 0, 1}, {0, 0, -1}}, {}, false};
    for (int n = 0; n < count; ++n) {
        const double angle = 2 * std::numbers::pi * turns * n / count;
        scan.positions.emplace_back(std::cos(angle), std::sin(angle), 0.01 * (n + 1));
    }
    for (int n = 0; n < count; ++n) {
        const std::int32_t a = 2 + n;
        const std::int32_t b = 2 + (n + 1) % count;
        scan.faces.push_back({a, b, 0});
        scan.faces.push_back({b, a, 1});
    }
    return scan;
}

std::int32_t vertex_at(const Scan& scan, const Vec3& position) {
    const auto found = std::find(scan.positions.begin(), scan.positions.end(), position);
    return found == scan.positions.end() ? -1 : static_cast<std::int32_t>(found - scan.positions.begin());
}

} // namespace foldless::test
