#include "exact_vector.h"
#include "random_triangles.h"

#include <foldless/predicates/enclosure.h>
#include <foldless/predicates/inverse_displacement.h>

#include <gtest/gtest.h>

#include <cmath>

namespace foldless {
namespace {

/// Bits of the numbers that make up a problem: few enough for the displaced point to be a double exactly.
constexpr int bits = 10;

/// A problem whose solution is known exactly.
struct Solved {
    BaseTriangle triangle;
    Vec3 alpha;
    double t;
    Vec3 q;
};

double dyadic(RandomTriangles& random, double lo, double hi) {
    return std::round(std::ldexp(random.number(lo, hi), bits)) * std::ldexp(1.0, -bits);
}

Solved solved(RandomTriangles& random, double tilt) {
    Solved problem{};
    for (int i = 0; i < 3; ++i) {
        problem.triangle.v[i] = Vec3(i == 1 ? 1 : 0, i == 2 ? 1 : 0, 0) + 0.125 * random.dyadic(bits - 3);
        problem.triangle.d[i] = Vec3(0, 0, 1) + tilt * random.dyadic(bits - 3);
    }
    const double a1 = dyadic(random, 0, 0.5);
    const double a2 = dyadic(random, 0, 0.5);
    problem.alpha = {1 - a1 - a2, a1, a2};
    problem.t = dyadic(random, -0.5, 0.5);
    problem.q = displaced(problem.triangle, problem.alpha, problem.t);
    return problem;
}

bool contains(const Enclosure& enclosure, const Vec3& alpha, double t) {
    for (int i = 0; i < 3; ++i) {
        if (abs(mpq_class(enclosure.alpha[i]) - mpq_class(alpha[i])) > mpq_class(enclosure.alpha_error)) {
            return false;
        }
    }
    return abs(mpq_class(enclosure.t) - mpq_class(t)) <= mpq_class(enclosure.t_error);
}

TEST(Enclosure, HoldsTheExactSolution) {
    RandomTriangles random(1);
    for (int round = 0; round < 5000; ++round) {
        const Solved problem = solved(random, round % 2 == 0 ? 0.25 : 0.5);
        const auto at = enclose(problem.triangle, problem.q, problem.alpha, problem.t);
        ASSERT_TRUE(at) << "round " << round;
        EXPECT_TRUE(contains(*at, problem.alpha, problem.t)) << "round " << round;
        EXPECT_LT(at->alpha_error, 1e-12);
        EXPECT_LT(at->t_error, 1e-12);
        EXPECT_GE(at->alpha_error, 0);
    }
}

TEST(Enclosure, HoldsTheExactSolutionFromARoughGuess) {
    RandomTriangles random(2);
    int proven = 0;
    constexpr int rounds = 5000;
    for (int round = 0; round < rounds; ++round) {
        const Solved problem = solved(random, 0.25);
        const double rough = std::pow(10.0, -3 - round % 10);
        const Vec3 off = random.vector(rough);
        const Vec3 guess = problem.alpha + Vec3(-off[0] - off[1], off[0], off[1]);
        const auto at = enclose(problem.triangle, problem.q, guess, problem.t + off[2]);
        if (at) {
            ++proven;
            EXPECT_TRUE(contains(*at, problem.alpha, problem.t)) << "round " << round;
        }
    }
    EXPECT_GT(proven, rounds * 9 / 10);
}

TEST(Enclosure, HoldsTheExactSolutionFarFromTheOrigin) {
    RandomTriangles random(3);
    for (int round = 0; round < 2000; ++round) {
        Solved problem = solved(random, 0.25);
        const Vec3 far = 1024 * random.dyadic(0);
        for (Vec3& v : problem.triangle.v) {
            v += far;
        }
        problem.q = displaced(problem.triangle, problem.alpha, problem.t);
        const auto at = enclose(problem.triangle, problem.q, problem.alpha, problem.t);
        ASSERT_TRUE(at);
        EXPECT_TRUE(contains(*at, problem.alpha, problem.t)) << "round " << round;
    }
}

TEST(Enclosure, HoldsSolutionsOutsideTheTriangleToo) {
    RandomTriangles random(4);
    Solved problem = solved(random, 0.25);
    problem.alpha = {2, -1.5, 0.5};
    problem.q = displaced(problem.triangle, problem.alpha, problem.t);
    const auto at = enclose(problem.triangle, problem.q, problem.alpha, problem.t);
    ASSERT_TRUE(at);
    EXPECT_TRUE(contains(*at, problem.alpha, problem.t));
}

TEST(Enclosure, EnclosesWhatInverseDisplacementFinds) {
    RandomTriangles random(5);
    int proven = 0;
    int asked = 0;
    for (int round = 0; round < 3000; ++round) {
        const BaseTriangle triangle = random.wild();
        const Vec3 q = random.vector();
        for (const Preimage& preimage : InverseDisplacement(triangle).preimages(q)) {
            ++asked;
            const auto at = enclose(triangle, q, preimage.alpha, preimage.t);
            proven += at ? 1 : 0;
            if (at) {
                EXPECT_LE((at->alpha - preimage.alpha).cwiseAbs().maxCoeff(), 1e-3 * (1 + preimage.alpha.norm()));
            }
        }
    }
    EXPECT_GT(proven, asked * 9 / 10);
}

// At t = 1 the corners of this triangle meet: J = 0 there, and no proof exists.
TEST(Enclosure, IsNothingWhereTheMapFolds) {
    const Vec3 top(0.25, 0.25, 1);
    BaseTriangle triangle{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {}};
    for (int i = 0; i < 3; ++i) {
        triangle.d[i] = top - triangle.v[i];
    }
    EXPECT_FALSE(enclose(triangle, top, {0.5, 0.25, 0.25}, 1));
    EXPECT_TRUE(enclose(triangle, {0.25, 0.25, 0.875}, {0.5, 0.25, 0.25}, 0.875));
}

TEST(Enclosure, IsNothingFromAPoorGuess) {
    const BaseTriangle triangle{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                                {Vec3(0.5, 0, 1), Vec3(0, 0.5, 1), Vec3(-0.5, 0, 1)}};
    EXPECT_FALSE(enclose(triangle, {0.25, 0.25, 0.5}, {-40, 20, 21}, 30));
}

TEST(Enclosure, IsNothingForValuesThatAreNotFinite) {
    const BaseTriangle triangle{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                                {Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1)}};
    EXPECT_FALSE(enclose(triangle, {0.25, 0.25, std::nan("")}, {0.5, 0.25, 0.25}, 0));
    EXPECT_FALSE(enclose(triangle, {0.25, 0.25, 0}, {0.5, 0.25, 0.25}, std::nan("")));
}

} // namespace
} // namespace foldless
