#include "deep_check.h"

#include <foldless/io/read_mesh.h>

#include <foldless/verify/verify.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace foldless {
namespace {

/// The scan of that name with unused vertices and all, or nothing in a folder without it.
std::optional<Scan> real_scan(const char* name) {
    const std::filesystem::path path = std::filesystem::path(FOLDLESS_SCANS) / name;
    return std::filesystem::exists(path) ? std::optional<Scan>(read_scan(path).scan) : std::nullopt;
}

/// The scan decimated until every edge is refused, checked to the last invariant; how many faces are left.
std::size_t faces_left(const Scan& scan) {
    const DecimateOptions options;
    const DecimateResult result = decimate(scan, options);
    test::deep_check(scan, options, result);
    return result.base.faces.size();
}

// Collins & Hilton 2002 report 502 faces for the horse and 388 for the bunny, the latter without a locked border.

TEST(RealScans, HorseIsReducedAsFarAsInThePaper) {
    const std::optional<Scan> scan = real_scan("horse.ply");
    if (!scan) {
        GTEST_SKIP() << "no horse.ply in " FOLDLESS_SCANS;
    }
    EXPECT_LE(faces_left(*scan), 502);
}

TEST(RealScans, BunnyIsReducedNearlyAsFarWithALockedBorder) {
    const std::optional<Scan> scan = real_scan("bunny.ply");
    if (!scan) {
        GTEST_SKIP() << "no bunny.ply in " FOLDLESS_SCANS;
    }
    EXPECT_LE(faces_left(*scan), 430);
}

// Its scan faces with all corners on one base face and edges that leave it were once not asked for their orientation.
// The other one has crossings nearly along a wall.
TEST(RealScans, AreCertifiedByTheVerifier) {
    for (const char* const name : {"hammer_scan.ply", "cheese_g133.ply"}) {
        const std::optional<Scan> scan = real_scan(name);
        if (!scan) {
            GTEST_SKIP() << "no " << name << " in " FOLDLESS_SCANS;
        }
        EXPECT_TRUE(verify(decimate(*scan, {}).base, *scan).certified()) << name;
    }
}

} // namespace
} // namespace foldless
