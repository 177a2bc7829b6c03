#include "../soak.h"
#include "../verify/random_scans.h"
#include "mapped_scan.h"
#include "passage_oracle.h"

#include <foldless/bake/face_raster.h>
#include <foldless/bake/over_face.h>
#include <foldless/io/bounding_box.h>
#include <foldless/models/make_model.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace foldless {
namespace {

using oracle::PassedFace;
using test::MappedScan;

constexpr std::array<SampleLattice, 3> lattices{{{1, 1}, {3, 7}, {64, 16}}};

/// What a displacement may be off by, in units of the size of the scan.
constexpr double rounding = 1e-9;

template <class Visit>
void for_each_sample(const SampleLattice& lattice, Visit visit) {
    for (int j = 0; j <= lattice.rows; ++j) {
        for (int i = 0; i <= lattice.last_column(j); ++i) {
            visit(i, j);
        }
    }
}

/// A sample of a base face of a scan.
struct Place {
    const BaseTriangle& triangle;
    const Scan& scan;
    SampleLattice lattice;
    int i, j;
};

void expect_at_its_point(const Place& place, const ScanPoint& point) {
    const Vec3 alpha = place.lattice.alpha(place.i, place.j);
    Vec3 displaced = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        displaced += alpha[k] * place.triangle.corner(k, point.t);
    }
    ASSERT_TRUE(point.u >= 0 && point.v >= 0 && point.u + point.v <= 1 + 1e-15);
    const auto& [a, b, c] = place.scan.faces[point.face];
    const Vec3 there = (1 - point.u - point.v) * place.scan.positions[a] + point.u * place.scan.positions[b] +
                       point.v * place.scan.positions[c];
    ASSERT_LE((displaced - there).norm(), rounding * bounding_box_diagonal(place.scan));
}

/// The lowest face that the oracle has at the sample, of those over the base face; nothing where it has none.
void expect_as_the_oracle_says(const Place& place, Range range, std::span<const std::int32_t> over,
                               const FaceSamples& samples) {
    std::vector<PassedFace> passed =
        oracle::passed_faces(place.triangle, place.lattice, place.i, place.j, place.scan, range);
    std::erase_if(passed,
                  [&](const PassedFace& hit) { return !std::binary_search(over.begin(), over.end(), hit.face); });
    const ScanPoint& point = samples.at(place.i, place.j);
    ASSERT_EQ(point.exists(), !passed.empty());
    if (passed.empty()) {
        return;
    }
    ASSERT_EQ(point.face, passed.front().face);
    ASSERT_NEAR(point.t, passed.front().t, rounding * std::max(1.0, std::abs(passed.front().t)));
    ASSERT_NEAR(point.u, passed.front().u, 1e-6); // long and thin faces
    ASSERT_NEAR(point.v, passed.front().v, 1e-6);
    ASSERT_GE(point.t, range.lo);
    ASSERT_LE(point.t, range.hi);
    expect_at_its_point(place, point);
}

struct Count {
    std::size_t samples = 0;
    std::size_t uncovered = 0;
    std::size_t contested = 0;
};

/// All samples of a base face; how many there are, and how many nothing is displaced to.
Count expect_right_face(const MappedScan& mapped, std::int32_t face, const SampleLattice& lattice) {
    const int first = face % 3;
    const BaseTriangle triangle = base_triangle(mapped.base, face, first);
    const FaceSamples samples = samples_of(mapped.base, mapped.scan, mapped.map, {face, first, lattice});
    Count count;
    count.contested = samples.contested;
    for_each_sample(lattice, [&](int i, int j) {
        if (testing::Test::HasFatalFailure()) {
            return;
        }
        SCOPED_TRACE("face " + std::to_string(face) + ", sample " + std::to_string(i) + " " + std::to_string(j));
        const Place place{triangle, mapped.scan, lattice, i, j};
        ++count.samples;
        count.uncovered += samples.at(i, j).exists() ? 0 : 1;
        if (mapped.map.frozen[face]) {
            ASSERT_EQ(samples.at(i, j).face, mapped.map.over(face).front());
            ASSERT_EQ(samples.at(i, j).t, 0.0);
            expect_at_its_point(place, samples.at(i, j));
        } else {
            expect_as_the_oracle_says(place, mapped.map.ranges[face], mapped.map.over(face), samples);
        }
    });
    return count;
}

