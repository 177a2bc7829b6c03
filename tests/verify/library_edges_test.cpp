// Callers of the library who do what callers do: call again, from several threads, with nonsense, and throw.

#include "random_scans.h"
#include "violations.h"

#include <foldless/decimate/decimate.h>
#include <foldless/io/errors.h>

#include <gtest/gtest.h>

#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace foldless {
namespace {

using namespace test;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

Scan scan_number(int number) {
    Random random(static_cast<std::uint64_t>(number));
    return number % 2 == 0 ? random_closed_scan(random) : random_open_scan(random);
}

struct Outcome {
    BaseMesh base;
    VerifyResult verified;
};

Outcome outcome(const Scan& scan, int threads = 2) {
    DecimateOptions options;
    options.threads = threads;
    VerifyOptions verify_options;
    verify_options.threads = threads;
    BaseMesh base = decimate(scan, options).base;
    VerifyResult verified = verify(base, scan, verify_options);
    return {std::move(base), std::move(verified)};
}

/// Bit for bit, and the proof with it.
void expect_same(const Outcome& found, const Outcome& expected) {
    EXPECT_EQ(found.base.faces, expected.base.faces);
    EXPECT_EQ(found.base.positions, expected.base.positions);
    EXPECT_EQ(found.base.directions, expected.base.directions);
    EXPECT_THAT(found.verified, IsCertified());
    EXPECT_EQ(found.verified.max_displacement, expected.verified.max_displacement);
    EXPECT_EQ(found.verified.signs.filtered, expected.verified.signs.filtered);
    EXPECT_EQ(found.verified.signs.exact, expected.verified.signs.exact);
}

struct OfTheCaller : std::runtime_error {
    using std::runtime_error::runtime_error;
};

TEST(LibraryEdges, ASecondCallGivesWhatTheFirstGave) {
    const Scan scan = scan_number(0);
    const Outcome first = outcome(scan);
    expect_same(outcome(scan), first);
}

TEST(LibraryEdges, ACallAfterAnErrorGivesWhatItGivesWithoutOne) {
    const Scan scan = scan_number(0);
    const Outcome expected = outcome(scan);
    Scan broken = scan;
    broken.faces.push_back(broken.faces.front());
    EXPECT_THROW((void)decimate(broken), RefusedMesh);
    EXPECT_THROW((void)verify(expected.base, broken), RefusedMesh);
    expect_same(outcome(scan), expected);
}

TEST(LibraryEdges, CallsAtOnceFromSeveralThreadsGiveWhatEachGivesAlone) {
    constexpr int callers = 6;
    std::vector<Outcome> expected;
    for (int number = 0; number < callers; ++number) {
        expected.push_back(outcome(scan_number(number)));
    }
    std::vector<Outcome> found(callers);
    std::vector<std::thread> threads;
    for (int number = 0; number < callers; ++number) {
        threads.emplace_back([&found, number] {
            found[static_cast<std::size_t>(number)] = outcome(scan_number(number), 1 + number % 3);
        });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    for (std::size_t number = 0; number < callers; ++number) {
        expect_same(found[number], expected[number]);
    }
}

TEST(LibraryEdges, CallsInsideALoopOfTheCallerGiveWhatEachGivesAlone) {
    constexpr std::size_t calls = 8;
    std::vector<Outcome> found(calls);
    tbb::parallel_for(std::size_t{0}, calls,
                      [&](std::size_t i) { found[i] = outcome(scan_number(static_cast<int>(i))); });
    for (std::size_t i = 0; i < calls; ++i) {
        expect_same(found[i], outcome(scan_number(static_cast<int>(i))));
    }
}

TEST(LibraryEdges, WhatACallbackThrowsComesOutAndTheNextCallIsAsEver) {
    const Scan scan = scan_number(0);
    const Outcome expected = outcome(scan);
    DecimateOptions options;
    options.progress = [](const Progress&) -> bool { throw OfTheCaller("decimate"); };
    EXPECT_THROW((void)decimate(scan, options), OfTheCaller);
    VerifyOptions verify_options;
    verify_options.progress = [](double) -> bool { throw OfTheCaller("verify"); };
    EXPECT_THROW((void)verify(expected.base, scan, verify_options), OfTheCaller);
    expect_same(outcome(scan), expected);
}

TEST(LibraryEdges, ACancelledDecimationIsCertifiedAndACancelledVerificationIsNot) {
    const Scan scan = scan_number(0);
    DecimateOptions options;
    options.progress = [](const Progress&) { return false; };
    const DecimateResult stopped = decimate(scan, options);
    EXPECT_EQ(stopped.stop_reason, StopReason::cancelled);
    EXPECT_THAT(verify(stopped.base, scan), IsCertified());
    VerifyOptions verify_options;
    verify_options.progress = [](double) { return false; };
    const VerifyResult verified = verify(stopped.base, scan, verify_options);
    EXPECT_TRUE(verified.cancelled);
    EXPECT_FALSE(verified.certified());
}

TEST(LibraryEdges, EmptyScansAreRefused) {
    const Outcome good = outcome(scan_number(0));
    const Scan whole = scan_number(0);
    for (const Scan& scan : {Scan{}, Scan{whole.positions, {}, true}, Scan{{}, whole.faces, true}}) {
        EXPECT_THROW((void)decimate(scan), RefusedMesh);
        EXPECT_THROW((void)verify(good.base, scan), RefusedMesh);
    }
    EXPECT_THROW((void)verify(BaseMesh{}, whole), RefusedMesh);
}

TEST(LibraryEdges, IndicesThatAreNoVerticesAreRefused) {
    const Scan whole = scan_number(0);
    const Outcome good = outcome(whole);
    const auto vertices = static_cast<std::int32_t>(whole.positions.size());
    for (const std::int32_t wrong :
         {-1, vertices, std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()}) {
        Scan scan = whole;
        scan.faces.back()[1] = wrong;
        EXPECT_THROW((void)decimate(scan), RefusedMesh) << wrong;
        EXPECT_THROW((void)verify(good.base, scan), RefusedMesh) << wrong;
        BaseMesh base = good.base;
        base.faces.back()[1] = wrong;
        EXPECT_THROW((void)verify(base, whole), RefusedMesh) << wrong;
    }
}

TEST(LibraryEdges, CoordinatesThatAreNoNumbersAreRefused) {
    const Scan whole = scan_number(0);
    const Outcome good = outcome(whole);
    for (const double wrong : {no_number, infinite, -infinite}) {
        Scan scan = whole;
        scan.positions.front().y() = wrong;
        EXPECT_THROW((void)decimate(scan), RefusedMesh) << wrong;
        EXPECT_THROW((void)verify(good.base, scan), RefusedMesh) << wrong;
        for (std::vector<Vec3> BaseMesh::*field : {&BaseMesh::positions, &BaseMesh::directions}) {
            BaseMesh base = good.base;
            (base.*field).back().x() = wrong;
            EXPECT_THROW((void)verify(base, whole), RefusedMesh) << wrong;
        }
    }
}

TEST(LibraryEdges, RangesThatAreNoIntervalsAreRefused) {
    const Scan scan = scan_number(0);
    const Outcome good = outcome(scan);
    for (const Range wrong :
         {Range{no_number, 1}, Range{0, no_number}, Range{-infinite, 1}, Range{0, infinite}, Range{1, 0}}) {
        BaseMesh base = good.base;
        base.ranges.back() = wrong;
        EXPECT_THROW((void)verify(base, scan), RefusedMesh) << wrong.lo << " " << wrong.hi;
    }
}

TEST(LibraryEdges, ArraysOfUnequalLengthAreRefused) {
    const Scan scan = scan_number(0);
    const Outcome good = outcome(scan);
    const std::vector<std::function<void(BaseMesh&)>> faults = {
        [](BaseMesh& base) { base.directions.pop_back(); },
        [](BaseMesh& base) { base.directions.clear(); },
        [](BaseMesh& base) { base.directions.emplace_back(0, 0, 1); },
        [](BaseMesh& base) { base.ranges.pop_back(); },
        [](BaseMesh& base) {
            base.ranges.push_back({0, 0});
        },
        [](BaseMesh& base) { base.scan_vertex.pop_back(); },
        [](BaseMesh& base) { base.scan_vertex.push_back(0); },
        [](BaseMesh& base) { base.face_directions.emplace_back(0, 0, 1); },
        [](BaseMesh& base) {
            base.face_directions.assign(base.faces.size(), Vec3(0, 0, 1));
            base.directions.pop_back();
        },
    };
    for (std::size_t i = 0; i < faults.size(); ++i) {
        BaseMesh base = good.base;
        faults[i](base);
        EXPECT_THROW((void)verify(base, scan), RefusedMesh) << "fault " << i;
    }
}

TEST(LibraryEdges, KeptVerticesThatAreNoneAreViolations) {
    const Scan scan = scan_number(1);
    const Outcome good = outcome(scan);
    const auto vertices = static_cast<std::int32_t>(scan.positions.size());
    for (const std::int32_t wrong :
         {-2, vertices, std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()}) {
        BaseMesh base = good.base;
        base.scan_vertex.front() = wrong;
        EXPECT_THAT(verify(base, scan), Has(Violation::kept_vertex)) << wrong;
    }
}

TEST(LibraryEdges, OptionsWithoutSenseAreRefused) {
    const Scan scan = scan_number(0);
    const std::vector<std::function<void(DecimateOptions&)>> faults = {
        [](DecimateOptions& options) { options.threads = 0; },
        [](DecimateOptions& options) { options.threads = -1; },
        [](DecimateOptions& options) { options.time_limit = -1.0; },
        [](DecimateOptions& options) { options.time_limit = no_number; },
        [](DecimateOptions& options) { options.max_displacement = -1.0; },
        [](DecimateOptions& options) { options.max_displacement = no_number; },
    };
    for (std::size_t i = 0; i < faults.size(); ++i) {
        DecimateOptions options;
        faults[i](options);
        EXPECT_THROW((void)decimate(scan, options), std::invalid_argument) << "fault " << i;
    }
    const BaseMesh base = outcome(scan).base;
    const std::vector<std::function<void(VerifyOptions&)>> verify_faults = {
        [](VerifyOptions& options) { options.threads = 0; },
        [](VerifyOptions& options) { options.threads = -1; },
        [](VerifyOptions& options) { options.samples_per_face = -1; },
        [](VerifyOptions& options) { options.rays_per_face = 0; },
    };
    for (std::size_t i = 0; i < verify_faults.size(); ++i) {
        VerifyOptions options;
        verify_faults[i](options);
        EXPECT_THROW((void)verify(base, scan, options), std::invalid_argument) << "fault " << i;
    }
}

TEST(LibraryEdges, OptionsAtTheEndsOfTheirRangesAreObeyed) {
    const Scan scan = scan_number(0);
    const std::vector<std::function<void(DecimateOptions&)>> edges = {
        [](DecimateOptions& options) { options.target_faces = 0; },
        [](DecimateOptions& options) { options.target_faces = std::numeric_limits<std::size_t>::max(); },
        [](DecimateOptions& options) { options.time_limit = 0.0; },
        [](DecimateOptions& options) { options.time_limit = infinite; },
        [](DecimateOptions& options) { options.max_displacement = 0.0; },
        [](DecimateOptions& options) { options.max_displacement = infinite; },
        [](DecimateOptions& options) { options.edge_valence_limit = std::numeric_limits<int>::min(); },
        [](DecimateOptions& options) { options.edge_valence_limit = std::numeric_limits<int>::max(); },
        [](DecimateOptions& options) { options.threads = 1000; },
    };
    for (std::size_t i = 0; i < edges.size(); ++i) {
        DecimateOptions options;
        edges[i](options);
        EXPECT_THAT(verify(decimate(scan, options).base, scan), IsCertified()) << "edge " << i;
    }
}

TEST(LibraryEdges, AScanThatWasMovedFromIsEmpty) {
    Scan scan = scan_number(0);
    const Scan taken = std::move(scan);
    EXPECT_THROW((void)decimate(scan), RefusedMesh); // NOLINT(bugprone-use-after-move): that is asked
    Outcome first = outcome(taken);
    const Outcome moved = std::move(first);
    EXPECT_THAT(verify(moved.base, taken), IsCertified());
}

} // namespace
} // namespace foldless
