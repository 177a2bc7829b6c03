// Properties of decimate() and verify() together, on random small scans under all options.

#include "../soak.h"
#include "random_scans.h"
#include "surface_oracle.h"
#include "violations.h"

#include <foldless/decimate/decimate.h>
#include <foldless/io/bounding_box.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

namespace foldless {
namespace {

using namespace test;
using oracle::Judgement;

constexpr int scans = 10000;

VerifyResult verified(const BaseMesh& base, const Scan& scan) {
    VerifyOptions options;
    options.threads = 1;
    return verify(base, scan, options);
}

/// Options of all kinds, `--directions face` excepted: it is certified at the level "vertices" only.
DecimateOptions random_options(Random& random, const Scan& scan) {
    DecimateOptions options;
    if (index(random, 5) == 0) {
        options = paper_options();
    } else {
        const Directions all[] = {Directions::visible, Directions::area, Directions::angle};
        options.directions = all[index(random, 3)];
        options.store_directions = index(random, 3) > 0;
        const Placement placements[] = {Placement::best, Placement::endpoint, Placement::midpoint, Placement::quadric};
        options.placement = placements[index(random, 4)];
        options.unique_among_fold_free = index(random, 4) == 0;
    }
    options.boundary = index(random, 4) == 0 ? Boundary::trim : Boundary::lock;
    if (index(random, 2) == 0) {
        options.target_faces = 4 + index(random, scan.faces.size());
    }
    if (index(random, 4) == 0) {
        options.max_displacement = uniform(random, 0.01, 0.2) * bounding_box_diagonal(scan);
    }
    options.threads = 1;
    return options;
}

/// A scan and options from one seed.
struct Case {
    explicit Case(int seed) : random(static_cast<std::uint64_t>(seed)) {
        is_open = index(random, 2) == 0;
        scan = is_open ? random_open_scan(random) : random_closed_scan(random);
        options = random_options(random, scan);
    }

