#include "textured_meshes.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace foldless {

namespace {

/// A number that float32 holds.
double rounded(double value) {
    return static_cast<double>(static_cast<float>(value));
}

Vec3 rounded(const Vec3& value) {
    return {rounded(value.x()), rounded(value.y()), rounded(value.z())};
}

Eigen::Vector2d picture_place(int x, int y, int cells, bool right_half) {
    const double u = static_cast<double>(x) / (2.0 * cells) + (right_half ? 0.4 : 0.0);
    return {u, 1 - static_cast<double>(y) / cells};
}

} // namespace

MadeMesh square() {
    MadeMesh mesh;
    mesh.base.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.base.directions.assign(4, Vec3(0, 0, 1));
    mesh.base.faces = {{0, 1, 2}, {0, 2, 3}};
    mesh.uv = {{{{0, 1}, {1, 1}, {1, 0}}}, {{{0, 1}, {1, 0}, {0, 0}}}};
    return mesh;
}

MadeMesh cut_grid(int cells) {
    MadeMesh mesh;
    for (int y = 0; y <= cells; ++y) {
        for (int x = 0; x <= cells; ++x) {
            mesh.base.positions.push_back(rounded(Vec3(x / 3.0, y / 7.0, std::sin(x) * std::cos(y) / 5)));
            mesh.base.directions.push_back(rounded((1 + x / 10.0) * Vec3(0.1 * std::sin(y), 0.1 * std::cos(x), 1)));
        }
    }
    for (int y = 0; y < cells; ++y) {
        for (int x = 0; x < cells; ++x) {
            const std::array<std::array<int, 2>, 4> corner{{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}};
            for (const auto& [i, j, k] : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
                auto& face = mesh.base.faces.emplace_back();
                auto& uv = mesh.uv.emplace_back();
                for (std::size_t c = 0; const int which : {i, j, k}) {
                    const auto& [a, b] = corner[which];
                    face[c] = b * (cells + 1) + a;
                    uv[c++] = picture_place(a, b, cells, 2 * x >= cells);
                }
            }
        }
    }
    return mesh;
}

MadeMesh loose_triangles(int count) {
    MadeMesh mesh;
    for (int i = 0; i < count; ++i) {
        const double x = i;
        mesh.base.positions.insert(mesh.base.positions.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
        mesh.base.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    mesh.base.directions.assign(mesh.base.positions.size(), Vec3(0, 0, 1));
    mesh.uv.assign(mesh.base.faces.size(), {{{0, 1}, {1, 1}, {0, 0}}});
    return mesh;
}

MadeMesh degenerate_mesh() {
    const double least = static_cast<double>(std::numeric_limits<float>::denorm_min());
    const double most = static_cast<double>(std::numeric_limits<float>::max());
    const std::array<Eigen::Vector2d, 3> upright{{{0, 1}, {1, 1}, {0, 0}}};
    const std::array<Eigen::Vector2d, 3> mirrored{{{1, 1}, {0, 1}, {1, 0}}};
    const std::array<Eigen::Vector2d, 3> point{{{0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5}}};
    const std::array<Eigen::Vector2d, 3> line{{{0, 0}, {0.5, 0.5}, {1, 1}}};
    MadeMesh mesh;
    mesh.base.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 0, 0}, {0, 0, least}, {most, -most, most}};
    mesh.base.directions = {{0, 0, 0}, {least, 0, 0}, {0, most, 0}, {1, 0, 0}, {-0.0, 0, -0.0}, {0, 0, 2}, {0, 0, 1}};
    mesh.base.faces = {{0, 1, 2}, {1, 3, 2}, {0, 1, 4}, {0, 0, 0}, {0, 1, 5}, {4, 3, 1}, {0, 1, 6}};
    mesh.uv = {upright, mirrored, upright, point, line, point, upright};
    return mesh;
}

std::string one_pixel_png() {
    return {"\211\120\116\107\015\012\032\012\000\000\000\015\111\110\104\122\000\000\000\001"
            "\000\000\000\001\010\002\000\000\000\220\167\123\336\000\000\000\014\111\104\101"
            "\124\170\332\143\150\150\370\017\000\003\203\002\000\076\130\050\045\000\000\000"
            "\000\111\105\116\104\256\102\140\202",
            69};
}

} // namespace foldless
