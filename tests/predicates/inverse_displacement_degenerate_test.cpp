// Double and triple roots, vanishing coefficients and slices that shrink to a line or a point, each built from the
// formula.

#include "random_triangles.h"

#include <foldless/predicates/inverse_displacement.h>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace foldless {
namespace {

using Kind = Preimages::Kind;

Preimages preimages(const BaseTriangle& triangle, const Vec3& q) {
    return InverseDisplacement(triangle).preimages(q);
}

/// The coefficients b, c, d of C_q are linear in q, so generic directions have one q for any three roots.
std::optional<Vec3> point_with_roots(const BaseTriangle& triangle, double r, double s, double t) {
    const Vec3 p1 = triangle.v[1] - triangle.v[0];
    const Vec3 p2 = triangle.v[2] - triangle.v[0];
    const Vec3 d0 = triangle.d[0];
    const Vec3 d1 = triangle.d[1] - d0;
    const Vec3 d2 = triangle.d[2] - d0;
    Eigen::Matrix3d products;
    products.row(0) = d1.cross(d2);
    products.row(1) = p1.cross(d2) + d1.cross(p2);
    products.row(2) = p1.cross(p2);
    const double a = d0.dot(products.row(0));
    const Vec3 coefficients(-a * (r + s + t), a * (r * s + s * t + t * r), -a * r * s * t);
    const Vec3 known(d0.dot(products.row(1)), d0.dot(products.row(2)), 0.0);
    if (std::abs(products.determinant()) < 0.05 || std::abs(a) < 0.05) {
        return std::nullopt;
    }
    return triangle.v[0] - products.inverse() * (coefficients - known);
}

bool lists(const Preimages& found, double t, double tolerance) {
    return std::any_of(found.begin(), found.end(), [&](const Preimage& p) { return std::abs(p.t - t) <= tolerance; });
}

TEST(InverseDisplacementDegenerate, FindsThreePrescribedRoots) {
    RandomTriangles random(1);
    int built = 0;
    for (int i = 0; i < 50000; ++i) {
        const BaseTriangle triangle = random.wild();
        if (const auto q = point_with_roots(triangle, -1.0, 0.5, 2.0)) {
            const Preimages found = preimages(triangle, *q);
            ASSERT_EQ(found.size(), 3) << i;
            ASSERT_NEAR(found[0].t, -1.0, 1e-10) << i;
            ASSERT_NEAR(found[1].t, 0.5, 1e-10) << i;
            ASSERT_NEAR(found[2].t, 2.0, 1e-10) << i;
            ++built;
        }
    }
    EXPECT_GT(built, 5000);
}

TEST(InverseDisplacementDegenerate, NeverMissesADoubleRoot) {
    RandomTriangles random(2);
    int built = 0;
    for (int i = 0; i < 50000; ++i) {
        const BaseTriangle triangle = random.wild();
        if (const auto q = point_with_roots(triangle, 0.5, 0.5, i % 2 == 0 ? -1.0 : 2.0)) {
            const Preimages found = preimages(triangle, *q);
            ASSERT_TRUE(lists(found, 0.5, 1e-5)) << i;
            ASSERT_TRUE(lists(found, i % 2 == 0 ? -1.0 : 2.0, 1e-9)) << i;
            ++built;
        }
    }
    EXPECT_GT(built, 5000);
}

TEST(InverseDisplacementDegenerate, FindsATripleRoot) {
    RandomTriangles random(3);
    int built = 0;
    for (int i = 0; i < 50000; ++i) {
        const BaseTriangle triangle = random.wild();
        if (const auto q = point_with_roots(triangle, 0.5, 0.5, 0.5)) {
            const Preimages found = preimages(triangle, *q);
            ASSERT_GE(found.size(), 1) << i;
            for (const Preimage& preimage : found) {
                ASSERT_NEAR(preimage.t, 0.5, 1e-3) << i;
            }
            ++built;
        }
    }
    EXPECT_GT(built, 5000);
}

// On the fold J = 0 the two solutions of the neighbourhood meet, inside the triangle.
TEST(InverseDisplacementDegenerate, FindsThePointsOfTheFold) {
    RandomTriangles random(4);
    int built = 0;
    for (int i = 0; i < 50000; ++i) {
        const BaseTriangle triangle = random.wild();
        const double t = random.number(-1, 1);
        const Vec3 normal =
            (triangle.corner(1, t) - triangle.corner(0, t)).cross(triangle.corner(2, t) - triangle.corner(0, t));
        const double j0 = normal.dot(triangle.d[0]);
        const double j1 = normal.dot(triangle.d[1]);
        if (j0 * j1 >= 0.0 || normal.norm() < 0.1) {
            continue;
        }
        const double share = j0 / (j0 - j1);
        const Vec3 alpha(0.75 * (1 - share), 0.75 * share, 0.25);
        const double j2 = normal.dot(triangle.d[2]);
        const double rest = -0.25 * j2; // moved between the first two, keeping their sum
        const Vec3 on_fold = alpha + Vec3(1, -1, 0) * (rest / (j0 - j1));
        const Preimages found = preimages(triangle, displaced(triangle, on_fold, t));
        ASSERT_TRUE(lists(found, t, 1e-4)) << i;
        ++built;
    }
    EXPECT_GT(built, 5000);
}

TEST(InverseDisplacementDegenerate, HasOneSolutionWhereDirectionsAreEqual) {
    RandomTriangles random(5);
    for (int i = 0; i < 20000; ++i) {
        BaseTriangle triangle = random.tame();
        triangle.d = {triangle.d[0], triangle.d[0], triangle.d[0]};
        const Vec3 alpha = random.barycentric();
        const double t = random.number(-2, 2);
        const Vec3 q = displaced(triangle, alpha, t);
        const Cubic cubic = InverseDisplacement(triangle).cubic(q);
        ASSERT_EQ(cubic.a, 0.0);
        ASSERT_EQ(cubic.b, 0.0);
        const Preimages found = preimages(triangle, q);
        ASSERT_EQ(found.size(), 1) << i;
        ASSERT_NEAR(found[0].t, t, 1e-13) << i;
        ASSERT_NEAR((found[0].alpha - alpha).norm(), 0.0, 1e-13) << i;
    }
}

TEST(InverseDisplacementDegenerate, HasOneSolutionWhereDirectionsAreParallel) {
    RandomTriangles random(6);
    for (int i = 0; i < 20000; ++i) {
        BaseTriangle triangle = random.tame();
        const Vec3 direction = triangle.d[0];
        for (Vec3& d : triangle.d) {
            d = direction * random.number(0.1, 3.0);
        }
        const Vec3 alpha = random.barycentric();
        const double t = random.number(-2, 2);
        const Preimages found = preimages(triangle, displaced(triangle, alpha, t));
        ASSERT_EQ(found.size(), 1) << i;
        ASSERT_NEAR(found[0].t, t, 1e-12) << i;
        ASSERT_NEAR((found[0].alpha - alpha).norm(), 0.0, 1e-12) << i;
    }
}

TEST(InverseDisplacementDegenerate, HasAtMostTwoSolutionsWhereDirectionsShareAPlane) {
    RandomTriangles random(7);
    for (int i = 0; i < 20000; ++i) {
        BaseTriangle triangle = random.tame();
        triangle.d[2] = random.number(0.2, 1.0) * triangle.d[0] + random.number(0.2, 1.0) * triangle.d[1];
        const Vec3 alpha = random.barycentric();
        const double t = random.number(-0.5, 0.5);
        const Preimages found = preimages(triangle, displaced(triangle, alpha, t));
        ASSERT_LE(found.size(), 2) << i;
        ASSERT_TRUE(lists(found, t, 1e-7)) << i;
    }
}

// Maggiordomo et al. 2023, section 3.2, say that the cubic has degree 0 then. It need not: N(t) keeps its line but not
// its length, so for q off the plane C_q is the height times a quadratic, whose roots are slices that shrink to a line.
// The coordinates are short enough for the vectors to be in the plane exactly.
TEST(InverseDisplacementDegenerate, HasNoSolutionOffThePlaneOfInPlaneDirections) {
    RandomTriangles random(8);
    int with_roots = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 x = random.dyadic(8);
        const Vec3 y = random.dyadic(8);
        const auto in_plane = [&] {
            const Vec3 shares = random.dyadic(8);
            return Vec3(shares[0] * x + shares[1] * y);
        };
        const BaseTriangle triangle{{Vec3::Zero(), in_plane(), in_plane()}, {in_plane(), in_plane(), in_plane()}};
        const Vec3 q = in_plane() + x.cross(y);
        if (x.cross(y).norm() > 0.1) {
            const InverseDisplacement inverse(triangle);
            ASSERT_EQ(inverse.preimages(q).kind, Kind::none) << i;
            with_roots += real_roots(inverse.cubic(q)).count > 0;
        }
    }
    EXPECT_GT(with_roots, 1000);
}