/// All base faces, of fine lattices some: the oracle takes its time.
Count expect_right(const MappedScan& mapped, const SampleLattice& lattice) {
    const std::int32_t step = lattice.columns < 32 ? 1 : 11;
    Count sum;
    for (std::int32_t face = 0; face < static_cast<std::int32_t>(mapped.base.faces.size()); face += step) {
        const Count count = expect_right_face(mapped, face, lattice);
        sum = {sum.samples + count.samples, sum.uncovered + count.uncovered, sum.contested + count.contested};
        if (testing::Test::HasFatalFailure()) {
            break;
        }
    }
    return sum;
}

void expect_covered_once(const MappedScan& mapped, const SampleLattice& lattice) {
    SCOPED_TRACE(std::to_string(lattice.columns) + " x " + std::to_string(lattice.rows));
    const Count count = expect_right(mapped, lattice);
    EXPECT_GT(count.samples, 0U);
    EXPECT_EQ(count.uncovered, 0U);
    EXPECT_EQ(count.contested, 0U);
}

TEST(FaceRaster, CoversDecimatedModelsOnce) {
    for (const Shape shape : all_shapes) {
        SCOPED_TRACE(std::string(name_of(shape)));
        const std::int64_t faces = std::max<std::int64_t>(600, least_faces(shape));
        const MappedScan mapped = test::decimated_model(shape, faces, 40);
        for (const SampleLattice& lattice : lattices) {
            expect_covered_once(mapped, lattice);
        }
        if (testing::Test::HasFatalFailure()) {
            return;
        }
    }
}

TEST(FaceRaster, CoversRandomScansOnce) {
    for (int seed = 0; seed < soak(5000); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        test::Random random(static_cast<std::uint64_t>(seed));
        const bool is_open = seed % 2 == 1;
        const Scan scan = is_open ? test::random_open_scan(random) : test::random_closed_scan(random);
        const MappedScan mapped = test::decimated(scan, seed % 3 == 0 ? paper_options() : DecimateOptions());
        expect_covered_once(mapped, lattices[1]);
        expect_covered_once(mapped, {1 + test::index(random, 20), 1 + test::index(random, 20)});
        if (testing::Test::HasFatalFailure()) {
            return;
        }
    }
}

TEST(FaceRaster, LeavesOutWhatIsBeyondATrimmedBorder) {
    std::size_t uncovered = 0;
    for (int seed = 0; seed < soak(5000); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        test::Random random(static_cast<std::uint64_t>(seed));
        DecimateOptions options;
        options.boundary = Boundary::trim;
        const MappedScan mapped = test::decimated(test::random_open_scan(random), options);
        const Count count = expect_right(mapped, {5, 9});
        EXPECT_EQ(count.contested, 0U);
        uncovered += count.uncovered;
        if (testing::Test::HasFatalFailure()) {
            return;
        }
    }
    EXPECT_GT(uncovered, 0U);
}

/// The unit square, cut into `cells` by `cells` squares of two faces each, the plane z = height.
Scan grid(int cells, double height) {
    Scan scan;
    for (int j = 0; j <= cells; ++j) {
        for (int i = 0; i <= cells; ++i) {
            scan.positions.emplace_back(static_cast<double>(i) / cells, static_cast<double>(j) / cells, height);
        }
    }
    const auto at = [&](int i, int j) { return j * (cells + 1) + i; };
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            scan.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            scan.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return scan;
}

/// Half of the unit square in the plane z = 0, with directions straight up.
BaseTriangle half_square() {
    const Vec3 up(0, 0, 1);
    return {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {up, up, up}};
}

std::vector<std::int32_t> all_faces(const Scan& scan) {
    std::vector<std::int32_t> faces(scan.faces.size());
    std::iota(faces.begin(), faces.end(), 0);
    return faces;
}

// Every sample of these lattices lies on a vertex of the scan, or on an edge.
TEST(FaceRaster, GivesAnEdgeOrVertexToTheLowestFace) {
    for (const int cells : {1, 3, 8}) {
        const Scan scan = grid(cells, 0.25);
        const std::vector<std::int32_t> over = all_faces(scan);
        for (const SampleLattice& lattice :
             {SampleLattice{cells, cells}, SampleLattice{2 * cells, 2 * cells}, SampleLattice{cells, 5}}) {
            const Range range{-1, 1};
            const BaseTriangle triangle = half_square();
            const FaceSamples samples = rasterise(triangle, range, scan, over, lattice);
            EXPECT_EQ(samples.contested, 0U);
            for_each_sample(lattice, [&](int i, int j) {
                ASSERT_TRUE(samples.at(i, j).exists());
                expect_as_the_oracle_says({triangle, scan, lattice, i, j}, range, over, samples);
            });
        }
    }
}

