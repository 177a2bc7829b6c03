#include "random_triangles.h"

#include <foldless/predicates/batch_inversion.h>

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace foldless {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<InstructionSet> available_sets() {
    std::vector<InstructionSet> sets;
    for (const InstructionSet set : {InstructionSet::scalar, InstructionSet::avx2, InstructionSet::avx512}) {
        if (is_available(set)) {
            sets.push_back(set);
        }
    }
    return sets;
}

/// NaN and the signs of zeros included.
bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same_bits(const Preimage& a, const Preimage& b) {
    return same_bits(a.alpha[0], b.alpha[0]) && same_bits(a.alpha[1], b.alpha[1]) &&
           same_bits(a.alpha[2], b.alpha[2]) && same_bits(a.t, b.t) && same_bits(a.slope, b.slope);
}

bool same_bits(const Preimages& a, const Preimages& b) {
    return a.kind == b.kind && std::equal(a.begin(), a.end(), b.begin(), b.end(),
                                          [](const Preimage& x, const Preimage& y) { return same_bits(x, y); });
}

/// Compares each point of the batch with the scalar answer, in every instruction set; how many have solutions.
int compare(const BaseTriangle& triangle, const PointBatch& batch) {
    const InverseDisplacement inverse(triangle);
    int solved = 0;
    for (const InstructionSet set : available_sets()) {
        const BatchInversion answers(inverse, batch, set);
        solved = 0;
        for (int k = 0; k < batch.size; ++k) {
            const Preimages expected = inverse.preimages(batch.point(k), batch.range(k));
            EXPECT_TRUE(same_bits(answers.preimages(k), expected)) << "set " << static_cast<int>(set) << " point " << k;
            const bool is_candidate = (answers.candidates() >> k & 1U) != 0;
            EXPECT_TRUE(is_candidate || expected.kind == Preimages::Kind::none);
            solved += expected.empty() ? 0 : 1;
        }
        EXPECT_EQ(answers.candidates() >> batch.size, 0U);
    }
    return solved;
}

/// Batches of all sizes of points made by `point`, in ranges made by `range`.
template <class Triangle, class Point, class InRange>
int compare_all(int count, Triangle triangle, Point point, InRange range) {
    int solved = 0;
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        const BaseTriangle made = triangle();
        PointBatch batch;
        for (int size = i % PointBatch::capacity + 1; size > 0; --size) {
            batch.push_back(point(made), range());
        }
        solved += compare(made, batch);
    }
    return solved;
}

TEST(BatchInversion, AnswersAsOneByOneNearTheNormal) {
    RandomTriangles random(1);
    const int solved = compare_all(
        20000, [&] { return random.tame(); },
        [&](const BaseTriangle& triangle) {
            return displaced(triangle, random.barycentric(), random.number(-0.6, 0.6));
        },
        [&] {
            return Range{random.number(-0.5, 0), random.number(0, 0.5)};
        });
    EXPECT_GT(solved, 30000);
}

TEST(BatchInversion, AnswersAsOneByOneInAnyDirection) {
    RandomTriangles random(2);
    const int solved = compare_all(
        20000, [&] { return random.wild(); }, [&](const BaseTriangle&) { return random.vector(); },
        [&] {
            return Range{random.number(-1, 0), random.number(0, 1)};
        });
    EXPECT_GT(solved, 20000);
}

TEST(BatchInversion, AnswersAsOneByOneInRangesThatAreNotFinite) {
    RandomTriangles random(3);
    const std::array<double, 6> ends{-infinity, infinity, nan, 0.0, -0.5, 1e308};
    const auto end = [&] { return ends[static_cast<std::size_t>(random.number(0, 6))]; };
    compare_all(
        5000, [&] { return random.tame(); }, [&](const BaseTriangle&) { return random.vector(); },
        [&] {
            return Range{end(), end()};
        });
}