TEST(InverseDisplacementDegenerate, HasDegreeZeroForParallelInPlaneDirections) {
    const BaseTriangle triangle{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                                {Vec3(1, 1, 0), Vec3(1, 1, 0), Vec3(1, 1, 0)}};
    const Cubic cubic = InverseDisplacement(triangle).cubic(Vec3(0.25, 0.25, 1.0));
    EXPECT_EQ(cubic.a, 0.0);
    EXPECT_EQ(cubic.b, 0.0);
    EXPECT_EQ(cubic.c, 0.0);
    EXPECT_NE(cubic.d, 0.0);
    EXPECT_EQ(preimages(triangle, Vec3(0.25, 0.25, 1.0)).kind, Kind::none);
}

TEST(InverseDisplacementDegenerate, IsInfiniteInThePlaneOfInPlaneDirections) {
    const BaseTriangle triangle{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                                {Vec3(1, 0, 0), Vec3(0.5, 1, 0), Vec3(0, 2, 0)}};
    EXPECT_EQ(preimages(triangle, Vec3(0.25, 0.25, 0.0)).kind, Kind::infinite);
}

TEST(InverseDisplacementDegenerate, IsInfiniteWhereThreeRaysMeet) {
    const Vec3 apex(0.25, 0.25, 1.0);
    BaseTriangle triangle{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {}};
    for (int i = 0; i < 3; ++i) {
        triangle.d[i] = apex - triangle.v[i];
    }
    EXPECT_EQ(preimages(triangle, apex).kind, Kind::infinite);
    EXPECT_EQ(InverseDisplacement(triangle).preimages(apex, {0.0, 2.0}).kind, Kind::infinite);
    EXPECT_EQ(InverseDisplacement(triangle).preimages(apex, {0.0, 0.5}).kind, Kind::none);
}

