#include <foldless/io/bounding_box.h>

#include <gtest/gtest.h>

#include <cmath>

namespace foldless {
namespace {

TEST(BoundingBoxDiagonal, IsThatOfTheVerticesThatFacesUse) {
    Scan scan;
    scan.positions = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {100, 100, 100}};
    scan.faces = {{0, 1, 2}};
    EXPECT_EQ(bounding_box_diagonal(scan), 5.0);
}

TEST(BoundingBoxDiagonal, IsZeroWithoutFaces) {
    EXPECT_EQ(bounding_box_diagonal(Scan{{{1, 2, 3}}, {}}), 0.0);
}

TEST(BoundingBoxDiagonal, OfHugeCoordinatesIsFinite) {
    Scan scan;
    scan.positions = {{0, 0, 0}, {1e200, 0, 0}, {0, 1e200, 0}};
    scan.faces = {{0, 1, 2}};
    EXPECT_DOUBLE_EQ(bounding_box_diagonal(scan), std::sqrt(2.0) * 1e200);
}

} // namespace
} // namespace foldless
