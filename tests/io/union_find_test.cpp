#include <foldless/io/union_find.h>

#include <gtest/gtest.h>

namespace foldless {
namespace {

TEST(UnionFind, NamesASetByItsSmallestMember) {
    UnionFind sets(6);
    EXPECT_TRUE(sets.join(5, 3));
    EXPECT_TRUE(sets.join(4, 5));
    EXPECT_FALSE(sets.join(3, 4));
    EXPECT_EQ(sets.find(5), 3U);
    EXPECT_EQ(sets.find(4), 3U);
    EXPECT_EQ(sets.find(0), 0U);
}

TEST(SidedUnionFind, FindsOddCyclesOfOpposites) {
    SidedUnionFind odd(3);
    odd.join(0, 1, true);
    odd.join(1, 2, true);
    EXPECT_EQ(odd.contradictions(), 0U);
    odd.join(2, 0, true);
    EXPECT_EQ(odd.contradictions(), 1U);

    SidedUnionFind even(3);
    even.join(2, 1, true);
    even.join(0, 1, false);
    even.join(2, 0, true);
    EXPECT_EQ(even.contradictions(), 0U);
}

TEST(SidedUnionFind, CountsASetOnceHoweverItGrew) {
    SidedUnionFind sets(8);
    for (const std::uint32_t start : {0U, 4U}) {
        sets.join(start + 3, start + 2, true);
        sets.join(start + 2, start + 1, true);
        sets.join(start + 1, start + 3, true);
    }
    EXPECT_EQ(sets.contradictions(), 2U);
    sets.join(7, 3, false);
    EXPECT_EQ(sets.contradictions(), 1U);
}

// Long chains are shortened on the way; every member must keep its side.
TEST(SidedUnionFind, KeepsSidesWhilePathsAreHalved) {
    constexpr std::uint32_t size = 200;
    SidedUnionFind sets(size);
    for (std::uint32_t i = size - 1; i > 0; --i) {
        sets.join(i, i - 1, true);
    }
    for (std::uint32_t i = 0; i < size; ++i) {
        sets.join(i, (i * 7) % size, (i + i * 7) % 2 == 1);
    }
    EXPECT_EQ(sets.contradictions(), 0U);
    sets.join(size - 1, 1, true);
    EXPECT_EQ(sets.contradictions(), 1U);
}

} // namespace
} // namespace foldless
