#include "random_triangles.h"

#include <foldless/predicates/inverse_displacement.h>
#include <foldless/predicates/prismoid_point.h>
#include <foldless/predicates/scan_orientation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace foldless {
namespace {

const BarycentricTriangle whole{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};

Vec3 at(double first, double second) {
    return {first, second, 1.0 - first - second};
}

TEST(ScanOrientation, IsPositiveForTheBaseTriangleItself) {
    EXPECT_EQ(scan_orientation(whole), Sign::positive);
    EXPECT_EQ(scan_orientation({whole[1], whole[2], whole[0]}), Sign::positive);
    EXPECT_EQ(scan_orientation({whole[2], whole[0], whole[1]}), Sign::positive);
}

TEST(ScanOrientation, ChangesWithTheOrderOfTheCorners) {
    EXPECT_EQ(scan_orientation({whole[1], whole[0], whole[2]}), Sign::negative);
    EXPECT_EQ(scan_orientation({whole[0], whole[2], whole[1]}), Sign::negative);
}

TEST(ScanOrientation, IsZeroForCornersOnALine) {
    EXPECT_EQ(scan_orientation({at(0.25, 0.25), at(0.5, 0.25), at(0.125, 0.25)}), Sign::zero);
    EXPECT_EQ(scan_orientation({at(0.25, 0.25), at(0.25, 0.25), at(0.5, 0.125)}), Sign::zero);
}

// Differences of a few ulps, which the determinant in doubles takes for zero.
TEST(ScanOrientation, IsExactWhereRoundingHidesTheDeterminant) {
    const double ulp = 0x1p-53;
    const BarycentricTriangle left{at(0.5, 0.5), at(0.25, 0.25), at(0.75 + ulp, 0.75 + 2 * ulp)};
    EXPECT_EQ(scan_orientation({at(0.5, 0.5), at(0.75, 0.75), at(0.25, 0.25 + ulp)}), Sign::positive);
    EXPECT_EQ(scan_orientation({at(0.5, 0.5), at(0.75, 0.75), at(0.25, 0.25 - ulp)}), Sign::negative);
    EXPECT_EQ(scan_orientation({at(0.5, 0.5), at(0.75, 0.75), at(0.25, 0.25)}), Sign::zero);
    EXPECT_NE(scan_orientation(left), Sign::undecided);
}

TEST(ScanOrientation, IsUndecidedOnWhatIsNotFinite) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(scan_orientation({Vec3(nan, 0, 0), whole[1], whole[2]}), Sign::undecided);
    EXPECT_EQ(scan_orientation({Vec3(nan, 0, 0), whole[1], whole[2]}, {1e-9, 1e-9, 1e-9}), Sign::undecided);
}

/// Eq. 19 of Maggiordomo et al. 2023 letter by letter.
double misprinted(const BarycentricTriangle& alpha) {
    return (alpha[1][0] - alpha[0][0]) * (alpha[1][1] - alpha[0][1]) -
           (alpha[2][0] - alpha[0][0]) * (alpha[2][1] - alpha[0][1]);
}

// A small scan triangle over a prism, so that the image is the scan triangle seen from above: counterclockwise, not
// folded. The printed formula calls it turned over.
TEST(ScanOrientation, IsNotThePrintedFormula) {
    const Vec3 up(0, 0, 1);
    const BaseTriangle prism{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {up, up, up}};
    const ScanTriangle scan{Vec3(0.25, 0.25, 1), Vec3(0.25, 0.5, 1), Vec3(0.125, 0.5, 1)};
    BarycentricTriangle alpha;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        alpha[corner] = InverseDisplacement(prism).preimages(scan[corner])[0].alpha;
    }
    ASSERT_GT((scan[1] - scan[0]).cross(scan[2] - scan[0]).dot(up), 0.0);
    EXPECT_EQ(scan_orientation(alpha), Sign::positive);
    EXPECT_LT(misprinted(alpha), 0.0);
}

TEST(ScanOrientation, IsUndecidedWhereErrorsHideTheSign) {
    const BarycentricTriangle flat{at(0.25, 0.25), at(0.75, 0.25), at(0.5, 0.25 + 1e-9)};
    EXPECT_EQ(scan_orientation(flat, {0.0, 0.0, 0.0}), scan_orientation(flat));
    EXPECT_EQ(scan_orientation(flat, {0.0, 0.0, 1e-8}), Sign::undecided);
    EXPECT_EQ(scan_orientation(flat, {1e-8, 0.0, 0.0}), Sign::undecided);
    EXPECT_EQ(scan_orientation(flat, {0.0, 1e-8, 0.0}), Sign::undecided);
    EXPECT_EQ(scan_orientation(flat, {1e-11, 1e-11, 1e-11}), scan_orientation(flat));
    EXPECT_EQ(scan_orientation({flat[0], flat[1], at(0.5, 0.25)}, {1e-300, 0.0, 0.0}), Sign::undecided);
}