TEST(InverseDisplacementDegenerate, IsInfiniteWhereThreeRandomRaysMeet) {
    RandomTriangles random(9);
    for (int i = 0; i < 20000; ++i) {
        BaseTriangle triangle = random.tame();
        const Vec3 apex = random.vector() + Vec3(0, 0, 2);
        const double t = random.number(0.5, 2.0);
        for (int k = 0; k < 3; ++k) {
            triangle.d[k] = (apex - triangle.v[k]) / t;
        }
        ASSERT_EQ(preimages(triangle, apex).kind, Kind::infinite) << i;
    }
}

TEST(InverseDisplacementDegenerate, HasNoSolutionBesideThePointWhereThreeRaysMeet) {
    RandomTriangles random(10);
    for (int i = 0; i < 20000; ++i) {
        BaseTriangle triangle{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {}};
        const Vec3 apex(0.25, 0.25, 1.0);
        for (int k = 0; k < 3; ++k) {
            triangle.d[k] = apex - triangle.v[k];
        }
        // At the height of the apex every slice but the one that is a point lies elsewhere.
        const Vec3 beside = apex + Vec3(random.number(0.1, 1.0), random.number(-1.0, 1.0), 0.0);
        ASSERT_EQ(preimages(triangle, beside).kind, Kind::none) << i;
    }
}

/// Directions that bring the corners to three points of one line at t = 1.
BaseTriangle collapsing(RandomTriangles& random, const Vec3& foot, const Vec3& along) {
    BaseTriangle triangle = random.tame();
    for (int k = 0; k < 3; ++k) {
        triangle.d[k] = foot + random.number(-1, 1) * along - triangle.v[k];
    }
    return triangle;
}

TEST(InverseDisplacementDegenerate, IsInfiniteOnTheLineToWhichASliceShrinks) {
    RandomTriangles random(11);
    for (int i = 0; i < 20000; ++i) {
        const Vec3 foot = random.vector() + Vec3(0, 0, 2);
        const Vec3 along = random.vector();
        const BaseTriangle triangle = collapsing(random, foot, along);
        ASSERT_EQ(preimages(triangle, foot + random.number(-1, 1) * along).kind, Kind::infinite) << i;
    }
}

