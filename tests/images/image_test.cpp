#include <foldless/images/image.h>

#include "images.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace foldless {
namespace {

TEST(Number, IsReadFromNumbersAndTexts) {
    const Metadata metadata{{"a", 0.5}, {"b", "1e-3"}, {"c", "-inf"}, {"d", "1 m"}, {"e", ""}};
    EXPECT_EQ(number(metadata, "a"), 0.5);
    EXPECT_EQ(number(metadata, "b"), 1e-3);
    EXPECT_EQ(number(metadata, "c"), -std::numeric_limits<double>::infinity());
    EXPECT_EQ(number(metadata, "d"), std::nullopt);
    EXPECT_EQ(number(metadata, "e"), std::nullopt);
    EXPECT_EQ(number(metadata, "f"), std::nullopt);
}

TEST(RequireSound, RefusesWhatIsNoImage) {
    EXPECT_NO_THROW(require_sound(slope(3, 2, {"Y"})));
    Image image = slope(3, 2, {"R", "G", "B"});
    image.values.pop_back();
    EXPECT_THROW(require_sound(image), std::invalid_argument);
    EXPECT_THROW(require_sound(slope(2, 2, {"R", "R"})), std::invalid_argument);
    EXPECT_THROW(require_sound({0, 2, {"Y"}, {}}), std::invalid_argument);
    EXPECT_THROW(require_sound({-1, -1, {"Y"}, {0.0F}}), std::invalid_argument);
    EXPECT_THROW(require_sound({1, 1, {}, {}}), std::invalid_argument);
    EXPECT_NO_THROW(require_sound(slope(65536, 1, {"Y"})));
    EXPECT_THROW(require_sound(slope(65537, 1, {"Y"})), std::invalid_argument);
}

} // namespace
} // namespace foldless
