#include "exact_cubic.h"
#include "random_triangles.h"

#include <foldless/predicates/inverse_displacement.h>
#include <foldless/predicates/ray_triangle.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldless {
namespace {

constexpr double unit = std::numeric_limits<double>::epsilon();

const BaseTriangle prism{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1)}};

/// The largest number that enters the sum of eq. 5.
double size_of(const BaseTriangle& triangle, const Preimage& preimage) {
    double size = 0.0;
    for (int i = 0; i < 3; ++i) {
        size += std::abs(preimage.alpha[i]) * (triangle.v[i].norm() + std::abs(preimage.t) * triangle.d[i].norm());
    }
    return size;
}

bool same(const Preimage& a, const Preimage& b) {
    return a.alpha == b.alpha && a.t == b.t && a.slope == b.slope;
}

bool same(const Preimages& a, const Preimages& b) {
    return a.kind == b.kind && std::equal(a.begin(), a.end(), b.begin(), b.end(),
                                          [](const Preimage& x, const Preimage& y) { return same(x, y); });
}

/// Displaces a random point, inverts, and checks that it is found as near as its condition allows (a root moves by
/// rounding / slope, by its square root where the slope vanishes) and that every answer solves eq. 5.
void round_trip(const BaseTriangle& triangle, RandomTriangles& random) {
    const Vec3 alpha = random.barycentric();
    const double t = random.number(-2.0, 2.0);
    const Vec3 q = displaced(triangle, alpha, t);
    const Preimages found = InverseDisplacement(triangle).preimages(q);
    ASSERT_EQ(found.kind, Preimages::Kind::finite);
    double best = std::numeric_limits<double>::infinity();
    double slope = 0.0;
    for (const Preimage& preimage : found) {
        ASSERT_NEAR((displaced(triangle, preimage.alpha, preimage.t) - q).norm(), 0.0,
                    1e-11 * (1.0 + size_of(triangle, preimage)));
        ASSERT_NEAR(preimage.alpha.sum(), 1.0, 4.0 * unit * (1.0 + preimage.alpha.lpNorm<1>()));
        const double distance = (preimage.alpha - alpha).norm() + std::abs(preimage.t - t);
        if (distance < best) {
            best = distance;
            slope = preimage.slope;
        }
    }
    ASSERT_LE(best, std::min(1e-5, 1e-11 / (slope * slope))) << "slope " << slope;
}

TEST(InverseDisplacement, FindsHalfAMillionPointsDisplacedInAnyDirection) {
    RandomTriangles random(1);
    for (int i = 0; i < 500000 && !HasFatalFailure(); ++i) {
        round_trip(random.wild(), random);
    }
}

TEST(InverseDisplacement, FindsHalfAMillionPointsDisplacedNearTheNormal) {
    RandomTriangles random(2);
    for (int i = 0; i < 500000 && !HasFatalFailure(); ++i) {
        round_trip(random.tame(), random);
    }
}

TEST(InverseDisplacement, ReadsCoordinatesOffAPrism) {
    const Preimages found = InverseDisplacement(prism).preimages(Vec3(0.25, 0.5, 7.0));
    ASSERT_EQ(found.size(), 1);
    EXPECT_EQ(found.kind, Preimages::Kind::finite);
    EXPECT_EQ(found[0].alpha, Vec3(0.25, 0.25, 0.5));
    EXPECT_EQ(found[0].t, 7.0);
    EXPECT_EQ(found[0].slope, 1.0);
    EXPECT_TRUE(inside(found[0]));
}

TEST(InverseDisplacement, ListsSolutionsOutsideTheTriangleToo) {
    const InverseDisplacement inverse(prism);
    const Preimages found = inverse.preimages(Vec3(-0.25, 0.5, -3.0));
    ASSERT_EQ(found.size(), 1);
    EXPECT_EQ(found[0].alpha, Vec3(0.75, -0.25, 0.5));
    EXPECT_FALSE(inside(found[0]));
    EXPECT_FALSE(inverse.nearest(Vec3(-0.25, 0.5, -3.0)));
}

TEST(InverseDisplacement, GivesCornersAtZeroWithExactCoordinates) {
    const InverseDisplacement inverse(prism);
    for (int i = 0; i < 3; ++i) {
        const Preimages found = inverse.preimages(prism.v[i]);
        ASSERT_EQ(found.size(), 1);
        EXPECT_EQ(found[0].alpha, Vec3(Vec3::Unit(i)));
        EXPECT_EQ(found[0].t, 0.0);
    }
}

