#include <foldless/decimate/served_run.h>
#include <foldless/predicates/visible_direction.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace foldless {
namespace {

Vec3 in_plane(double degrees) {
    const double angle = degrees * std::acos(-1.0) / 180;
    return {std::cos(angle), std::sin(angle), 0};
}

std::vector<Vec3> run_of(const std::vector<Vec3>& normals, std::size_t first, std::size_t count) {
    std::vector<Vec3> result;
    for (std::size_t i = 0; i < count; ++i) {
        result.push_back(normals[(first + i) % normals.size()]);
    }
    return result;
}

TEST(ServedRun, IsAllFacesWhereOneDirectionSeesThem) {
    const std::vector<Vec3> normals{in_plane(0), in_plane(60), in_plane(120)};
    const ServedRun run = longest_served_run(normals, false);
    EXPECT_EQ(run.count, 3);
    EXPECT_NEAR((run.direction - in_plane(60)).norm(), 0, 1e-12);
}

TEST(ServedRun, LeavesOutTheFaceThatTurnsBack) {
    const std::vector<Vec3> normals{{0.8, -0.6, 0}, {0.8, 0.6, 0}, {-1, 0, 0}, {1, 0, 0}};
    EXPECT_EQ(longest_served_run(normals, false).count, 2);
    const ServedRun closed = longest_served_run(normals, true); // goes on from the last to the first
    EXPECT_EQ(closed.first, 3);
    EXPECT_EQ(closed.count, 3);
    for (std::size_t i = 0; i < normals.size(); ++i) {
        EXPECT_EQ(closed.contains(i, normals.size()), i != 2);
    }
}

TEST(ServedRun, PassesOverFacesWithoutANormal) {
    const Vec3 none = Vec3::Zero();
    EXPECT_EQ(longest_served_run(std::vector<Vec3>{none, none}, true).count, 0);
    const ServedRun run = longest_served_run(std::vector<Vec3>{none, in_plane(0), in_plane(10), none}, true);
    EXPECT_EQ(run.first, 1);
    EXPECT_EQ(run.count, 2);
}

TEST(ServedRun, IsTheFirstOfSeveral) {
    const std::vector<Vec3> normals{in_plane(0), in_plane(180), in_plane(0), in_plane(180)};
    const ServedRun run = longest_served_run(normals, true);
    EXPECT_EQ(run.first, 0);
    EXPECT_EQ(run.count, 1);
}

TEST(ServedRun, IsTheLongestThatThereIs) {
    std::mt19937_64 generator(1);
    std::normal_distribution<double> normal;
    for (int round = 0; round < 500; ++round) {
        std::vector<Vec3> normals;
        for (int i = 0; i < 1 + round % 9; ++i) {
            normals.emplace_back(Vec3(normal(generator), normal(generator), normal(generator)).normalized());
        }
        const bool closed = round % 2 == 0;
        const std::size_t n = normals.size();
        std::size_t longest = 0;
        for (std::size_t first = 0; first < n; ++first) {
            for (std::size_t count = 1; count <= (closed ? n : n - first); ++count) {
                longest = std::max(longest, most_visible_direction(run_of(normals, first, count)) ? count : 0);
            }
        }
        const ServedRun run = longest_served_run(normals, closed);
        ASSERT_EQ(run.count, longest) << "round " << round;
        for (const Vec3& seen : run_of(normals, run.first, run.count)) {
            EXPECT_GT(seen.dot(run.direction), 0) << "round " << round;
        }
    }
}

} // namespace
} // namespace foldless
