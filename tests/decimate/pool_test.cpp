#include <foldless/decimate/pool.h>

#include <gtest/gtest.h>

namespace foldless {
namespace {

TEST(Pool, GivesBackEachValue) {
    Pool<double> pool;
    const std::int32_t a = pool.add(0.5);
    const std::int32_t b = pool.add(0.25);
    EXPECT_EQ(pool[a], 0.5);
    EXPECT_EQ(pool[b], 0.25);
    pool[a] = 2.0;
    EXPECT_EQ(pool[a], 2.0);
    EXPECT_EQ(pool[b], 0.25);
}

TEST(Pool, GivesTheNumbersOfRemovedValuesAgain) {
    Pool<double> pool;
    const std::int32_t a = pool.add(0.5);
    const std::int32_t b = pool.add(0.25);
    pool.remove(a);
    EXPECT_EQ(pool.add(4.0), a);
    EXPECT_EQ(pool[a], 4.0);
    EXPECT_EQ(pool[b], 0.25);
    EXPECT_NE(pool.add(8.0), a);
}

TEST(Pool, IsSparseWhenThreeQuartersOfManyValuesHaveGone) {
    constexpr std::int32_t many = 4000;
    Pool<double> pool;
    for (std::int32_t n = 0; n < many; ++n) {
        EXPECT_EQ(pool.add(n), n);
    }
    for (std::int32_t n = 0; n < many / 2; ++n) {
        pool.remove(n);
    }
    EXPECT_FALSE(pool.is_sparse());
    EXPECT_EQ(pool.size(), many / 2);
    for (std::int32_t n = many / 2; n < many - 1; ++n) {
        pool.remove(n);
    }
    EXPECT_TRUE(pool.is_sparse());
    EXPECT_EQ(pool.size(), 1);
    EXPECT_EQ(pool[many - 1], many - 1);
}

} // namespace
} // namespace foldless
