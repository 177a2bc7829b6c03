#include "exact_vector.h"
#include "random_triangles.h"

#include <foldless/predicates/scan_normal.h>
#include <foldless/predicates/view_along.h>

#include <gtest/gtest.h>

#include <cmath>

namespace foldless {
namespace {

using exact::Vector;

TEST(ViewAlong, IsPositiveCounterClockwiseFromEverySide) {
    for (int k = 0; k < 3; ++k) {
        const Vec3 right = Vec3::Unit((k + 1) % 3);
        const Vec3 up = Vec3::Unit((k + 2) % 3);
        const ViewAlong front(Vec3::Unit(k));
        EXPECT_EQ(turn(front.see(right), front.see(up)), Sign::positive);
        EXPECT_EQ(turn(front.see(up), front.see(right)), Sign::negative);
        const ViewAlong back(-Vec3::Unit(k));
        EXPECT_EQ(turn(back.see(right), back.see(up)), Sign::negative);
    }
}

TEST(ViewAlong, DoesNotSeeDepth) {
    const Vec3 d(0.25, -0.5, 2);
    const ViewAlong view(d);
    EXPECT_EQ(turn(view.see(Vec3(1, 0, 0) + 3 * d), view.see(Vec3(1, 0.001, 0) - 7 * d)), Sign::positive);
    EXPECT_EQ(turn(view.see(Vec3(1, 0, 0)), view.see(Vec3(1, 0, 0) + d)), Sign::undecided);
}

TEST(ViewAlong, AlongNothingIsUndecided) {
    const ViewAlong view(Vec3::Zero());
    EXPECT_EQ(turn(view.see(Vec3::UnitX()), view.see(Vec3::UnitY())), Sign::undecided);
}

// Differences of positions far from the origin; every other one is nearly coplanar with the first and the direction.
TEST(ViewAlong, AgreesWithRationalArithmetic) {
    RandomTriangles random(1);
    int decided = 0;
    constexpr int rounds = 20000;
    for (int round = 0; round < rounds; ++round) {
        const Vec3 d = random.vector(std::ldexp(1.0, round % 60 - 30));
        const Vec3 from = random.vector(std::ldexp(1.0, round % 20));
        const Vec3 a = from + random.vector();
        const Vec3 plane = from + random.number(-1, 1) * (a - from) + random.number(-1, 1) * d;
        const Vec3 b = round % 2 == 0 ? Vec3(from + random.vector()) : plane;
        const ViewAlong view(d);
        const Sign sign = turn(view.see(a - from), view.see(b - from));
        const mpq_class truth = exact::dot(exact::cross(Vector(a) - Vector(from), Vector(b) - Vector(from)), Vector(d));
        if (sign != Sign::undecided) {
            EXPECT_EQ(sign == Sign::positive, sgn(truth) > 0) << "round " << round;
            EXPECT_NE(sgn(truth), 0) << "round " << round;
            ++decided;
        }
    }
    EXPECT_GT(decided, rounds / 2 - rounds / 100);
}

TEST(ViewAlong, LeavesToExactNumbersWhatMayUnderflow) {
    const ViewAlong view(Vec3(0, 0, 1));
    const Vec3 tiny(1e-200, 0, 0);
    EXPECT_EQ(turn(view.see(tiny), view.see(Vec3(0, 1, 0))), Sign::undecided);
    EXPECT_EQ(seen_along({0, 0, 1}, {Vec3::Zero(), tiny, Vec3(0, 1, 0)}), Sign::positive);
}

// Every other time b is turned into the plane of the first edge and the direction at t, but for its rounding.
TEST(TurnAt, AgreesWithRationalArithmetic) {
    RandomTriangles random(2);
    int ties = 0;
    for (int round = 0; round < 5000; ++round) {
        const auto coarse = [&](const Vec3& v) { // few bits, so that exact ties occur
            return Vec3((v * 8).array().round() / 8);
        };
        const auto vertex = [&] { return DisplacedVertex{coarse(random.vector()), coarse(random.vector())}; };
        const DisplacedVertex centre = vertex();
        const DisplacedVertex a = vertex();
        const double t = std::round(random.number(-2, 2) * 4) / 4;
        DisplacedVertex b = vertex();
        if (round % 2 == 0) {
            b = {centre.v + 0.5 * (a.v - centre.v), centre.d + 0.5 * (a.d - centre.d)};
            b.v.x() += round % 4 == 0 ? 0 : std::ldexp(1.0, -(round % 40));
        }
        const auto from_centre = [&](const DisplacedVertex& x) {
            return Vector(x.v) - Vector(centre.v) + mpq_class(t) * (Vector(x.d) - Vector(centre.d));
        };
        const int truth = sgn(exact::dot(exact::cross(from_centre(a), from_centre(b)), Vector(centre.d)));
        const Sign sign = turn_at(centre, a, b, t);
        EXPECT_EQ(sign, truth > 0 ? Sign::positive : truth < 0 ? Sign::negative : Sign::zero) << "round " << round;
        ties += truth == 0 ? 1 : 0;
    }
    EXPECT_GT(ties, 1000);
}

} // namespace
} // namespace foldless
