#include "random_scans.h"

#include "../subdivided.h"

#include <foldless/io/float32.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace foldless::test {
namespace {

constexpr double pi = std::numbers::pi;

Vec3 random_vector(Random& random, double size) {
    const double x = uniform(random, -size, size);
    const double y = uniform(random, -size, size);
    return {x, y, uniform(random, -size, size)};
}

Scan sphere(Random& random) {
    Scan octahedron{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                    {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
    const Scan tetrahedron{{{0.6, 0.6, 0.6}, {-0.6, -0.6, 0.6}, {-0.6, 0.6, -0.6}, {0.6, -0.6, -0.6}},
                           {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    const int kind = index(random, 4);
    Scan scan = kind == 0 ? subdivided(subdivided(tetrahedron)) : subdivided(octahedron); // 64 or 32
    return kind == 1 ? subdivided(scan) : scan;                                           // or 128
}

/// Cells of two triangles, around x across of them; the last of a row is joined to the first if closed.
Scan grid(int around, int across, bool closed, const std::vector<Vec3>& positions) {
    Scan scan{positions, {}};
    const int rows = closed ? around : around + 1;
    const int columns = closed ? across : across + 1;
    const auto at = [&](int i, int j) { return (i % rows) * columns + j % columns; };
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            scan.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            scan.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return scan;
}

Scan torus(Random& random) {
    const int around = 5 + index(random, 6);
    const int across = 4 + index(random, 4);
    std::vector<Vec3> positions;
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            const double u = 2 * pi * i / around;
            const double v = 2 * pi * j / across;
            const double r = 1 + 0.45 * std::cos(v);
            positions.emplace_back(r * std::cos(u), r * std::sin(u), 0.45 * std::sin(v));
        }
    }
    return grid(around, across, true, positions);
}

Scan height_field(Random& random) {
    const int around = 3 + index(random, 6);
    const int across = 3 + index(random, 6);
    const Vec3 waves = random_vector(random, 8);
    const double height = uniform(random, 0.05, 0.5);
    std::vector<Vec3> positions;
    for (int i = 0; i <= around; ++i) {
        for (int j = 0; j <= across; ++j) {
            const double x = static_cast<double>(i) / around;
            const double y = static_cast<double>(j) / across;
            positions.emplace_back(x, y,
                                   height * std::sin(waves.x() * x + 1) * std::cos(waves.y() * y - waves.z() * x));
        }
    }
    return grid(around, across, false, positions);
}

/// Puts a vertex into a few faces.
void split_faces(Scan& scan, Random& random) {
    const int count = index(random, 1 + scan.faces.size() / 6);
    for (int n = 0; n < count; ++n) {
        const int f = index(random, scan.faces.size());
        const auto [a, b, c] = scan.faces[f];
        const double u = uniform(random, 0.2, 0.5);
        const double v = uniform(random, 0.2, 0.4);
        const auto next = static_cast<std::int32_t>(scan.positions.size());
        scan.positions.push_back(u * scan.positions[a] + v * scan.positions[b] + (1 - u - v) * scan.positions[c]);
        scan.faces[f] = {a, b, next};
        scan.faces.push_back({b, c, next});
        scan.faces.push_back({c, a, next});
    }
}

/// Bumps, shakes, stretches and turns; float32 at the end.
void disturb(Scan& scan, Random& random) {
    const double bump = uniform(random, 0.0, 0.15);
    const double shake = uniform(random, 0.0, 0.06);
    const Vec3 waves = random_vector(random, 5);
    const Vec3 stretch = Vec3::Constant(1) + random_vector(random, 0.5);
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(uniform(random, 0, 2 * pi), (random_vector(random, 1) + Vec3(0, 0, 1.5)).normalized())
            .toRotationMatrix();
    for (Vec3& p : scan.positions) {
        const Vec3 bumped = p * (1 + bump * std::sin(waves.x() * p.x()) * std::cos(waves.y() * p.y() + waves.z()));
        p = to_float32(turn * stretch.cwiseProduct(bumped + random_vector(random, shake)));
    }
}

} // namespace

double uniform(Random& random, double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(random() >> 11U) * 0x1p-53;
}

int index(Random& random, std::size_t n) {
    return static_cast<int>(random() % n);
}

Scan random_closed_scan(Random& random) {
    Scan scan = index(random, 4) == 0 ? torus(random) : sphere(random);
    split_faces(scan, random);
    disturb(scan, random);
    return scan;
}

Scan random_open_scan(Random& random) {
    if (index(random, 3) == 0) {
        const Scan closed = random_closed_scan(random);
        return without_star(closed, index(random, closed.positions.size()));
    }
    Scan scan = height_field(random);
    split_faces(scan, random);
    disturb(scan, random);
    return scan;
}

Scan renumbered(const Scan& scan, Random& random) {
    std::vector<std::int32_t> order(scan.positions.size());
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t n = order.size(); n > 1; --n) {
        std::swap(order[n - 1], order[index(random, n)]);
    }
    Scan result = scan;
    for (std::size_t v = 0; v < order.size(); ++v) {
        result.positions[order[v]] = scan.positions[v];
    }
    for (Triangle& face : result.faces) {
        for (std::int32_t& v : face) {
            v = order[v];
        }
    }
    return result;
}

Scan reordered(const Scan& scan, Random& random) {
    Scan result = scan;
    for (std::size_t n = result.faces.size(); n > 1; --n) {
        std::swap(result.faces[n - 1], result.faces[index(random, n)]);
    }
    for (Triangle& face : result.faces) {
        std::rotate(face.begin(), face.begin() + index(random, 3), face.end());
    }
    return result;
}

Scan mirrored(const Scan& scan) {
    Scan result = scan;
    for (Vec3& p : result.positions) {
        p.x() = -p.x();
    }
    for (Triangle& face : result.faces) {
        std::swap(face[1], face[2]);
    }
    return result;
}

Scan scaled(const Scan& scan, double factor) {
    Scan result = scan;
    for (Vec3& p : result.positions) {
        p *= factor;
    }
    return result;
}

Scan without_star(const Scan& scan, std::int32_t vertex) {
    Scan result = scan;
    std::erase_if(result.faces,
                  [&](const Triangle& face) { return std::find(face.begin(), face.end(), vertex) != face.end(); });
    return result;
}

} // namespace foldless::test
