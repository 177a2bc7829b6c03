#include <foldless/report/option_names.h>

#include <gtest/gtest.h>

namespace foldless {

namespace {

template <class Option>
class OptionNamesOf : public testing::Test {};

using Options = testing::Types<Preset, Directions, Placement, Boundary, StopReason>;
TYPED_TEST_SUITE(OptionNamesOf, Options);

TYPED_TEST(OptionNamesOf, NameEachValueByAWordOfItsOwn) {
    for (std::size_t i = 0; i < OptionNames<TypeParam>::words.size(); ++i) {
        const auto value = static_cast<TypeParam>(i);
        EXPECT_EQ(option_named<TypeParam>(option_name(value)), value);
    }
}

TYPED_TEST(OptionNamesOf, KnowNoOtherWord) {
    EXPECT_EQ(option_named<TypeParam>("Best"), std::nullopt);
    EXPECT_EQ(option_named<TypeParam>(""), std::nullopt);
}

TEST(OptionNames, AreThoseOfTheCommandLineAndTheReport) {
    EXPECT_EQ(option_name(Preset::standard), "default");
    EXPECT_EQ(option_name(Preset::paper), "paper");
    EXPECT_EQ(option_name(Directions::face), "face");
    EXPECT_EQ(option_name(Directions::area), "area");
    EXPECT_EQ(option_name(Placement::quadric), "quadric");
    EXPECT_EQ(option_name(Boundary::trim), "trim");
    EXPECT_EQ(option_name(StopReason::target_reached), "target_reached");
    EXPECT_EQ(option_name(StopReason::every_edge_refused), "every_edge_refused");
    EXPECT_EQ(option_name(StopReason::time_limit), "time_limit");
}

} // namespace

} // namespace foldless
