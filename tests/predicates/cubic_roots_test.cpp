#include "exact_cubic.h"
#include "random_triangles.h"

#include <foldless/predicates/cubic_roots.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace foldless {
namespace {

constexpr double unit = std::numeric_limits<double>::epsilon();

/// Exact for small integers.
Cubic with_roots(double r, double s, double t) {
    return {1.0, -(r + s + t), r * s + s * t + t * r, -r * s * t};
}

std::vector<double> list(const RealRoots& roots) {
    return {roots.begin(), roots.end()};
}

/// The sum of the sizes of the terms at t.
double terms(const Cubic& cubic, double t) {
    return error_at({std::abs(cubic.a), std::abs(cubic.b), std::abs(cubic.c), std::abs(cubic.d)}, t);
}

Cubic random_cubic(RandomTriangles& random) {
    const auto coefficient = [&] { return std::ldexp(random.number(-1, 1), static_cast<int>(random.number(-12, 12))); };
    return {coefficient(), coefficient(), coefficient(), coefficient()};
}

TEST(CubicRoots, FindsThreeIntegers) {
    for (int r = -9; r < 9; ++r) {
        for (int s = r + 1; s < 9; ++s) {
            for (int t = s + 1; t < 9; ++t) {
                const RealRoots roots = real_roots(with_roots(r, s, t));
                ASSERT_EQ(roots.count, 3) << r << ' ' << s << ' ' << t;
                EXPECT_NEAR(roots.t[0], r, 1e-12);
                EXPECT_NEAR(roots.t[1], s, 1e-12);
                EXPECT_NEAR(roots.t[2], t, 1e-12);
            }
        }
    }
}

TEST(CubicRoots, ListsADoubleRootOnce) {
    for (int twice = -9; twice < 9; ++twice) {
        for (int once = -9; once < 9; ++once) {
            if (once == twice) {
                continue;
            }
            const RealRoots roots = real_roots(with_roots(twice, twice, once));
            ASSERT_EQ(roots.count, 2) << twice << ' ' << once;
            EXPECT_NEAR(roots.t[once < twice ? 1 : 0], twice, 1e-6);
            EXPECT_NEAR(roots.t[once < twice ? 0 : 1], once, 1e-12);
        }
    }
}

TEST(CubicRoots, FindsATripleRootWithinTheCubeRootOfRounding) {
    for (int r = -9; r < 9; ++r) {
        const RealRoots roots = real_roots(with_roots(r, r, r));
        ASSERT_GE(roots.count, 1) << r;
        for (const double t : roots) {
            EXPECT_NEAR(t, r, 1e-4 * (1 + std::abs(r)));
        }
    }
}

TEST(CubicRoots, FindsTheOnlyRealRoot) {
    const RealRoots roots = real_roots({1.0, -3.0, 1.0, -3.0}); // (t - 3)(t^2 + 1)
    ASSERT_EQ(roots.count, 1);
    EXPECT_DOUBLE_EQ(roots.t[0], 3.0);
}

TEST(CubicRoots, LowersTheDegree) {
    EXPECT_EQ(list(real_roots({0.0, 1.0, -3.0, 2.0})), (std::vector<double>{1.0, 2.0}));
    EXPECT_EQ(list(real_roots({0.0, 1.0, 0.0, -4.0})), (std::vector<double>{-2.0, 2.0}));
    EXPECT_EQ(list(real_roots({0.0, 1.0, -2.0, 1.0})), (std::vector<double>{1.0}));
    EXPECT_EQ(list(real_roots({0.0, 1.0, 0.0, 4.0})), (std::vector<double>{}));
    EXPECT_EQ(list(real_roots({0.0, 0.0, 2.0, -3.0})), (std::vector<double>{1.5}));
    EXPECT_EQ(list(real_roots({0.0, 0.0, 0.0, 1.0})), (std::vector<double>{}));
}

TEST(CubicRoots, SaysWhenEveryNumberIsARoot) {
    EXPECT_TRUE(real_roots({}).everywhere);
    EXPECT_TRUE(real_roots({1e-17, -1e-17, 0.0, 1e-17}, {1e-16, 1e-16, 1e-16, 1e-16}).everywhere);
    EXPECT_FALSE(real_roots({0.0, 0.0, 0.0, 1.0}).everywhere);
    EXPECT_FALSE(real_roots({0.0, 0.0, 1.0, 0.0}).everywhere);
}

TEST(CubicRoots, TakesAHiddenLeadingCoefficientAsZero) {
    EXPECT_EQ(list(real_roots({1e-18, 1.0, -3.0, 2.0}, {1e-17, 1e-16, 1e-16, 1e-16})), (std::vector<double>{1.0, 2.0}));
}

TEST(CubicRoots, KeepsTheFarRootOfASmallButCertainLeadingCoefficient) {
    const RealRoots roots = real_roots({1e-12, 1.0, -3.0, 2.0});
    ASSERT_EQ(roots.count, 3);
    EXPECT_NEAR(roots.t[0], -1e12, 10.0);
    EXPECT_NEAR(roots.t[1], 1.0, 1e-11);
    EXPECT_NEAR(roots.t[2], 2.0, 1e-11);
}

TEST(CubicRoots, ReportsAnExtremumThatErrorsHide) {
    const Cubic misses{0.0, 1.0, 0.0, 1e-14};
    EXPECT_EQ(real_roots(misses).count, 0);
    EXPECT_EQ(list(real_roots(misses, {0.0, 0.0, 0.0, 1e-13})), (std::vector<double>{0.0}));
}

TEST(CubicRoots, HasNoRootsOfWhatIsNotFinite) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(real_roots({nan, 1.0, 1.0, 1.0}).count, 0);
    EXPECT_EQ(real_roots({1.0, 1.0, infinity, 1.0}).count, 0);
    EXPECT_FALSE(real_roots({0.0, 0.0, 0.0, nan}).everywhere);
}

