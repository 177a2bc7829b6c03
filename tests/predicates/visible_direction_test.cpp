#include <foldless/predicates/visible_direction.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace foldless {
namespace {

double worst(const Vec3& direction, const std::vector<Vec3>& normals) {
    double smallest = 1;
    for (const Vec3& n : normals) {
        smallest = std::min(smallest, n.dot(direction));
    }
    return smallest;
}

/// The best direction among all centres of caps through one, two or three of the normals: the optimum is one of them.
double best_of_all(const std::vector<Vec3>& normals) {
    double best = -1;
    const auto offer = [&](const Vec3& centre) {
        if (centre.norm() > 1e-12) {
            best = std::max(best, worst(centre.normalized(), normals));
        }
    };
    for (std::size_t i = 0; i < normals.size(); ++i) {
        offer(normals[i]);
        for (std::size_t j = i + 1; j < normals.size(); ++j) {
            offer(normals[i] + normals[j]);
            for (std::size_t k = j + 1; k < normals.size(); ++k) {
                const Vec3 axis = (normals[i] - normals[k]).cross(normals[j] - normals[k]);
                offer(axis);
                offer(-axis);
            }
        }
    }
    return best;
}

/// Unit vectors about z, as wide as `spread` says; 0 gives z itself, far above 1 the whole sphere.
std::vector<Vec3> random_normals(std::mt19937_64& generator, std::size_t count, double spread) {
    std::normal_distribution<double> normal;
    std::vector<Vec3> result;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 noise(normal(generator), normal(generator), normal(generator));
        result.push_back((Vec3(0, 0, 1) + spread * noise).normalized());
    }
    return result;
}

TEST(MostVisibleDirection, IsTheOnlyNormal) {
    const Vec3 n = Vec3(1, -2, 0.5).normalized();
    const auto direction = most_visible_direction(std::vector<Vec3>{n});
    ASSERT_TRUE(direction);
    EXPECT_NEAR((*direction - n).norm(), 0, 1e-15);
}

TEST(MostVisibleDirection, IsTheSameForRepeatedNormals) {
    const Vec3 n = Vec3(1, -2, 0.5).normalized();
    const auto direction = most_visible_direction(std::vector<Vec3>(7, n));
    ASSERT_TRUE(direction);
    EXPECT_NEAR((*direction - n).norm(), 0, 1e-15);
}

TEST(MostVisibleDirection, HalvesTheAngleOfTwoNormals) {
    const auto direction = most_visible_direction(std::vector<Vec3>{Vec3::UnitX(), Vec3::UnitY()});
    ASSERT_TRUE(direction);
    EXPECT_NEAR((*direction - Vec3(1, 1, 0).normalized()).norm(), 0, 1e-12);
}

TEST(MostVisibleDirection, IsTheDiagonalOfACorner) {
    const auto direction = most_visible_direction(std::vector<Vec3>{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()});
    ASSERT_TRUE(direction);
    EXPECT_NEAR((*direction - Vec3(1, 1, 1).normalized()).norm(), 0, 1e-12);
}

TEST(MostVisibleDirection, IsNothingWithoutNormals) {
    EXPECT_FALSE(most_visible_direction({}));
}

TEST(MostVisibleDirection, IsNothingForOppositeNormals) {
    EXPECT_FALSE(most_visible_direction(std::vector<Vec3>{Vec3::UnitX(), -Vec3::UnitX()}));
    EXPECT_FALSE(most_visible_direction(std::vector<Vec3>{Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitX()}));
}

TEST(MostVisibleDirection, IsNothingForNormalsAroundTheOrigin) {
    const std::vector<Vec3> tetrahedron{Vec3(1, 1, 1).normalized(), Vec3(1, -1, -1).normalized(),
                                        Vec3(-1, 1, -1).normalized(), Vec3(-1, -1, 1).normalized()};
    EXPECT_FALSE(most_visible_direction(tetrahedron));
    // Without one of them the three others are seen, from the opposite side of it.
    const auto direction = most_visible_direction(std::vector<Vec3>(tetrahedron.begin() + 1, tetrahedron.end()));
    ASSERT_TRUE(direction);
    EXPECT_NEAR((*direction + tetrahedron[0]).norm(), 0, 1e-12);
}

// Three normals in a plane with the origin inside their triangle; lifted a little, a direction exists.
TEST(MostVisibleDirection, FindsAPoorDirectionIfThereIsNoBetterOne) {
    std::vector<Vec3> normals;
    for (int k = 0; k < 3; ++k) {
        const double angle = 2 * k * std::acos(-0.5);
        normals.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    EXPECT_FALSE(most_visible_direction(normals).has_value() &&
                 worst(*most_visible_direction(normals), normals) > 1e-12);
    for (Vec3& n : normals) {
        n = (n + Vec3(0, 0, 1e-6)).normalized();
    }
    const auto direction = most_visible_direction(normals);
    ASSERT_TRUE(direction);
    EXPECT_NEAR(worst(*direction, normals), 1e-6, 1e-9);
}

TEST(MostVisibleDirection, IsAsGoodAsTheBestOfAllCaps) {
    std::mt19937_64 generator(1);
    int feasible = 0;
    for (int round = 0; round < 3000; ++round) {
        const double spread = std::array{0.05, 0.3, 0.8, 5.0}[round % 4];
        const std::vector<Vec3> normals = random_normals(generator, 1 + round % 12, spread);
        const double best = best_of_all(normals);
        const auto direction = most_visible_direction(normals);
        if (std::abs(best) < 1e-9) {
            continue; // rounding may decide either way
        }
        ASSERT_EQ(direction.has_value(), best > 0) << "round " << round;
        if (direction) {
            ++feasible;
            EXPECT_NEAR(direction->norm(), 1, 1e-12);
            EXPECT_NEAR(worst(*direction, normals), best, 1e-9) << "round " << round;
        }
    }
    EXPECT_GT(feasible, 1500);
}

} // namespace
} // namespace foldless
