#include <foldless/decimate/list_store.h>

#include <gmock/gmock.h>

#include <random>
#include <vector>

namespace foldless {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::IsEmpty;

ListHandle add(ListStore& store, std::int32_t owner, const std::vector<std::int32_t>& list) {
    return store.add(owner, list);
}

TEST(ListStore, GivesBackEachList) {
    ListStore store;
    const ListHandle odd = add(store, 0, {3, 1, 2});
    const ListHandle none = add(store, 1, {});
    const ListHandle even = add(store, 2, {-1, 7});
    EXPECT_THAT(store[odd], ElementsAre(3, 1, 2));
    EXPECT_THAT(store[none], IsEmpty());
    EXPECT_THAT(store[even], ElementsAre(-1, 7));
}

TEST(ListStore, TellsTheOwnersOfListsThatAreLeftWhereTheyAre) {
    ListStore store;
    const ListHandle gone = add(store, 5, {1, 2, 3});
    add(store, 6, {4});
    store.remove(gone);
    std::vector<std::pair<std::int32_t, ListHandle>> moved;
    store.compact([&](std::int32_t owner, ListHandle list) { moved.emplace_back(owner, list); });
    ASSERT_EQ(moved.size(), 1);
    EXPECT_EQ(moved[0].first, 6);
    EXPECT_THAT(store[moved[0].second], ElementsAre(4));
}

// As a base mesh uses it: each owner's list is replaced again and again.
TEST(ListStore, KeepsAllListsAndBoundsTheGaps) {
    constexpr std::int32_t owners = 300;
    ListStore store;
    std::mt19937 random(1);
    std::vector<std::vector<std::int32_t>> lists(owners);
    std::vector<ListHandle> handles(owners);
    std::size_t numbers = 0;
    for (std::int32_t owner = 0; owner < owners; ++owner) {
        handles[owner] = add(store, owner, {});
    }
    for (int round = 0; round < 20000; ++round) {
        const auto owner = static_cast<std::int32_t>(random() % owners);
        numbers -= lists[owner].size();
        lists[owner].assign(random() % 20, static_cast<std::int32_t>(random()));
        numbers += lists[owner].size();
        store.remove(handles[owner]);
        handles[owner] = store.add(owner, lists[owner]);
        if (store.is_wasteful()) {
            store.compact([&](std::int32_t moved, ListHandle list) { handles[moved] = list; });
        }
        ASSERT_LT(store.size(), (numbers + 3 * owners) * 8 / 7 + 1100);
    }
    for (std::int32_t owner = 0; owner < owners; ++owner) {
        EXPECT_THAT(store[handles[owner]], ElementsAreArray(lists[owner]));
    }
}

} // namespace
} // namespace foldless
