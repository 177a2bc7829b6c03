#include <foldless/models/make_model.h>

#include "mesh_check.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace foldless {
namespace {

Scan spike(std::int64_t faces, double noise) {
    ModelRequest request;
    request.shape = Shape::spike;
    request.faces = faces;
    request.finish.noise = noise;
    return to_scan(make_model(request));
}

/// Whether 0 = a + x b + y c + z d for some positive x, y, z: then no direction has a positive product with all four.
bool surround_origin(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    Eigen::Matrix3d system;
    system << b, c, d;
    return system.determinant() != 0 && (system.inverse() * -a).minCoeff() > 0;
}

/// A predicate of three normals holds for some three of them, repetition allowed.
template <typename Predicate>
bool some_three(const std::vector<Vec3>& normals, Predicate holds) {
    const std::size_t count = normals.size();
    for (std::size_t i = 0; i < count * count * count; ++i) {
        if (holds(normals[i % count], normals[i / count % count], normals[i / count / count])) {
            return true;
        }
    }
    return false;
}

bool no_direction_sees(const std::vector<Vec3>& normals) {
    return std::any_of(normals.begin(), normals.end(), [&](const Vec3& a) {
        return some_three(normals,
                          [&](const auto& b, const auto& c, const auto& d) { return surround_origin(a, b, c, d); });
    });
}

bool sees(const Vec3& direction, const std::vector<Vec3>& normals) {
    return std::all_of(normals.begin(), normals.end(), [&](const Vec3& normal) { return direction.dot(normal) > 0; });
}

/// Some sum of three of the normals, repetition allowed, sees all of them.
bool a_sum_sees(const std::vector<Vec3>& normals) {
    return some_three(normals, [&](const Vec3& a, const Vec3& b, const Vec3& c) { return sees(a + b + c, normals); });
}

TEST(Spike, NoDirectionSeesItsVertexAtAnySize) {
    for (const std::int64_t faces : {44, 176, 1100, 20'000}) {
        EXPECT_TRUE(no_direction_sees(normals_at(spike(faces, 0), spike_vertex()))) << faces;
    }
}

TEST(Spike, SmallNoiseDoesNotHelp) {
    EXPECT_TRUE(no_direction_sees(normals_at(spike(1100, 0.02), spike_vertex())));
}

TEST(Spike, EveryOtherVertexIsSeen) {
    const Scan scan = spike(400, 0);
    const auto count = static_cast<std::int32_t>(scan.positions.size());
    for (std::int32_t vertex = 0; vertex < count; ++vertex) {
        EXPECT_EQ(a_sum_sees(normals_at(scan, vertex)), vertex != spike_vertex()) << vertex;
    }
}

} // namespace
} // namespace foldless
