// Random steep directions, where walls curve and prismoids fold: what the validator accepts is checked point by point.

#include "made_scans.h"
#include "validator_world.h"

#include <foldless/io/float32.h>
#include <foldless/predicates/inverse_displacement.h>
#include <foldless/predicates/jacobian.h>

#include <array>
#include <map>
#include <random>

namespace foldless {
namespace {

using test::moved;
using test::World;

class Random {
public:
    explicit Random(unsigned seed) : generator_(seed) {}
    double number(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(generator_); }
    Vec3 vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }

private:
    std::mt19937_64 generator_;
};

/// A square with two tops (see validator_test.cpp), its corners a little out of the plane.
Scan random_tops(Random& random, double height) {
    Scan scan = test::pyramid({random.number(0.1, 0.5), random.number(0.1, 0.9), random.number(-height, height)});
    scan.positions.emplace_back(random.number(0.5, 0.9), random.number(0.1, 0.9), random.number(-height, height));
    for (std::size_t v = 0; v < 4; ++v) {
        scan.positions[v] += random.vector(0.1);
    }
    scan.faces = {{0, 1, 4}, {1, 5, 4}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {3, 0, 4}};
    return scan;
}

/// The new base faces as the validator saw them.
std::vector<BaseTriangle> triangles(World& world, const Patch& patch) {
    std::vector<BaseTriangle> result;
    for (const PatchFace& face : patch.added) {
        BaseTriangle triangle;
        for (int k = 0; k < 3; ++k) {
            triangle.v[k] = world.base().vertex(face.corners[k]).position;
            triangle.d[k] = world.base().vertex(face.corners[k]).direction;
        }
        result.push_back(triangle);
    }
    return result;
}

struct Found {
    int places = 0;
    bool seen = true; ///< N.n > 0 at all of them
};

/// The places of a point inside a scan face that are not within `margin` of a wall or an end of the range.
Found places_of(const Vec3& q, const Vec3& normal, const std::vector<BaseTriangle>& triangles, const Trial& trial) {
    Found found;
    for (std::size_t c = 0; c < triangles.size(); ++c) {
        const Range range = trial.faces[c].range;
        for (const Preimage& preimage : InverseDisplacement(triangles[c]).preimages(q, range)) {
            if (inside(preimage)) {
                ++found.places;
                const auto& d = triangles[c].d;
                const Vec3 direction = preimage.alpha[0] * d[0] + preimage.alpha[1] * d[1] + preimage.alpha[2] * d[2];
                found.seen = found.seen && direction.dot(normal) > 0 && preimage.slope > 0;
            }
        }
    }
    return found;
}

constexpr int cuts = 12; ///< samples lie at the centres of cuts^2 small triangles

/// Calls f with sample points inside the triangle.
template <class F>
void sample(const std::array<Vec3, 3>& q, F f) {
    for (int i = 0; i < cuts; ++i) {
        for (int j = 0; i + j < cuts; ++j) {
            const double u = (i + 0.31) / cuts;
            const double v = (j + 0.33) / cuts;
            f((1 - u - v) * q[0] + u * q[1] + v * q[2]);
        }
    }
}

class ValidatorOnSteepDirections : public testing::TestWithParam<double> {};

TEST_P(ValidatorOnSteepDirections, AcceptsNothingThatFolds) {
    Random random(17);
    std::map<Verdict, int> verdicts;
    int rounds = 0;
    while (rounds < 3000) {
        World world(random_tops(random, 0.5));
        for (const std::int32_t v : {0, 1, 2, 3}) {
            world.base().set_direction(v, to_float32(Vec3(Vec3(0, 0, 1) + random.vector(GetParam()))));
        }
        Patch patch = world.replacing_all({{0, 1, 2}, {0, 2, 3}});
        patch.changed = {moved(4, world.scan().positions[4]), moved(5, world.scan().positions[5])};
        const Verdict verdict = world.judge(patch);
        ++verdicts[verdict];
        ++rounds;
        if (verdict != Verdict::accepted) {
            continue;
        }
        const std::vector<BaseTriangle> base = triangles(world, patch);
        for (std::size_t c = 0; c < base.size(); ++c) {
            EXPECT_EQ(jacobian_on(base[c], world.trial().faces[c].range), Sign::positive);
        }
        for (const Triangle& face : world.scan().faces) {
            const auto& p = world.scan().positions;
            const Vec3 normal = (p[face[1]] - p[face[0]]).cross(p[face[2]] - p[face[0]]);
            sample({p[face[0]], p[face[1]], p[face[2]]}, [&](const Vec3& q) {
                const Found found = places_of(q, normal, base, world.trial());
                EXPECT_EQ(found.places, 1) << "round " << rounds << ", point " << q.transpose();
                EXPECT_TRUE(found.seen) << "round " << rounds << ", point " << q.transpose();
            });
        }
    }
    EXPECT_GT(verdicts[Verdict::accepted], rounds / 50);
    EXPECT_LT(verdicts[Verdict::undecided], rounds / 10);
}

INSTANTIATE_TEST_SUITE_P(Tilts, ValidatorOnSteepDirections, testing::Values(0.0, 0.3, 0.8));

} // namespace
} // namespace foldless
