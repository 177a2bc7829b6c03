// Vertices that are frozen since no direction serves them: exact arithmetic agrees. By Gordan's theorem no direction
// has a positive dot product with all normals exactly if 0 is a convex combination of them, and then of four or fewer.

#include "exact_vector.h"
#include "made_scans.h"

#include <foldless/decimate/scan_topology.h>
#include <foldless/io/read_mesh.h>
#include <foldless/predicates/scan_normal.h>
#include <foldless/predicates/visible_direction.h>

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <random>
#include <vector>

namespace foldless {
namespace {

using namespace test;

using exact::cross;
using exact::dot;
using ExactVector = exact::Vector;

bool is_zero(const ExactVector& a) {
    return a.x == 0 && a.y == 0 && a.z == 0;
}

ExactVector exact_normal(const std::array<Vec3, 3>& corners) {
    const ExactVector first = corners[0];
    return cross(corners[1] - first, corners[2] - first);
}

bool cancel(const ExactVector& a, const ExactVector& b) {
    return is_zero(cross(a, b)) && dot(a, b) < 0;
}

bool cancel(const ExactVector& a, const ExactVector& b, const ExactVector& c) {
    const ExactVector ab = cross(a, b);
    const ExactVector bc = cross(b, c);
    const ExactVector ca = cross(c, a);
    return is_zero(cross(ab, bc)) && is_zero(cross(bc, ca)) && dot(ab, bc) > 0 && dot(bc, ca) > 0;
}

bool cancel(const ExactVector& a, const ExactVector& b, const ExactVector& c, const ExactVector& d) {
    const std::array<int, 4> signs{sgn(dot(cross(b, c), d)), -sgn(dot(cross(a, c), d)), sgn(dot(cross(a, b), d)),
                                   -sgn(dot(cross(a, b), c))};
    return signs[0] != 0 && signs[0] == signs[1] && signs[1] == signs[2] && signs[2] == signs[3];
}

/// Whether certainly no direction sees all.
bool is_hopeless(const std::vector<ExactVector>& normals) {
    for (auto a = normals.begin(); a != normals.end(); ++a) {
        for (auto b = a + 1; b != normals.end(); ++b) {
            if (cancel(*a, *b)) {
                return true;
            }
            for (auto c = b + 1; c != normals.end(); ++c) {
                if (cancel(*a, *b, *c)) {
                    return true;
                }
                for (auto d = c + 1; d != normals.end(); ++d) {
                    if (cancel(*a, *b, *c, *d)) {
                        return true;
                    }
                }
            }
        }
    }
    return false;
}

/// How many vertices of the scan no direction serves; each of them must be hopeless exactly.
int count_unserved(const Scan& scan) {
    const ScanTopology topology(scan);
    int unserved = 0;
    for (std::size_t v = 0; v < scan.positions.size(); ++v) {
        std::vector<Vec3> normals;
        std::vector<ExactVector> exact;
        for (const std::int32_t f : topology.faces_around(static_cast<std::int32_t>(v))) {
            const Triangle& face = scan.faces[f];
            const std::array<Vec3, 3> corners{scan.positions[face[0]], scan.positions[face[1]],
                                              scan.positions[face[2]]};
            normals.push_back(ScanNormal(corners).normalised().value());
            exact.push_back(exact_normal(corners));
        }
        if (!normals.empty() && !most_visible_direction(normals)) {
            ++unserved;
            EXPECT_TRUE(is_hopeless(exact)) << "vertex " << v;
        }
    }
    return unserved;
}

TEST(UnservedVertices, AreHopelessOnSkewCubes) {
    EXPECT_EQ(count_unserved(skew_cubes(4)), 1);
}

// Fans around one vertex on a coarse grid: many normals cancel exactly, or nearly.
TEST(UnservedVertices, AreHopelessOnFansOverGrids) {
    std::mt19937_64 generator(1);
    std::uniform_int_distribution<int> coordinate(-2, 2);
    int unserved = 0;
    for (int round = 0; round < 2000; ++round) {
        std::vector<Vec3> normals;
        std::vector<ExactVector> exact;
        Vec3 first = Vec3::Zero();
        for (int i = 0; i < 4 + round % 5; ++i) {
            const Vec3 second(coordinate(generator), coordinate(generator), coordinate(generator));
            const std::array<Vec3, 3> corners{Vec3(Vec3::Zero()), first, second};
            if (first.cross(second).squaredNorm() > 0) {
                normals.push_back(ScanNormal(corners).normalised().value());
                exact.push_back(exact_normal(corners));
            }
            first = second;
        }
        if (!normals.empty() && !most_visible_direction(normals)) {
            ++unserved;
            EXPECT_TRUE(is_hopeless(exact)) << "round " << round;
        }
    }
    EXPECT_GT(unserved, 200);
}

TEST(UnservedVertices, AreHopelessOnARealScan) {
    const std::filesystem::path path = std::filesystem::path(FOLDLESS_SCANS) / "man_35k.ply";
    if (!std::filesystem::exists(path)) {
        GTEST_SKIP() << path << " is absent";
    }
    EXPECT_GT(count_unserved(read_scan(path).scan), 0);
}

} // namespace
} // namespace foldless