    Random random;
    bool is_open = false;
    Scan scan;
    DecimateOptions options;
};

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same_base(const BaseMesh& a, const BaseMesh& b) {
    return same_bytes(a.positions, b.positions) && same_bytes(a.directions, b.directions) &&
           same_bytes(a.scan_vertex, b.scan_vertex) && same_bytes(a.faces, b.faces) && same_bytes(a.ranges, b.ranges);
}

BaseMesh mirrored(BaseMesh base) {
    for (std::size_t v = 0; v < base.positions.size(); ++v) {
        base.positions[v].x() = -base.positions[v].x();
        base.directions[v].x() = -base.directions[v].x();
    }
    for (Triangle& face : base.faces) {
        std::swap(face[1], face[2]);
    }
    return base;
}

/// Directions have no unit of length, so the ranges grow with the positions.
BaseMesh scaled(BaseMesh base, double factor) {
    for (Vec3& p : base.positions) {
        p *= factor;
    }
    for (Range& range : base.ranges) {
        range = {factor * range.lo, factor * range.hi};
    }
    return base;
}

/// The base mesh for the renumbered scan, in which every kept vertex is found by its position.
BaseMesh with_kept(BaseMesh base, const Scan& scan) {
    for (std::size_t b = 0; b < base.positions.size(); ++b) {
        if (base.scan_vertex[b] >= 0) {
            const auto found = std::find(scan.positions.begin(), scan.positions.end(), base.positions[b]);
            base.scan_vertex[b] = static_cast<std::int32_t>(found - scan.positions.begin());
        }
    }
    return base;
}

void expect_same_verdict(const VerifyResult& a, const VerifyResult& b, const std::string& what) {
    EXPECT_EQ(a.violations, b.violations) << what;
    EXPECT_EQ(a.level, b.level) << what;
    EXPECT_EQ(a.frozen_faces, b.frozen_faces) << what;
    EXPECT_EQ(a.ambiguous_vertices, b.ambiguous_vertices) << what;
}

TEST(DecimatedScans, AreCertified) {
    for (int seed = 0; seed < soak(scans); ++seed) {
        const Case c(seed);
        const BaseMesh base = decimate(c.scan, c.options).base;
        const VerifyResult result = verified(base, c.scan);
        EXPECT_THAT(result, IsCertified()) << "seed " << seed;
        EXPECT_EQ(result.level, Level::surface) << "seed " << seed;
    }
}

// Each state on the way is what the same run gives that stops there.
TEST(DecimatedScans, AreCertifiedInEveryStateOnTheWay) {
    for (int seed = 0; seed < soak(scans); ++seed) {
        Case c(seed);
        const std::size_t last = decimate(c.scan, c.options).base.faces.size();
        for (std::size_t faces = c.scan.faces.size(); faces > last;) {
            c.options.target_faces = faces - 1;
            const BaseMesh base = decimate(c.scan, c.options).base;
            ASSERT_THAT(verified(base, c.scan), IsCertified()) << "seed " << seed << ", " << base.faces.size();
            faces = base.faces.size();
        }
    }
}

/// A height field on a grid, of steps as built things have: scan vertices and edges lie exactly on walls and pillars.
Scan stepped_scan(Random& random) {
    const int side = 4 + index(random, 7);
    Scan scan;
    const auto at = [&](int i, int j) { return static_cast<std::int32_t>(i * (side + 1) + j); };
    const int wide = 1 + index(random, 3);
    std::vector<double> heights;
    for (int n = 0; n < 64; ++n) {
        heights.push_back(0.125 * index(random, 3));
    }
    for (int i = 0; i <= side; ++i) {
        for (int j = 0; j <= side; ++j) {
            scan.positions.emplace_back(0.25 * i, 0.25 * j, heights[(i / wide * 7 + j / wide) % 64]);
        }
    }
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j) {
            scan.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            scan.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return scan;
}

TEST(DecimatedScans, OfStepsAreCertified) {
    for (int seed = 0; seed < soak(scans); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Scan scan = stepped_scan(random);
        const DecimateOptions options = random_options(random, scan);
        EXPECT_THAT(verified(decimate(scan, options).base, scan), IsCertified()) << "seed " << seed;
    }
}

// The oracle takes its time: a tenth of the scans. It knows no trimmed borders.
TEST(DecimatedScans, AreRepresentedAsTheOracleSays) {
    int ties = 0;
    const int count = soak(scans);
    for (int seed = 0; seed < count; ++seed) {
        const Case c(seed);
        const BaseMesh base = decimate(c.scan, c.options).base;
        if (!c.is_open || c.options.boundary == Boundary::lock) {
            const Judgement truth = oracle::judge(base, c.scan);
            EXPECT_NE(truth.kind, Judgement::Kind::refused) << "seed " << seed << ": " << truth.reason;
            ties += truth.kind == Judgement::Kind::tie ? 1 : 0;
        }
    }
    EXPECT_LE(ties, 1 + count / 10);
}

// docs/algorithm.md: the result does not depend on how the scan is numbered unless two vertices have one position.
TEST(DecimatedScans, DoNotDependOnTheNumberingOfTheScan) {
    for (int seed = 0; seed < soak(scans); ++seed) {
        Case c(seed);
        const DecimateResult first = decimate(c.scan, c.options);
        const Scan other = reordered(renumbered(c.scan, c.random), c.random);
        const DecimateResult second = decimate(other, c.options);
        EXPECT_EQ(second.base.faces.size(), first.base.faces.size()) << "seed " << seed;
        EXPECT_EQ(second.statistics.attempted, first.statistics.attempted) << "seed " << seed;
        EXPECT_THAT(verified(second.base, other), IsCertified()) << "seed " << seed;
    }
}

// The rays from a ten-thousandth of this base mesh pass another sheet within the range, from behind: it belongs to
// faces further away, and nothing is covered twice.
TEST(DecimatedScans, MayPassOverTheirBorderElsewhere) {
    const Case c(4429);
    EXPECT_THAT(verified(decimate(c.scan, c.options).base, c.scan), IsCertified());
}

// Every decision is a sign of a polynomial in the coordinates: a power of two changes none.
TEST(DecimatedScans, AreTheSameAtAnyPowerOfTwo) {
    for (int seed = 0; seed < soak(scans); ++seed) {
        Case c(seed);
        const DecimateResult first = decimate(c.scan, c.options);
        const double factor = seed % 2 == 0 ? 0x1p-12 : 0x1p9;
        if (c.options.max_displacement) {
            c.options.max_displacement = factor * *c.options.max_displacement;
        }
        const Scan other = test::scaled(c.scan, factor);
        const DecimateResult second = decimate(other, c.options);
        EXPECT_TRUE(same_base(second.base, scaled(first.base, factor))) << "seed " << seed;
        expect_same_verdict(verified(second.base, other), verified(first.base, c.scan), "seed " + std::to_string(seed));
    }
}

TEST(DecimatedScans, MayBeMirrored) {
    for (int seed = 0; seed < soak(scans); ++seed) {
        const Case c(seed);
        const Scan other = test::mirrored(c.scan);
        EXPECT_THAT(verified(decimate(other, c.options).base, other), IsCertified()) << "seed " << seed;
    }
}

/// A base mesh that may be wrong: a vertex of a decimated scan moved by up to a twentieth of its size.
BaseMesh with_a_fault(const Case& c, Random& random) {
    BaseMesh base = decimate(c.scan, c.options).base;
    const int v = index(random, base.positions.size());
    const double x = uniform(random, -1, 1);
    const double y = uniform(random, -1, 1);
    base.positions[v] += 0.05 * bounding_box_diagonal(c.scan) * Vec3(x, y, uniform(random, -1, 1));
    base.scan_vertex[v] = -1;
    return base;
}

TEST(Verdicts, AreThoseOfTheSamePairNumberedMirroredOrScaled) {
    for (int seed = 0; seed < soak(scans); ++seed) {
        Case c(seed);
        const bool is_right = index(c.random, 2) == 0;
        const BaseMesh base = is_right ? decimate(c.scan, c.options).base : with_a_fault(c, c.random);
        const VerifyResult first = verified(base, c.scan);
        const Scan other = reordered(renumbered(c.scan, c.random), c.random);
        const std::string what = "seed " + std::to_string(seed);
        if (first.level == Level::surface) { // else rays are part of the verdict, and others for another numbering
            // What else is wrong around a vertex that is wrong may depend on where the verifier begins.
            const VerifyResult numbered = verified(with_kept(base, other), other);
            const VerifyResult turned = verified(mirrored(base), test::mirrored(c.scan));
            EXPECT_EQ(numbered.certified(), first.certified()) << what << " renumbered";
            EXPECT_EQ(turned.certified(), first.certified()) << what << " mirrored";
        }
        expect_same_verdict(verified(scaled(base, 0x1p-30), test::scaled(c.scan, 0x1p-30)), first, what + " scaled");
    }
}

} // namespace
} // namespace foldless
