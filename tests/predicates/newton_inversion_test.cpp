#include "random_triangles.h"

#include <foldless/predicates/newton_inversion.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace foldless {
namespace {

// One more step from a length below 1e-5 leaves about its square.
constexpr double newton_accuracy = 1e-8;

TEST(NewtonInversion, ReadsCoordinatesOffAPrism) {
    const Vec3 up(0, 0, 1);
    const BaseTriangle prism{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {up, up, up}};
    const auto found = newton_inversion(prism, Vec3(0.25, 0.5, 2.0));
    ASSERT_TRUE(found);
    EXPECT_NEAR((found->alpha - Vec3(0.25, 0.25, 0.5)).norm(), 0.0, 1e-15);
    EXPECT_NEAR(found->t, 2.0, 1e-15);
    EXPECT_NEAR(found->slope, 1.0, 1e-15);
}

TEST(NewtonInversion, AgreesWithTheClosedFormNearTheBase) {
    RandomTriangles random(1);
    for (int i = 0; i < 50000; ++i) {
        const BaseTriangle triangle = random.tame();
        const Vec3 alpha = random.barycentric();
        const double t = random.number(-0.3, 0.3);
        const Vec3 q = displaced(triangle, alpha, t);
        const auto found = newton_inversion(triangle, q);
        ASSERT_TRUE(found) << i;
        ASSERT_NEAR((found->alpha - alpha).norm(), 0.0, newton_accuracy) << i;
        ASSERT_NEAR(found->t, t, newton_accuracy) << i;
        const auto preimages = InverseDisplacement(triangle).preimages(q);
        const auto same = [&](const Preimage& p) {
            return (p.alpha - found->alpha).norm() < newton_accuracy && std::abs(p.t - found->t) < newton_accuracy &&
                   std::abs(p.slope - found->slope) < 10.0 * newton_accuracy;
        };
        ASSERT_TRUE(std::any_of(preimages.begin(), preimages.end(), same)) << i;
    }
}

// Directions that point anywhere: the iteration may stop at a least-squares minimum or not at all, and finds at most
// one of several solutions; that is why the closed form decides.
TEST(NewtonInversion, IsNoSubstituteForTheClosedForm) {
    RandomTriangles random(2);
    int missed = 0;
    for (int i = 0; i < 10000; ++i) {
        const BaseTriangle triangle = random.wild();
        const Vec3 alpha = random.barycentric();
        const Vec3 q = displaced(triangle, alpha, random.number(-2, 2));
        const auto found = newton_inversion(triangle, q);
        missed += !found || (found->alpha - alpha).norm() > 1e-3;
    }
    EXPECT_GT(missed, 1000);
    EXPECT_LT(missed, 10000);
}

TEST(NewtonInversion, RefusesWhereNoStepExists) {
    const Vec3 up(0, 0, 1);
    const BaseTriangle point{{Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(0, 0, 0)}, {up, up, up}};
    EXPECT_FALSE(newton_inversion(point, Vec3(1, 0, 1)));
}

} // namespace
} // namespace foldless