TEST(BatchInversion, AnswersAsOneByOneInEveryUnit) {
    RandomTriangles random(4);
    double length = 1;
    double direction = 1;
    const auto scaled = [&] {
        length = std::ldexp(1.0, static_cast<int>(random.number(-1000, 1000)));
        direction = std::ldexp(1.0, static_cast<int>(random.number(-1000, 1000)));
        BaseTriangle triangle = random.tame();
        for (int k = 0; k < 3; ++k) {
            triangle.v[k] *= length;
            triangle.d[k] *= direction;
        }
        return triangle;
    };
    compare_all(
        20000, scaled, [&](const BaseTriangle&) { return Vec3(random.vector() * length); },
        [&] {
            return Range{-length / direction, length / direction};
        });
}

TEST(BatchInversion, AnswersAsOneByOneForExtremeNumbers) {
    RandomTriangles random(5);
    const std::array<double, 10> numbers{0.0, -0.0, 1.0, -0.5, 1e-310, 1e-160, 1e160, -1e308, infinity, nan};
    const auto number = [&] { return numbers[static_cast<std::size_t>(random.number(0, 10))]; };
    const auto vector = [&] {
        return random.number(0, 1) < 0.7 ? random.dyadic(1) : Vec3(number(), number(), number());
    };
    compare_all(
        50000,
        [&] {
            return BaseTriangle{{vector(), vector(), vector()}, {vector(), vector(), vector()}};
        },
        [&](const BaseTriangle&) { return vector(); },
        [&] {
            return Range{-1.0, number()};
        });
}

// Three rays that meet: the slice at t = 1 is a point, and those beside it are small.
TEST(BatchInversion, AnswersAsOneByOneWhereSlicesShrink) {
    RandomTriangles random(6);
    const Vec3 apex(0.25, 0.25, 1.0);
    const auto cone = [&] {
        BaseTriangle triangle = random.tame();
        for (int k = 0; k < 3; ++k) {
            triangle.d[k] = apex - triangle.v[k];
        }
        return triangle;
    };
    const auto near_apex = [&](const BaseTriangle&) {
        return Vec3(apex + std::ldexp(1.0, -static_cast<int>(random.number(0, 60))) * random.vector());
    };
    compare_all(20000, cone, near_apex, [&] { return Range{random.number(-1, 0), random.number(0.9, 2)}; });
}

TEST(BatchInversion, AnswersAsOneByOneOnPrismsCornersAndEnds) {
    RandomTriangles random(7);
    const auto prism = [&] {
        BaseTriangle triangle{{random.dyadic(2), random.dyadic(2), random.dyadic(2)}, {}};
        triangle.d.fill(random.dyadic(2));
        return triangle;
    };
    const auto ends = [](const BaseTriangle& triangle) { return triangle.corner(1, 0.5); };
    const int solved = compare_all(5000, prism, ends, [&] {
        return Range{random.number(0, 1) < 0.5 ? 0.0 : 0.5, 1.0};
    });
    EXPECT_GT(solved, 1000);
}

TEST(BatchInversion, PointsThatStaySlowDoNotDisturbTheOthers) {
    RandomTriangles random(8);
    for (int i = 0; i < 5000; ++i) {
        const BaseTriangle triangle = random.tame();
        PointBatch batch;
        for (int k = 0; k < PointBatch::capacity; ++k) {
            const double reach = k % 2 == 0 ? 0.4 : 1e-3; // Newton's method takes more or fewer steps
            batch.push_back(displaced(triangle, random.barycentric(), random.number(-reach, reach)),
                            {-0.5 - 1e-3 * k, reach});
        }
        compare(triangle, batch);
    }
}

TEST(BatchInversion, TheBestInstructionSetIsAvailable) {
    EXPECT_TRUE(is_available(InstructionSet::scalar));
    EXPECT_EQ(best_instruction_set(), available_sets().back());
}

} // namespace
} // namespace foldless
