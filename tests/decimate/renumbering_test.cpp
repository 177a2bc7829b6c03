#include <foldless/decimate/renumbering.h>

#include <gmock/gmock.h>

#include <random>
#include <vector>

namespace foldless {
namespace {

using testing::ElementsAre;

TEST(NewNumbers, CountWhatIsLeftFromZero) {
    const NewNumbers numbers(6, [](std::int32_t old) { return old != 0 && old != 3; });
    EXPECT_EQ(numbers.before(), 6);
    EXPECT_EQ(numbers.left(), 4);
    EXPECT_EQ(numbers[0], -1);
    EXPECT_EQ(numbers[1], 0);
    EXPECT_EQ(numbers[2], 1);
    EXPECT_EQ(numbers[3], -1);
    EXPECT_EQ(numbers[4], 2);
    EXPECT_EQ(numbers[5], 3);
}

TEST(NewNumbers, AreRightWhereverTheGapsAre) {
    std::mt19937 random(1);
    for (const std::size_t count : {0, 1, 63, 64, 65, 128, 1000}) {
        for (const unsigned gaps : {0U, 1U, 2U, 3U}) { // of three
            std::vector<bool> left;
            for (std::size_t n = 0; n < count; ++n) {
                left.push_back(random() % 3 >= gaps);
            }
            const NewNumbers numbers(count, [&](std::int32_t old) { return left[old]; });
            std::int32_t next = 0;
            for (std::size_t n = 0; n < count; ++n) {
                EXPECT_EQ(numbers[static_cast<std::int32_t>(n)], left[n] ? next++ : -1);
            }
            EXPECT_EQ(numbers.left(), static_cast<std::size_t>(next));
        }
    }
}

TEST(Renumber, MovesWhatIsLeftAndGivesBackTheRest) {
    std::vector<int> values{10, 11, 12, 13, 14};
    renumber(values, NewNumbers(5, [](std::int32_t old) { return old % 2 == 1; }));
    EXPECT_THAT(values, ElementsAre(11, 13));
    EXPECT_EQ(values.capacity(), 2);
}

} // namespace
} // namespace foldless
