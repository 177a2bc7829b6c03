#include "../soak.h"
#include "random_triangles.h"

#include <foldless/bake/edge_rows.h>
#include <foldless/bake/image_box.h>
#include <foldless/bake/piercing.h>
#include <foldless/bake/sample_lattice.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace foldless {
namespace {

struct Case {
    BaseTriangle triangle;
    Range range;
    ScanTriangle scan;
};

BaseTriangle random_triangle(RandomTriangles& random, int kind) {
    switch (kind) {
    case 0: return random.tame();
    case 1: return random.wild();
    default: { // far from the origin, directions of very different lengths
        BaseTriangle triangle = random.tame();
        const Vec3 away = random.vector(100);
        for (int k = 0; k < 3; ++k) {
            triangle.v[k] += away;
            triangle.d[k] *= std::exp2(random.number(-6, 6));
        }
        return triangle;
    }
    }
}

/// A scan triangle near a point that is displaced within the range, of any size; every tenth is long and thin.
Case random_case(RandomTriangles& random, int round) {
    Case c{random_triangle(random, round % 3), {}, {}};
    const double middle = random.number(-1, 1);
    const double half = std::exp2(random.number(-20, 3));
    c.range = {middle - half, middle + half};
    const double size = std::exp2(random.number(-8, 1));
    const Vec3 there = displaced(c.triangle, random.barycentric(), random.number(c.range.lo, c.range.hi));
    for (Vec3& corner : c.scan) {
        corner = there + random.vector(size);
    }
    if (round % 10 == 0) {
        c.scan[2] = c.scan[0] + random.number(0, 1) * (c.scan[1] - c.scan[0]) + random.vector(1e-6 * size);
    }
    return c;
}

/// Samples that the scan triangle is pierced at, in the range; the box and the rows must hold every one.
int expect_all_within(const Case& c, const SampleLattice& lattice) {
    const std::optional<AlphaBox> box = image_box(c.triangle, c.range, c.scan);
    const EdgeRows rows(c.triangle, c.scan);
    int count = 0;
    for (int j = 0; j <= lattice.rows; ++j) {
        const double alpha2 = static_cast<double>(j) / lattice.rows;
        const Span row = rows.narrowed({0.0, 1.0 - alpha2}, alpha2);
        for (int i = 0; i <= lattice.last_column(j); ++i) {
            const std::optional<Piercing> pierced = piercing({c.triangle, lattice.weights(i, j)}, c.scan);
            if (!pierced) {
                continue;
            }
            const double alpha1 = static_cast<double>(i) / lattice.columns;
            EXPECT_LE(row.lo, alpha1 + 1e-12) << i << " " << j;
            EXPECT_GE(row.hi, alpha1 - 1e-12) << i << " " << j;
            if (pierced->t < c.range.lo || pierced->t > c.range.hi) {
                continue;
            }
            ++count;
            EXPECT_TRUE(box.has_value()) << i << " " << j;
            const Vec3 alpha = lattice.alpha(i, j);
            for (int k = 0; k < 3 && box; ++k) {
                EXPECT_GE(alpha[k], box->lo[k]) << i << " " << j;
                EXPECT_LE(alpha[k], box->hi[k]) << i << " " << j;
            }
        }
    }
    return count;
}

TEST(ImageBox, HoldsWhatIsPierced) {
    RandomTriangles random(1);
    int pierced = 0;
    for (int round = 0; round < soak(300000); ++round) {
        SCOPED_TRACE("round " + std::to_string(round));
        pierced += expect_all_within(random_case(random, round), {1 + round % 17, 16});
        if (testing::Test::HasFailure()) {
            return;
        }
    }
    EXPECT_GT(pierced, soak(300000) / 5);
}

// Scan triangles with a corner in the place of a corner of the slice, and edges along its edges: all bounds are ties.
TEST(ImageBox, HoldsWhatIsOnItsBorder) {
    RandomTriangles random(2);
    int pierced = 0;
    for (int round = 0; round < soak(100000); ++round) {
        SCOPED_TRACE("round " + std::to_string(round));
        Case c{round % 2 == 0 ? random.tame() : random.wild(), {}, {}};
        const double t = random.number(-0.5, 0.5);
        const double wide = round % 3 == 0 ? 0.0 : std::exp2(random.number(-30, 0));
        c.range = round % 4 < 2 ? Range{t - wide, t} : Range{t, t + wide};
        for (int k = 0; k < 3; ++k) {
            c.scan[k] = c.triangle.corner(k, t);
        }
        if (round % 5 == 0) {
            c.scan[2] = displaced(c.triangle, random.barycentric(), t);
        }
        pierced += expect_all_within(c, {8, 8});
        if (testing::Test::HasFailure()) {
            return;
        }
    }
    EXPECT_GT(pierced, soak(100000));
}

/// The half of the unit square, directions straight up.
BaseTriangle half_square() {
    const Vec3 up(0, 0, 1);
    return {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {up, up, up}};
}

TEST(ImageBox, IsNarrow) {
    const std::optional<AlphaBox> box =
        image_box(half_square(), {-1, 1}, {Vec3(0.25, 0.125, 0.5), Vec3(0.5, 0.125, 0.25), Vec3(0.25, 0.25, 0)});
    ASSERT_TRUE(box.has_value());
    constexpr double margin = 1e-5;
    EXPECT_NEAR(box->lo[1], 0.25, margin);
    EXPECT_NEAR(box->hi[1], 0.5, margin);
    EXPECT_NEAR(box->lo[2], 0.125, margin);
    EXPECT_NEAR(box->hi[2], 0.25, margin);
}

TEST(ImageBox, IsNothingWhereNothingIsDisplacedTo) {
    const ScanTriangle above{Vec3(0, 0, 2), Vec3(1, 0, 2), Vec3(0, 1, 2)};
    EXPECT_FALSE(image_box(half_square(), {-1, 1}, above).has_value());
    EXPECT_TRUE(image_box(half_square(), {-1, 2}, above).has_value());
    const ScanTriangle beside{Vec3(2, 0, 0), Vec3(3, 0, 0), Vec3(2, 1, 0)};
    EXPECT_FALSE(image_box(half_square(), {-1, 1}, beside).has_value());
}

TEST(EdgeRows, AreAsWideAsTheImage) {
    const EdgeRows rows(half_square(), {Vec3(0.25, 0.125, 0.5), Vec3(0.75, 0.125, 0.25), Vec3(0.25, 0.25, 0)});
    const Span span = rows.narrowed({0.0, 1.0 - 0.1875}, 0.1875);
    EXPECT_NEAR(span.lo, 0.25, 1e-9);
    EXPECT_NEAR(span.hi, 0.5, 1e-9);
    EXPECT_TRUE(rows.narrowed({0.0, 0.5}, 0.5).empty());
    EXPECT_TRUE(rows.narrowed({0.0, 1.0}, 0.0).empty());
}

} // namespace
} // namespace foldless
