#include "random_triangles.h"

#include <foldless/decimate/prismoid.h>
#include <foldless/predicates/jacobian.h>

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>

namespace foldless {
namespace {

const Range range{-0.5, 0.75};

/// Tame triangles that do not fold over the range.
class RandomPrismoids {
public:
    explicit RandomPrismoids(unsigned seed) : random_(seed) {}

    BaseTriangle next() {
        for (;;) {
            const BaseTriangle triangle = random_.tame();
            if (jacobian_on(triangle, range) == Sign::positive) {
                return triangle;
            }
        }
    }
    RandomTriangles& random() { return random_; }

private:
    RandomTriangles random_;
};

TEST(Prismoid, NeverExcludesAPointOfIts) {
    RandomPrismoids prismoids(1);
    for (int round = 0; round < 20000; ++round) {
        const BaseTriangle triangle = prismoids.next();
        const double t =
            round % 5 == 0 ? (round % 2 == 0 ? range.lo : range.hi) : prismoids.random().number(range.lo, range.hi);
        const Vec3 alpha = round % 7 == 0 ? Vec3(Vec3::Unit(round % 3)) : prismoids.random().barycentric();
        const Vec3 q = displaced(triangle, alpha, t);
        const Prismoid prismoid(triangle, range);
        const auto part = prismoid.displacements(q);
        ASSERT_TRUE(part) << round;
        EXPECT_LE(part->lo, t);
        EXPECT_GE(part->hi, t);
        const Preimages found = prismoid.preimages(q, *part);
        const bool listed = std::any_of(found.begin(), found.end(), [&](const Preimage& p) {
            return std::abs(p.t - t) < 1e-12 && (p.alpha - alpha).norm() < 1e-12;
        });
        EXPECT_TRUE(listed) << round;
    }
}

TEST(Prismoid, HoldsNoSolutionThatItExcludes) {
    RandomPrismoids prismoids(2);
    int excluded = 0;
    for (int round = 0; round < 20000; ++round) {
        const BaseTriangle triangle = prismoids.next();
        const Vec3 q = prismoids.random().vector(1.5);
        const Prismoid prismoid(triangle, range);
        const auto part = prismoid.displacements(q);
        excluded += part ? 0 : 1;
        for (const Preimage& p : prismoid.preimages(q)) {
            if (inside(p) && p.t >= range.lo && p.t <= range.hi) {
                ASSERT_TRUE(part) << round;
                EXPECT_LE(part->lo, p.t);
                EXPECT_GE(part->hi, p.t);
            }
        }
    }
    EXPECT_GT(excluded, 10000);
}

/// Compares the parts of a batch with those of its points, bit by bit, in every instruction set.
void compare_parts(const Prismoid& prismoid, const PointBatch& points) {
    for (const InstructionSet set : {InstructionSet::scalar, InstructionSet::avx2, InstructionSet::avx512}) {
        if (!is_available(set)) {
            continue;
        }
        PointBatch batch = points;
        const unsigned left = prismoid.displacements(batch, set);
        EXPECT_EQ(left >> batch.size, 0U);
        for (int k = 0; k < batch.size; ++k) {
            const auto part = prismoid.displacements(batch.point(k));
            ASSERT_EQ((left >> k & 1U) != 0, part.has_value());
            if (part) {
                ASSERT_EQ(std::bit_cast<std::uint64_t>(part->lo), std::bit_cast<std::uint64_t>(batch.lo[k]));
                ASSERT_EQ(std::bit_cast<std::uint64_t>(part->hi), std::bit_cast<std::uint64_t>(batch.hi[k]));
            }
        }
    }
}

TEST(Prismoid, ExcludesInBatchesWhatItExcludesOneByOne) {
    RandomTriangles random(4);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 20000 && !HasFailure(); ++round) {
        const BaseTriangle triangle = round % 4 == 0 ? random.wild() : random.tame();
        PointBatch batch;
        for (int k = 0; k <= round % PointBatch::capacity; ++k) {
            Vec3 q = round % 2 == 0 ? random.vector(1.5) : displaced(triangle, random.barycentric(), range.lo);
            if (round % 100 == 0) {
                q[k % 3] = k % 2 == 0 ? nan : infinity;
            }
            batch.push_back(q, {0, 0});
        }
        compare_parts(Prismoid(triangle, range), batch);
    }
}

TEST(WallPlanes, LeaveEveryPointOfAWallInFront) {
    RandomPrismoids prismoids(3);
    for (int round = 0; round < 20000; ++round) {
        const BaseTriangle triangle = prismoids.next();
        const int k = round % 3;
        Vec3 alpha = prismoids.random().barycentric();
        alpha[(k + 1) % 3] += alpha[k];
        alpha[k] = 0;
        const Vec3 q = displaced(triangle, alpha, prismoids.random().number(range.lo, range.hi));
        EXPECT_EQ(WallPlanes(triangle, range).behind(q) & (1U << k), 0U) << round;
    }
}

TEST(WallPlanes, SeeTheMiddleBehindAllThree) {
    const BaseTriangle prism{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                             {Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1)}};
    const WallPlanes planes(prism, range);
    EXPECT_EQ(planes.behind({0.25, 0.25, 0.5}), WallPlanes::all);
    EXPECT_EQ(planes.behind({0.25, 0x1p-40, 0.5}), WallPlanes::all);
    EXPECT_EQ(planes.behind({0.25, 0, 0.5}), WallPlanes::all & ~4U); // on the wall opposite corner 2
    EXPECT_EQ(planes.behind({0, 0.25, 0.5}), WallPlanes::all & ~2U);
    EXPECT_EQ(planes.behind({0.5, 0.5, 0.5}), WallPlanes::all & ~1U);
}

} // namespace
} // namespace foldless