// A decided sign is the exact sign of every triangle within the errors.
TEST(ScanOrientation, IsNeverWrongWithinTheErrors) {
    RandomTriangles random(1);
    int decided = 0;
    for (int i = 0; i < 200000; ++i) {
        const double size = std::ldexp(1.0, -static_cast<int>(random.number(0, 52)));
        const double error = size * std::ldexp(1.0, -static_cast<int>(random.number(0, 12)));
        const Vec3 centre = random.barycentric();
        BarycentricTriangle known;
        BarycentricTriangle truth;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            truth[corner] = centre + random.vector(size);
            // Nearly the whole error; the rest is for the rounding of this sum.
            known[corner] = truth[corner] + random.vector(1.0).cwiseSign() * (error * 0.75);
        }
        const double bound = error + 0x1p-52;
        const Sign sign = scan_orientation(known, {bound, bound, bound});
        if (sign != Sign::undecided) {
            ++decided;
            ASSERT_EQ(sign, scan_orientation(truth)) << i;
        }
    }
    EXPECT_GT(decided, 50000);
}

/// Points with displacements known within two doubles, as roots of their cubics.
class ScanOrientationOfPoints : public testing::Test {
protected:
    ScanOrientationOfPoints() {
        RandomTriangles random(77);
        triangle_ = {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {}};
        for (Vec3& d : triangle_.d) {
            d = Vec3(0, 0, 1) + random.vector(0.3);
        }
    }

    [[nodiscard]] Vec3 point(double first, double second, double t) const {
        const Vec3 alpha = at(first, second);
        return alpha[0] * triangle_.corner(0, t) + alpha[1] * triangle_.corner(1, t) +
               alpha[2] * triangle_.corner(2, t);
    }
    [[nodiscard]] DisplacedPoint displaced(const Vec3& q) const {
        return {q, PointFinder(triangle_, {-0.5, 0.5}).find(q).value().t};
    }
    [[nodiscard]] Sign orientation(const Vec3& a, const Vec3& b, const Vec3& c) const {
        return scan_orientation(triangle_, {displaced(a), displaced(b), displaced(c)});
    }

    BaseTriangle triangle_;
};

TEST_F(ScanOrientationOfPoints, IsThatOfTheirCoordinates) {
    const Vec3 a = point(0.25, 0.25, 0.1);
    const Vec3 b = point(0.25, 0.5, -0.2);
    const Vec3 c = point(0.5, 0.25, 0.3);
    const Sign expected = scan_orientation({at(0.25, 0.25), at(0.25, 0.5), at(0.5, 0.25)});
    EXPECT_EQ(orientation(a, b, c), expected);
    EXPECT_EQ(orientation(b, a, c), -expected);
    EXPECT_EQ(scan_orientation(triangle_, {DisplacedPoint{triangle_.v[0], Displacement()},
                                           DisplacedPoint{triangle_.v[1], Displacement()}, displaced(c)}),
              Sign::positive);
}

// Three places on a line but for the last bits of the points, which enclosures in doubles cannot tell.
TEST_F(ScanOrientationOfPoints, IsDecidedWithinTheRoundingOfDoubles) {
    int signs[2] = {};
    for (int n = 0; n < 100; ++n) {
        const Vec3 a = point(0.25, 0.25, 0.1 + 0.001 * n);
        const Vec3 b = point(0.375, 0.3125, 0.0013 * n - 0.2);
        const Vec3 c = point(0.5, 0.375, 0.3 - 0.0017 * n);
        const Sign sign = orientation(a, b, c);
        EXPECT_TRUE(sign == Sign::positive || sign == Sign::negative);
        EXPECT_EQ(orientation(b, c, a), sign);
        EXPECT_EQ(orientation(b, a, c), -sign);
        ++signs[sign == Sign::positive ? 1 : 0];
    }
    EXPECT_GT(signs[0], 0);
    EXPECT_GT(signs[1], 0);
}

// Irrational displacements and three places on a line: no number of halvings tells that from nearly so.
TEST_F(ScanOrientationOfPoints, IsUndecidedIfHalvingDoesNotTell) {
    const Vec3 a = point(0.25, 0.25, 0.1);
    const Vec3 b = point(0.5, 0.375, 0.3);
    EXPECT_EQ(orientation(a, b, a), Sign::undecided);
    const DisplacedPoint corner{triangle_.v[0], Displacement()};
    const DisplacedPoint other{triangle_.v[1], Displacement()};
    EXPECT_EQ(scan_orientation(triangle_, {corner, other, corner}), Sign::zero);
}

} // namespace
} // namespace foldless
