#include <foldless/report/progress_bar.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace foldless {

namespace {

TEST(BarText, FillsTheBarByTheShareThatIsDone) {
    EXPECT_EQ(bar_text("decimating", 0.0, "20 faces"), "decimating [..............................]   0 %  20 faces");
    EXPECT_EQ(bar_text("decimating", 0.5, "10 faces"), "decimating [###############...............]  50 %  10 faces");
    EXPECT_EQ(bar_text("decimating", 1.0, "2 faces"), "decimating [##############################] 100 %  2 faces");
}

TEST(BarText, CutsSharesThatAreNone) {
    EXPECT_EQ(bar_text("x", 7.0, ""), bar_text("x", 1.0, ""));
    EXPECT_EQ(bar_text("x", -7.0, ""), bar_text("x", 0.0, ""));
    EXPECT_EQ(bar_text("x", std::numeric_limits<double>::quiet_NaN(), ""), bar_text("x", 0.0, ""));
}

TEST(ProgressBar, DrawsAtOnceAndThenNotTooOften) {
    int drawn = 0;
    ProgressBar bar([&](std::string_view) { ++drawn; });
    for (int i = 0; i < 1000; ++i) {
        bar.show("verifying", i / 1000.0, "");
    }
    EXPECT_GE(drawn, 1);
    EXPECT_LT(drawn, 1000);
}

TEST(ProgressBar, LeavesAnEmptyLine) {
    std::string drawn;
    {
        ProgressBar bar([&](std::string_view text) { drawn += text; });
        bar.show("verifying", 0.5, "");
    }
    EXPECT_NE(drawn.find("verifying"), std::string::npos);
    EXPECT_TRUE(drawn.ends_with("\r\x1b[K")) << drawn;
}

TEST(ProgressBar, WritesNothingIfNothingWasShown) {
    std::string drawn;
    {
        ProgressBar bar([&](std::string_view text) { drawn += text; });
    }
    EXPECT_EQ(drawn, "");
}

TEST(ProgressBar, WithoutOutputDrawsNothing) {
    ProgressBar bar(ProgressBar::Write{});
    EXPECT_NO_THROW(bar.show("verifying", 0.5, ""));
}

} // namespace

} // namespace foldless
