#include <foldless/decimate/quadric.h>

#include <gtest/gtest.h>

#include <random>

namespace foldless {
namespace {

TEST(Quadric, IsZeroWithoutPlanes) {
    EXPECT_EQ(Quadric()(Vec3(1, 2, 3)), 0.0);
    EXPECT_FALSE(Quadric().minimiser());
}

TEST(Quadric, IsTheSquaredDistanceToAPlane) {
    Quadric quadric;
    quadric.add_plane({0, 0, 2}, {0, 0, 1});
    EXPECT_DOUBLE_EQ(quadric({5, -7, 2}), 0.0);
    EXPECT_DOUBLE_EQ(quadric({5, -7, 5}), 9.0);
}

TEST(Quadric, WeighsByTheSquareOfTheLengthOfTheNormal) {
    Quadric quadric;
    quadric.add_plane({0, 0, 2}, {0, 0, 3});
    EXPECT_DOUBLE_EQ(quadric({0, 0, 3}), 9.0);
}

TEST(Quadric, AddsUp) {
    Quadric a;
    a.add_plane({1, 0, 0}, {1, 0, 0});
    Quadric b;
    b.add_plane({0, 2, 0}, {0, 1, 0});
    a += b;
    EXPECT_DOUBLE_EQ(a({0, 0, 9}), 5.0);
}

TEST(Quadric, HasItsMinimumWhereThreePlanesMeet) {
    const Vec3 corner(0.25, -3, 0.5);
    Quadric quadric;
    quadric.add_plane(corner, {1, 0, 0});
    quadric.add_plane(corner, {0, 2, 0});
    quadric.add_plane(corner, {1, 1, 1});
    const auto minimiser = quadric.minimiser();
    ASSERT_TRUE(minimiser);
    EXPECT_NEAR((*minimiser - corner).norm(), 0, 1e-12);
}

TEST(Quadric, HasNoMinimiserOnAPlaneOrAnEdge) {
    Quadric flat;
    flat.add_plane({0, 0, 1}, {0, 0, 1});
    flat.add_plane({4, 0, 1}, {0, 0, 2});
    EXPECT_FALSE(flat.minimiser());
    Quadric edge = flat;
    edge.add_plane({1, 0, 0}, {1, 0, 0});
    EXPECT_FALSE(edge.minimiser());
    edge.add_plane({0, 1, 0}, {0, 1, 0});
    EXPECT_TRUE(edge.minimiser());
}

// Nearly an edge: the third plane is so flat against the others that the minimum could lie far away along it.
TEST(Quadric, HasNoMinimiserOnANearlyStraightEdge) {
    Quadric quadric;
    quadric.add_plane({0, 0, 0}, {0, 0, 1});
    quadric.add_plane({0, 0, 0}, {1, 0, 0});
    quadric.add_plane({0, 0, 0.1}, {0, 0.001, 1});
    EXPECT_FALSE(quadric.minimiser());
}

TEST(Quadric, IsNowhereLessThanAtItsMinimiser) {
    std::mt19937_64 generator(7);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto vector = [&] { return Vec3(number(generator), number(generator), number(generator)); };
    for (int round = 0; round < 100; ++round) {
        Quadric quadric;
        for (int plane = 0; plane < 6; ++plane) {
            quadric.add_plane(vector(), vector());
        }
        const auto minimiser = quadric.minimiser();
        if (!minimiser) {
            continue;
        }
        for (int probe = 0; probe < 20; ++probe) {
            EXPECT_GE(quadric(*minimiser + 0.1 * vector()), quadric(*minimiser) - 1e-12);
        }
    }
}

} // namespace
} // namespace foldless
