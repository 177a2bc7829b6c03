#include <foldless/decimate/quadric.h>

#include "made_scans.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

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

// The sum of planes that the whole surface has at a vertex, whatever has merged before.
TEST(VertexQuadrics, AddUpWhatHasMerged) {
    const Scan scan = test::torus(5, 4);
    const ScanTopology topology(scan);
    VertexQuadrics quadrics(scan, topology, Vec3(1, 0, 0));
    const Vec3 x(0.3, 0.2, 0.1);
    const auto error = [&](std::int32_t v) { return quadrics[v](x); };
    const std::vector<double> before{error(0), error(1), error(2), error(3)};
    quadrics.merge(0, 1);
    EXPECT_DOUBLE_EQ(error(0), before[0] + before[1]);
    quadrics.merge(2, 3);
    EXPECT_DOUBLE_EQ(error(2), before[2] + before[3]);
    quadrics.merge(2, 0);
    EXPECT_DOUBLE_EQ(error(2), before[0] + before[1] + before[2] + before[3]);
    quadrics.merge(4, 5); // takes the room that 0 has left
    EXPECT_DOUBLE_EQ(error(2), before[0] + before[1] + before[2] + before[3]);
}

// So many that the room of those that are gone is given back on the way.
TEST(VertexQuadrics, AddUpToTheWholeSurface) {
    const Scan scan = test::torus(60, 60);
    const ScanTopology topology(scan);
    VertexQuadrics quadrics(scan, topology, Vec3::Zero());
    const auto count = static_cast<std::int32_t>(scan.positions.size());
    const Vec3 x(0.3, 0.2, 0.1);
    double all = 0;
    for (std::int32_t v = 0; v < count; ++v) {
        all += quadrics[v](x);
    }
    for (std::int32_t step = 1; step < count; step *= 2) {
        for (std::int32_t v = 0; v + step < count; v += 2 * step) {
            quadrics.merge(v, v + step);
        }
    }
    EXPECT_NEAR(quadrics[0](x), all, 1e-12 * all);
}

TEST(VertexQuadrics, StartWithTheFacesOfTheScanByArea) {
    const Scan scan{{{0, 0, 1}, {2, 0, 1}, {0, 2, 1}}, {{0, 1, 2}}, true};
    const ScanTopology topology(scan);
    const VertexQuadrics quadrics(scan, topology, Vec3(0, 0, 1));
    EXPECT_DOUBLE_EQ(quadrics[0](Vec3(5, 5, 2)),
                     16.0); // distance 2 squared, twice the area
    EXPECT_DOUBLE_EQ(quadrics[2](Vec3(5, 5, 0)), 0.0);
}

} // namespace
} // namespace foldless
