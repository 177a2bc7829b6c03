#include <foldless/decimate/marks.h>

#include <gtest/gtest.h>

namespace foldless {
namespace {

TEST(Marks, MarkEachNumberOnce) {
    Marks marks(130);
    for (const std::int32_t number : {0, 63, 64, 129}) {
        EXPECT_TRUE(marks.mark(number));
        EXPECT_FALSE(marks.mark(number));
    }
    EXPECT_TRUE(marks.mark(1)); // beside others
}

TEST(Marks, TakeAMarkAway) {
    Marks marks(70);
    marks.mark(64);
    marks.mark(65);
    marks.unmark(64);
    EXPECT_TRUE(marks.mark(64));
    EXPECT_FALSE(marks.mark(65));
}

} // namespace
} // namespace foldless