TEST(InverseDisplacementDegenerate, IgnoresASliceThatShrinksToALineBesideThePoint) {
    RandomTriangles random(12);
    for (int i = 0; i < 20000; ++i) {
        const Vec3 foot = random.vector() + Vec3(0, 0, 2);
        const Vec3 along = random.vector();
        const BaseTriangle triangle = collapsing(random, foot, along);
        const Vec3 beside = foot + along.cross(random.vector()).normalized() * random.number(0.1, 1.0);
        const Preimages found = preimages(triangle, beside);
        ASSERT_NE(found.kind, Kind::infinite) << i;
        for (const Preimage& preimage : found) {
            const Vec3 image = displaced(triangle, preimage.alpha, preimage.t);
            ASSERT_NEAR((image - beside).norm(), 0.0, 1e-6 * (1.0 + preimage.alpha.lpNorm<1>())) << i;
        }
    }
}

TEST(InverseDisplacementDegenerate, HasNoSolutionOfADirectionlessTriangleOffItsPlane) {
    const BaseTriangle triangle{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                                {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}};
    EXPECT_EQ(preimages(triangle, Vec3(0.25, 0.25, 1.0)).kind, Kind::none);
    EXPECT_EQ(preimages(triangle, Vec3(0.25, 0.25, 0.0)).kind, Kind::infinite);
}

TEST(InverseDisplacementDegenerate, InvertsATriangleThatIsAPointAtZero) {
    const BaseTriangle cone{{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()},
                            {Vec3(1, 0, 1), Vec3(-1, 1, 1), Vec3(-1, -1, 1)}};
    const Preimages found = preimages(cone, Vec3(0, 0, 2));
    ASSERT_EQ(found.size(), 1);
    EXPECT_NEAR(found[0].t, 2.0, 1e-14);
    EXPECT_NEAR((found[0].alpha - Vec3(0.5, 0.25, 0.25)).norm(), 0.0, 1e-14);
    EXPECT_EQ(found.kind, Kind::finite);
    EXPECT_EQ(preimages(cone, Vec3::Zero()).kind, Kind::infinite);
}

TEST(InverseDisplacementDegenerate, InvertsAThinTriangle) {
    for (const double width : {1e-3, 1e-5, 1e-7}) {
        const BaseTriangle thin{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, width, 0)},
                                {Vec3(-0.1, 0, 1), Vec3(0.1, 0, 1), Vec3(0, 0.1 * width, 1)}};
        const Vec3 alpha(0.25, 0.25, 0.5);
        const auto found = InverseDisplacement(thin).nearest(displaced(thin, alpha, 0.5));
        ASSERT_TRUE(found) << width;
        EXPECT_NEAR(found->t, 0.5, 1e-14 / width) << width;
        EXPECT_NEAR((found->alpha - alpha).norm(), 0.0, 1e-14 / width) << width;
    }
}

TEST(InverseDisplacementDegenerate, SaysWhereNoDoubleHoldsASolution) {
    BaseTriangle prism{};
    prism.v = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    prism.d = {Vec3(0, 0, 1e-140), Vec3(0, 0, 1e-140), Vec3(0, 0, 1e-140)};
    EXPECT_EQ(preimages(prism, Vec3(0.25, 0.25, 1e160)).size(), 1);
    const Preimages beyond = preimages(prism, Vec3(0.25, 0.25, 1e200)); // t is 1e340
    EXPECT_EQ(beyond.size(), 0);
    EXPECT_EQ(beyond.kind, Kind::infinite);
    for (int exponent = -1000; exponent <= 1000; exponent += 50) {
        RandomTriangles random(static_cast<unsigned>(exponent + 2000));
        for (int i = 0; i < 200; ++i) {
            BaseTriangle triangle = random.wild();
            for (Vec3& d : triangle.d) {
                d *= std::ldexp(1.0, exponent);
            }
            for (const Preimage& found : preimages(triangle, Vec3(1, 2, 3) * std::ldexp(1.0, -exponent / 2))) {
                ASSERT_TRUE(std::isfinite(found.t) && found.alpha.allFinite()) << exponent << " " << i;
            }
        }
    }
}

} // namespace
} // namespace foldless
