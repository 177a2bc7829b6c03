#include <foldless/verify/box_tree.h>

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace foldless::verification {
namespace {

TEST(BoxTree, FindsTheBoxesThatASearchOfAllFinds) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0.0, 1.0);
    const auto point = [&] { return Vec3(place(random), place(random), place(random)); };
    std::vector<Box> boxes;
    for (int i = 0; i < 500; ++i) {
        const Vec3 corner = point();
        boxes.emplace_back(corner, corner + 0.2 * point());
    }
    boxes[100] = Box(); // empty: never met
    const BoxTree tree(boxes);
    for (int i = 0; i < 200; ++i) {
        const Vec3 corner = point();
        const Box query(corner, corner + 0.1 * point());
        std::multiset<int> found;
        std::multiset<int> wanted;
        tree.visit(query, [&](int k) { found.insert(k); });
        for (int k = 0; k < 500; ++k) {
            if (k != 100 && boxes[k].intersects(query)) {
                wanted.insert(k);
            }
        }
        EXPECT_EQ(found, wanted);
    }
}

TEST(BoxTree, FindsNothingInNothing) {
    int visits = 0;
    BoxTree().visit(Box(Vec3::Zero()), [&](int) { ++visits; });
    BoxTree(std::vector<Box>(3)).visit(Box(Vec3::Zero()), [&](int) { ++visits; });
    EXPECT_EQ(visits, 0);
}

TEST(BoxTree, TakesManyEqualBoxes) {
    int visits = 0;
    BoxTree(std::vector<Box>(1000, Box(Vec3::Ones()))).visit(Box(Vec3::Ones()), [&](int) { ++visits; });
    EXPECT_EQ(visits, 1000);
}

} // namespace
} // namespace foldless::verification