TEST(FaceRaster, KeepsToTheRange) {
    const Scan scan = grid(2, 0.25);
    const SampleLattice lattice{4, 4};
    const auto is_covered = [&](Range range) {
        const FaceSamples samples = rasterise(half_square(), range, scan, all_faces(scan), lattice);
        bool all = true;
        for_each_sample(lattice, [&](int i, int j) { all = all && samples.at(i, j).exists(); });
        return all;
    };
    EXPECT_TRUE(is_covered({0.25, 0.25}));
    EXPECT_TRUE(is_covered({-1, 0.25}));
    EXPECT_TRUE(is_covered({0.25, 1}));
    EXPECT_FALSE(is_covered({-1, 0.2499}));
    EXPECT_FALSE(is_covered({0.2501, 1}));
}

TEST(FaceRaster, DoesNotSeeWhatIsTurnedAway) {
    Scan scan = grid(2, 0.25);
    for (Triangle& face : scan.faces) {
        std::swap(face[1], face[2]);
    }
    const FaceSamples samples = rasterise(half_square(), {-1, 1}, scan, all_faces(scan), {4, 4});
    for_each_sample(samples.lattice, [&](int i, int j) { EXPECT_FALSE(samples.at(i, j).exists()); });
}

// Two sheets in the range: not what a certified base mesh has.
TEST(FaceRaster, TakesTheLeastDisplacementOfSeveralAndCountsThem) {
    for (const bool nearer_first : {true, false}) {
        Scan scan = grid(2, nearer_first ? -0.25 : 0.5);
        const Scan other = grid(2, nearer_first ? 0.5 : -0.25);
        const auto by = static_cast<std::int32_t>(scan.positions.size());
        scan.positions.insert(scan.positions.end(), other.positions.begin(), other.positions.end());
        for (const auto& [a, b, c] : other.faces) {
            scan.faces.push_back({a + by, b + by, c + by});
        }
        const FaceSamples samples = rasterise(half_square(), {-1, 1}, scan, all_faces(scan), {3, 5});
        std::size_t count = 0;
        for_each_sample(samples.lattice, [&](int i, int j) {
            ++count;
            EXPECT_EQ(samples.at(i, j).t, -0.25);
        });
        EXPECT_GE(samples.contested, count);
    }
}

TEST(FaceRaster, LeavesFrozenFacesWhereTheyAre) {
    for (const Shape shape : {Shape::spike, Shape::cube, Shape::terrain}) {
        const Scan scan = to_scan(make_model({shape, 100, {}}));
        DecimateOptions options;
        options.target_faces = scan.faces.size();
        const MappedScan mapped = test::decimated(scan, options);
        for (std::size_t face = 0; face < mapped.base.faces.size(); ++face) {
            EXPECT_TRUE(mapped.map.frozen[face]);
        }
        expect_covered_once(mapped, lattices[1]);
    }
}

// The image of a corner of the lattice is one of the face, whichever corner comes first.
TEST(FaceRaster, TurnsWithTheFirstCorner) {
    const MappedScan mapped = test::decimated_model(Shape::torus, 400, 60);
    const SampleLattice lattice{6, 6};
    for (std::int32_t face = 0; face < static_cast<std::int32_t>(mapped.base.faces.size()); ++face) {
        const FaceSamples plain = samples_of(mapped.base, mapped.scan, mapped.map, {face, 0, lattice});
        const FaceSamples turned = samples_of(mapped.base, mapped.scan, mapped.map, {face, 1, lattice});
        for_each_sample(lattice, [&](int i, int j) { // (a, i, j) of the plain one is (i, j, a) of the turned one
            const ScanPoint& there = turned.at(j, lattice.rows - i - j);
            EXPECT_EQ(plain.at(i, j).face, there.face);
            EXPECT_NEAR(plain.at(i, j).t, there.t, rounding);
        });
    }
}

} // namespace
} // namespace foldless
