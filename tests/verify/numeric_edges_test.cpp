// Scans of any unit and anywhere in space, and callers who compute in their own way.

#include "random_scans.h"
#include "violations.h"

#include <foldless/decimate/decimate.h>
#include <foldless/io/bounding_box.h>
#include <foldless/io/errors.h>

#include <gtest/gtest.h>

#include <array>
#include <cfenv>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace foldless {
namespace {

using namespace test;

constexpr int models = 3;

Scan model(int number) {
    Random random(static_cast<std::uint64_t>(number));
    Scan scan = number == 0 ? random_open_scan(random) : random_closed_scan(random);
    scan.float32 = false;
    return scan;
}

/// The scan in other units, some diagonals away from the origin.
Scan placed(Scan scan, double unit, double diagonals) {
    const Vec3 away = diagonals * bounding_box_diagonal(scan) * Vec3(1, -0.5, 0.25);
    for (Vec3& p : scan.positions) {
        p = unit * (p + away);
    }
    return scan;
}

std::string described(double unit, double diagonals, int number) {
    return "model " + std::to_string(number) + ", unit " + std::to_string(std::log10(unit)) + ", diagonals " +
           std::to_string(diagonals);
}

TEST(NumericEdges, AScanOfAnyUnitAnywhereIsCertifiedOrRefused) {
    int certified = 0;
    for (const double unit : {1.0, 1e-12, 1e-6, 1e6, 1e12, 1e-150, 1e150}) {
        for (const double diagonals : {0.0, 1e3, 1e6, 1e9, 1e12}) {
            for (int number = 0; number < models; ++number) {
                const std::string what = described(unit, diagonals, number);
                const Scan scan = placed(model(number), unit, diagonals);
                try {
                    const BaseMesh base = decimate(scan).base;
                    EXPECT_THAT(verify(base, scan), IsCertified()) << what;
                    // The ranges in the file are float32: beyond its numbers nothing can be displaced.
                    const bool has_ranges = unit > 1e-30 && unit < 1e30;
                    EXPECT_TRUE(diagonals > 1e6 || !has_ranges || base.faces.size() < scan.faces.size()) << what;
                    ++certified;
                } catch (const RefusedMesh& refusal) { // rounding has moved vertices into one line or one point
                    EXPECT_GE(diagonals, 1e9) << what << ": " << refusal.what();
                }
            }
        }
    }
    EXPECT_GE(certified, 7 * 4 * models);
}

TEST(NumericEdges, PowersOfTwoChangeNoFace) {
    for (int number = 0; number < models; ++number) {
        const std::vector<Triangle> faces = decimate(model(number)).base.faces;
        for (const int power : {-60, -40, -20, 20, 40, 60}) {
            const Scan scan = placed(model(number), std::ldexp(1.0, power), 0);
            EXPECT_EQ(decimate(scan).base.faces, faces) << "2^" << power;
        }
    }
}

/// What a run gives, and whether it left the caller's arithmetic alone.
auto outcome(const Scan& scan) {
    DecimateOptions options;
    options.threads = 4;
    const DecimateResult result = decimate(scan, options);
    VerifyOptions verify_options;
    verify_options.threads = 4;
    const VerifyResult verified = verify(result.base, scan, verify_options);
    std::vector<double> numbers{verified.min_displacement, verified.max_displacement, verified.rms_displacement,
                                verified.certified() ? 1.0 : 0.0};
    for (const std::vector<Vec3>* vectors : {&result.base.positions, &result.base.directions}) {
        for (const Vec3& v : *vectors) {
            numbers.insert(numbers.end(), v.begin(), v.end());
        }
    }
    for (const Range& range : result.base.ranges) {
        numbers.insert(numbers.end(), {range.lo, range.hi});
    }
    return std::tuple(result.base.faces, numbers);
}

TEST(NumericEdges, TheRoundingModeOfTheCallerChangesNothing) {
    for (int number = 0; number < models; ++number) {
        const Scan scan = model(number);
        const auto expected = outcome(scan);
        for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
            std::fesetround(mode);
            const auto found = outcome(scan);
            const int left = std::fegetround();
            std::fesetround(FE_TONEAREST);
            EXPECT_EQ(left, mode);
            EXPECT_EQ(found, expected) << "mode " << mode;
        }
    }
}

#ifdef __SSE2__
TEST(NumericEdges, ACallerWhoFlushesDenormalsChangesNothing) {
    constexpr unsigned flush_and_no_denormals = 0x8040;
    for (int number = 0; number < models; ++number) {
        const Scan scan = placed(model(number), 1e-34, 0); // squares of cubics are denormal
        const auto expected = outcome(scan);
        const unsigned before = _mm_getcsr();
        _mm_setcsr(before | flush_and_no_denormals);
        const auto found = outcome(scan);
        const unsigned left = _mm_getcsr();
        _mm_setcsr(before);
        EXPECT_EQ(left & flush_and_no_denormals, flush_and_no_denormals);
        EXPECT_EQ(found, expected);
    }
}
#endif

} // namespace
} // namespace foldless
