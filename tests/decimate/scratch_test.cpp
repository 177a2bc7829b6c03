#include <foldless/decimate/scratch.h>

#include <gtest/gtest.h>

namespace foldless {
namespace {

TEST(ClearScratch, KeepsLittleRoomAndGivesBackMuch) {
    std::vector<double> little(1000);
    clear_scratch(little);
    EXPECT_TRUE(little.empty());
    EXPECT_GE(little.capacity(), 1000);
    std::vector<double> much(1000000);
    clear_scratch(much);
    EXPECT_TRUE(much.empty());
    EXPECT_EQ(much.capacity(), 0);
}

} // namespace
} // namespace foldless
