#include <foldless/models/lattice.h>

#include <gtest/gtest.h>

namespace foldless {
namespace {

TEST(Lattice, NumbersAnOpenRectangleByRows) {
    const Lattice lattice{2, 1, false, false}; // 3 4 5 over 0 1 2
    EXPECT_EQ(lattice.vertices(), 6);
    EXPECT_EQ(lattice.faces(), 4);
    EXPECT_EQ(lattice.triangle(0), (Triangle{0, 1, 4}));
    EXPECT_EQ(lattice.triangle(1), (Triangle{0, 4, 3}));
    EXPECT_EQ(lattice.triangle(3), (Triangle{1, 5, 4}));
}

TEST(Lattice, ClosesTheDirectionsThatWrap) {
    const Lattice lattice{3, 4, true, true};
    EXPECT_EQ(lattice.vertices(), 12);
    EXPECT_EQ(lattice.faces(), 24);
    EXPECT_EQ(lattice.triangle(23), (Triangle{11, 0, 2})); // the cell at the upper right: 11 9 0 2
}

TEST(Lattice, PlacesTheLastVertexOfAnOpenDirectionAtOne) {
    const Lattice lattice{5, 4, false, true};
    EXPECT_EQ(lattice.place(5).u, 1);
    EXPECT_EQ(lattice.place(lattice.vertices() - 1).v, 0.75);
}

} // namespace
} // namespace foldless