TEST(CubicRoots, DoesNotDependOnAPowerOfTwo) {
    RandomTriangles random(1);
    for (int i = 0; i < 10000; ++i) {
        const Cubic cubic = random_cubic(random);
        const double scale = std::ldexp(1.0, i % 400 - 200);
        const Cubic scaled{cubic.a * scale, cubic.b * scale, cubic.c * scale, cubic.d * scale};
        ASSERT_EQ(list(real_roots(cubic)), list(real_roots(scaled)));
    }
}

TEST(CubicRoots, LeavesAResidualOfTheSizeOfRounding) {
    RandomTriangles random(2);
    for (int i = 0; i < 300000; ++i) {
        const Cubic cubic = random_cubic(random);
        const RealRoots roots = real_roots(cubic);
        ASSERT_GE(roots.count, 1);
        ASSERT_TRUE(std::is_sorted(roots.begin(), roots.end()));
        for (const double t : roots) {
            ASSERT_LE(std::abs(cubic.value(t)), 4.0 * unit * terms(cubic, t)) << i;
        }
    }
}

/// Each exact root is found as near as its condition allows, and there are as many unless two nearly meet.
void compare_with_oracle(const Cubic& cubic, int number) {
    const RealRoots roots = real_roots(cubic);
    const auto expected = exact::sign_changes(exact::trimmed({cubic.d, cubic.c, cubic.b, cubic.a}), 160);
    bool well_conditioned = true;
    for (const mpq_class& root : expected) {
        const double t = root.get_d();
        const double uncertainty = 4.0 * unit * (terms(cubic, t) / std::abs(cubic.slope(t)) + std::abs(t));
        well_conditioned = well_conditioned && uncertainty < 1e-7 * std::abs(t);
        const auto near = [&](double found) { return std::abs(found - t) <= std::max(uncertainty, 1e-20); };
        if (well_conditioned) {
            EXPECT_TRUE(std::any_of(roots.begin(), roots.end(), near)) << "case " << number << ", root " << t;
        }
    }
    if (well_conditioned) {
        EXPECT_EQ(roots.count, static_cast<int>(expected.size())) << "case " << number;
    }
}

TEST(CubicRoots, AgreesWithRationalBisection) {
    RandomTriangles random(3);
    for (int i = 0; i < 2000; ++i) {
        compare_with_oracle(random_cubic(random), i);
    }
}

TEST(RisingRoot, IsTheOneRootOfTheRange) {
    const Cubic cubic = with_roots(-3, 1, 5); // falls between its extrema near -1.3 and 3.3
    const auto third = rising_root(cubic, {}, 4, 7);
    ASSERT_TRUE(third);
    ASSERT_EQ(third->count, 1);
    EXPECT_NEAR(third->t[0], 5, 1e-14);
    const auto none = rising_root(cubic, {}, 6, 7);
    ASSERT_TRUE(none);
    EXPECT_EQ(none->count, 0);
}

TEST(RisingRoot, DoesNotAnswerWhereTheCubicMayFallOrVanishAtAnEnd) {
    const Cubic cubic = with_roots(-3, 1, 5);
    EXPECT_FALSE(rising_root(cubic, {}, 0, 7));
    EXPECT_FALSE(rising_root(cubic, {}, 5, 7));
    EXPECT_FALSE(rising_root(cubic, {}, 4, 5));
    EXPECT_FALSE(rising_root(cubic, {0, 0, 100, 0}, 4, 7)); // its slope is not known well enough
    EXPECT_FALSE(rising_root(cubic, {0, 0, 0, 100}, 4, 7)); // nor its values at the ends
}

TEST(RisingRoot, IsWhatAllRootsHaveInTheRange) {
    RandomTriangles random(4);
    int answered = 0;
    int found = 0;
    constexpr int rounds = 100000;
    for (int i = 0; i < rounds; ++i) {
        const Cubic cubic = random_cubic(random);
        const double lo = random.number(-4, 4);
        const double hi = lo + random.number(0, 2);
        const auto only = rising_root(cubic, {}, lo, hi);
        if (!only) {
            continue;
        }
        ++answered;
        std::vector<double> expected = list(real_roots(cubic));
        std::erase_if(expected, [&](double t) { return t < lo || t > hi; });
        ASSERT_EQ(only->count, static_cast<int>(expected.size())) << i;
        if (only->count == 1) {
            ++found;
            const double uncertainty = 8.0 * unit * (terms(cubic, expected[0]) / cubic.slope(expected[0]) + 1.0);
            ASSERT_NEAR(only->t[0], expected[0], uncertainty) << i;
        }
    }
    EXPECT_GT(answered, rounds / 4);
    EXPECT_GT(found, rounds / 50);
}

} // namespace
} // namespace foldless