TEST(InverseDisplacement, SortsSolutionsAndRestrictsThemToARange) {
    RandomTriangles random(3);
    int with_three = 0;
    for (int i = 0; i < 20000; ++i) {
        const InverseDisplacement inverse(random.wild());
        const Vec3 q = random.vector();
        const Preimages all = inverse.preimages(q);
        ASSERT_TRUE(std::is_sorted(all.begin(), all.end(), [](auto& a, auto& b) { return a.t < b.t; }));
        with_three += all.size() == 3;
        const Range range{-0.5, 0.75};
        const Preimages some = inverse.preimages(q, range);
        const auto within = [&](const Preimage& p) { return range.lo <= p.t && p.t <= range.hi; };
        ASSERT_EQ(some.size(), std::count_if(all.begin(), all.end(), within));
        ASSERT_TRUE(std::all_of(some.begin(), some.end(), within));
        ASSERT_EQ(some.kind, some.empty() ? Preimages::Kind::none : Preimages::Kind::finite);
    }
    EXPECT_GT(with_three, 1000);
}

TEST(InverseDisplacement, TakesTheNearestOfTheSolutionsInside) {
    RandomTriangles random(4);
    int compared = 0;
    for (int i = 0; i < 20000; ++i) {
        const BaseTriangle triangle = random.wild();
        const InverseDisplacement inverse(triangle);
        const Vec3 q = displaced(triangle, random.barycentric(), random.number(-2, 2));
        const auto nearest = inverse.nearest(q);
        for (const Preimage& preimage : inverse.preimages(q)) {
            if (inside(preimage)) {
                ASSERT_TRUE(nearest);
                ASSERT_LE(std::abs(nearest->t), std::abs(preimage.t));
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 20000);
}

// The fold-free map sends the base point back to q: the ray cast along the interpolated direction meets any triangle
// through q at the same t.
TEST(InverseDisplacement, AgreesWithTheRayThatIsCastBack) {
    RandomTriangles random(5);
    for (int i = 0; i < 100000; ++i) {
        const BaseTriangle triangle = random.tame();
        const Vec3 q = displaced(triangle, random.barycentric(), random.number(-0.5, 0.5));
        const auto preimage = InverseDisplacement(triangle).nearest(q);
        if (!preimage) {
            continue; // rounded across the border of the triangle
        }
        const Ray ray{displaced(triangle, preimage->alpha, 0.0),
                      displaced({triangle.d, triangle.d}, preimage->alpha, 0.0)};
        const Vec3 along = random.vector();
        const Vec3 across = random.vector();
        const ScanTriangle scan{q + along, q + across, q - along - across};
        const auto hit = intersection(ray, scan);
        const double facing = std::abs(ray.direction.dot(along.cross(across)));
        if (facing > 1e-3) {
            ASSERT_TRUE(hit) << i;
            ASSERT_NEAR(hit->t, preimage->t, 1e-10) << i;
            ASSERT_NEAR(hit->u, 1.0 / 3.0, 1e-10) << i;
            ASSERT_NEAR(hit->v, 1.0 / 3.0, 1e-10) << i;
        }
    }
}

// Lemma: at a root of the cubic with coordinates alpha, the slope of the cubic is J(alpha, t).
TEST(InverseDisplacement, HasTheSlopeOfTheCubic) {
    RandomTriangles random(6);
    int compared = 0;
    for (int i = 0; i < 50000; ++i) {
        BaseTriangle triangle = random.wild();
        triangle.d[0][0] = 1.0; // the largest component, so that the unit of t is twice that of lengths
        const InverseDisplacement inverse(triangle);
        const double length = 2.0 * inverse.displacement_unit();
        const Vec3 q = random.vector();
        const Cubic cubic = inverse.cubic(q);
        for (const Preimage& preimage : inverse.preimages(q)) {
            const double t = preimage.t / inverse.displacement_unit();
            const double slope = cubic.slope(t) * 2.0 * length * length;
            const double terms = 3.0 * std::abs(cubic.a) * t * t + 2.0 * std::abs(cubic.b * t) + std::abs(cubic.c);
            const double condition = terms / std::abs(cubic.slope(t)) * preimage.alpha.lpNorm<1>();
            if (condition < 1e4) {
                ASSERT_NEAR(preimage.slope / slope, 1.0, 1e-7) << i;
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 50000);
}

TEST(InverseDisplacement, HasTheSlopeThatTheTripleProductGives) {
    RandomTriangles random(7);
    for (int i = 0; i < 50000; ++i) {
        const BaseTriangle triangle = random.wild();
        for (const Preimage& preimage : InverseDisplacement(triangle).preimages(random.vector())) {
            const double t = preimage.t;
            const Vec3 edge1 = triangle.corner(1, t) - triangle.corner(0, t);
            const Vec3 edge2 = triangle.corner(2, t) - triangle.corner(0, t);
            const Vec3 direction = displaced({triangle.d, triangle.d}, preimage.alpha, 0.0);
            const double size = (1 + t * t) * (1 + preimage.alpha.lpNorm<1>());
            ASSERT_NEAR(preimage.slope, edge1.cross(edge2).dot(direction), 1e-12 * size) << i;
        }
    }
}

TEST(InverseDisplacement, MeasuresTheDistanceAlongTheRenormalisedDirection) {
    RandomTriangles random(8);
    for (int i = 0; i < 10000; ++i) {
        const BaseTriangle triangle = random.wild();
        const InverseDisplacement inverse(triangle);
        const Vec3 q = random.vector();
        for (const Preimage& preimage : inverse.preimages(q)) {
            const double distance = inverse.renormalised_displacement(preimage);
            const double expected = (q - displaced(triangle, preimage.alpha, 0.0)).norm();
            ASSERT_NEAR(std::abs(distance), expected, 1e-11 * (1.0 + size_of(triangle, preimage)));
            ASSERT_EQ(std::signbit(distance), std::signbit(preimage.t));
        }
    }
}

// Positions that are multiples of 2^-20 stay exact when moved by 2^21, which is 10^6 diagonals and more.
TEST(InverseDisplacement, DoesNotDependOnTheOrigin) {
    RandomTriangles random(9);
    const Vec3 offset(0x1p21, -0x1p22, 0x1p21);
    for (int i = 0; i < 20000; ++i) {
        BaseTriangle triangle{{random.dyadic(20), random.dyadic(20), random.dyadic(20)},
                              {random.vector(), random.vector(), random.vector()}};
        const Vec3 q = random.dyadic(20);
        const Preimages here = InverseDisplacement(triangle).preimages(q);
        for (Vec3& v : triangle.v) {
            v += offset;
        }
        ASSERT_TRUE(same(here, InverseDisplacement(triangle).preimages(q + offset))) << i;
    }
}

TEST(InverseDisplacement, DoesNotDependOnPowersOfTwo) {
    RandomTriangles random(10);
    for (int i = 0; i < 20000; ++i) {
        const BaseTriangle triangle = random.wild();
        const double length = std::ldexp(1.0, static_cast<int>(random.number(-490, 490)));
        const double direction = std::ldexp(1.0, static_cast<int>(random.number(-490, 490)));
        BaseTriangle scaled = triangle;
        for (int k = 0; k < 3; ++k) {
            scaled.v[k] *= length;
            scaled.d[k] *= direction;
        }
        const Vec3 q = random.vector();
        const Preimages expected = InverseDisplacement(triangle).preimages(q);
        const Preimages found = InverseDisplacement(scaled).preimages(q * length);
        ASSERT_EQ(found.size(), expected.size()) << i;
        for (int k = 0; k < found.size(); ++k) {
            ASSERT_EQ(found[k].alpha, expected[k].alpha) << i;
            ASSERT_EQ(found[k].t, expected[k].t * (length / direction)) << i;
            ASSERT_EQ(found[k].slope > 0.0, expected[k].slope > 0.0) << i;
            ASSERT_NE(found[k].slope, 0.0) << i;
        }
    }
}

TEST(InverseDisplacement, WorksFromTinyToHugeUnits) {
    RandomTriangles random(11);
    for (const double length : {1e-150, 1e-75, 1e75, 1e150}) {
        for (const double direction : {1e-150, 1.0, 1e150}) {
            const BaseTriangle unscaled = random.tame();
            BaseTriangle triangle = unscaled;
            for (int k = 0; k < 3; ++k) {
                triangle.v[k] *= length;
                triangle.d[k] *= direction;
            }
            const Vec3 alpha(0.5, 0.25, 0.25);
            const double t = 0.25 * (length / direction);
            const auto found = InverseDisplacement(triangle).nearest(displaced(triangle, alpha, t));
            ASSERT_TRUE(found) << length << ' ' << direction;
            EXPECT_NEAR((found->alpha - alpha).norm(), 0.0, 1e-13);
            EXPECT_NEAR(found->t / t, 1.0, 1e-12);
        }
    }
}

TEST(InverseDisplacement, ReachesPointsAMillionTrianglesAway) {
    RandomTriangles random(12);
    for (int i = 0; i < 20000; ++i) {
        const BaseTriangle triangle = random.tame();
        const Vec3 alpha = random.barycentric();
        const double t = random.number(1e6, 2e6);
        const Vec3 q = displaced(triangle, alpha, t);
        double best = std::numeric_limits<double>::infinity();
        for (const Preimage& preimage : InverseDisplacement(triangle).preimages(q)) {
            const double error = (displaced(triangle, preimage.alpha, preimage.t) - q).norm();
            ASSERT_LE(error, 1e-9 * size_of(triangle, preimage)) << i;
            best = std::min(best, error);
        }
        ASSERT_LE(best, 1e-6 * t) << i;
    }
}

TEST(InverseDisplacement, HasNoAnswerForWhatIsNotFinite) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const InverseDisplacement inverse(prism);
    EXPECT_EQ(inverse.preimages(Vec3(nan, 0, 0)).kind, Preimages::Kind::none);
    EXPECT_EQ(inverse.preimages(Vec3(0, 0, std::numeric_limits<double>::infinity())).kind, Preimages::Kind::none);
}

/// How far rounding moves a root of the exact cubic, by the size of the terms of its determinants.
double uncertainty_of(const exact::Polynomial& cubic, const BaseTriangle& triangle, const Vec3& q, double t) {
    const auto grown = [t](const Vec3& p, const Vec3& d) { return p.lpNorm<1>() + std::abs(t) * d.lpNorm<1>(); };
    const double terms = grown(triangle.v[0] - q, triangle.d[0]) *
                         grown(triangle.v[1] - triangle.v[0], triangle.d[1] - triangle.d[0]) *
                         grown(triangle.v[2] - triangle.v[0], triangle.d[2] - triangle.d[0]);
    return 16.0 * unit * (terms / std::abs(exact::value(exact::derivative(cubic), t).get_d()) + std::abs(t));
}

void compare_with_oracle(const BaseTriangle& triangle, const Vec3& q, int number) {
    const exact::Polynomial cubic = exact::cubic(triangle, q);
    const auto expected = exact::sign_changes(cubic, 100);
    const Preimages found = InverseDisplacement(triangle).preimages(q);
    double largest = 0.0;
    for (const mpq_class& root : expected) {
        const double t = root.get_d();
        const double uncertainty = uncertainty_of(cubic, triangle, q, t);
        largest = std::max(largest, uncertainty / (1.0 + std::abs(t)));
        const auto near = [&](const Preimage& p) { return std::abs(p.t - t) <= uncertainty; };
        if (uncertainty < 1e-7 * (1.0 + std::abs(t))) {
            EXPECT_TRUE(std::any_of(found.begin(), found.end(), near)) << "case " << number << ", root " << t;
        }
    }
    if (largest < 1e-7) {
        EXPECT_EQ(found.size(), static_cast<int>(expected.size())) << "case " << number;
    }
}

TEST(InverseDisplacement, AgreesWithTheRootsOfTheExactCubic) {
    RandomTriangles random(13);
    for (int i = 0; i < 1000; ++i) {
        compare_with_oracle(random.wild(), random.vector(), i);
        compare_with_oracle(random.tame(), random.vector(), i);
    }
}

TEST(InverseDisplacement, HasTheCoefficientsOfTheExactCubic) {
    RandomTriangles random(14);
    for (int i = 0; i < 2000; ++i) {
        const BaseTriangle triangle = random.wild();
        const Vec3 q = random.vector();
        const InverseDisplacement inverse(triangle);
        const exact::Polynomial expected = exact::cubic(triangle, q);
        ASSERT_EQ(expected.size(), 4u);
        const Cubic cubic = inverse.cubic(q);
        // One factor relates the units of the two: that of t is known, that of lengths is a power of two.
        const double unit_t = inverse.displacement_unit();
        const double scale = std::exp2(std::round(std::log2(std::abs(cubic.a / expected[3].get_d()))));
        EXPECT_NEAR(cubic.b, expected[2].get_d() * scale / unit_t, 1e-13 * 64) << i;
        EXPECT_NEAR(cubic.c, expected[1].get_d() * scale / unit_t / unit_t, 1e-13 * 64) << i;
        EXPECT_NEAR(cubic.d, expected[0].get_d() * scale / unit_t / unit_t / unit_t, 1e-13 * 64) << i;
    }
}

} // namespace
} // namespace foldless
