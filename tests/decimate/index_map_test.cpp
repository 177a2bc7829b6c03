#include <foldless/decimate/index_map.h>

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace foldless {
namespace {

TEST(IndexMap, HoldsNothingAtFirst) {
    const IndexMap map;
    EXPECT_EQ(map.find(0), -1);
    EXPECT_FALSE(map.contains(7));
}

TEST(IndexMap, FindsTheLastNumberThatWasSet) {
    IndexMap map;
    map.set(5, 1);
    map.set(2000000000, 2);
    map.set(5, 3);
    EXPECT_EQ(map.find(5), 3);
    EXPECT_EQ(map.find(2000000000), 2);
    EXPECT_EQ(map.find(6), -1);
}

TEST(IndexMap, InsertsOnce) {
    IndexMap map;
    EXPECT_TRUE(map.insert(4));
    EXPECT_FALSE(map.insert(4));
    EXPECT_TRUE(map.contains(4));
    EXPECT_EQ(map.find(4), 0);
}

TEST(IndexMap, HoldsAsManyAsItHasMemoryForAndMore) {
    IndexMap map;
    map.set(5, 1);
    map.reserve(100000);
    map.reserve(10);
    for (std::int32_t index = 0; index < 200000; ++index) {
        map.set(index, index / 2);
    }
    EXPECT_EQ(map.find(5), 2);
    EXPECT_EQ(map.find(199999), 99999);
    map.clear(); // and gives back memory
    EXPECT_FALSE(map.contains(5));
    map.set(7, 8);
    EXPECT_EQ(map.find(7), 8);
    EXPECT_FALSE(map.contains(199999));
}

TEST(IndexMap, ForgetsAllWhenCleared) {
    IndexMap map;
    map.set(3, 8);
    map.clear();
    EXPECT_FALSE(map.contains(3));
    EXPECT_TRUE(map.insert(3));
}

TEST(IndexMap, IsThatOfTheStandardLibraryThroughAnySteps) {
    std::mt19937 random(1);
    IndexMap map;
    std::map<std::int32_t, std::int32_t> truth;
    for (int round = 0; round < 200; ++round) {
        // Neighbours, or all over the indices; more and more of them.
        const unsigned most = round % 2 == 0 ? 1000U : 0x7FFFFFFFU;
        for (int n = 0; n < round; ++n) {
            const auto index = static_cast<std::int32_t>(random() % most);
            map.set(index, n);
            truth[index] = n;
            const auto other = static_cast<std::int32_t>(random() % most);
            ASSERT_EQ(map.insert(other), truth.try_emplace(other, 0).second);
        }
        for (const auto& [index, number] : truth) {
            ASSERT_EQ(map.find(index), number);
            ASSERT_EQ(map.contains(index ^ 1), truth.count(index ^ 1) > 0);
        }
        map.clear();
        truth.clear();
    }
}

} // namespace
} // namespace foldless
