#include "made_scans.h"
#include "validator_world.h"

#include <foldless/decimate/placement.h>

#include <gmock/gmock.h>

namespace foldless {
namespace {

using test::World;

/// The candidates for the collapse of an edge of a bumpy sphere.
class CandidatesOnASphere : public testing::Test {
protected:
    std::vector<Candidate> ask(Placement placement, bool keep_direction, double good_enough, bool fixed = false) {
        const Collapse collapse = world_.collapse(0, neighbour_);
        Quadric quadric = quadrics_[0];
        quadric += quadrics_[neighbour_];
        std::vector<Candidate> found;
        candidates({&world_.base(), collapse, quadric, Vec3::Zero(), fixed, false, keep_direction, good_enough},
                   placement, found);
        return found;
    }

    World world_{test::bumpy_sphere(2)};
    VertexQuadrics quadrics_{world_.scan(), world_.topology(), Vec3::Zero()};
    std::int32_t neighbour_ =
        world_.base()
            .connectivity()
            .to_vertex_handle(world_.base().connectivity().halfedge_handle(OpenMesh::VertexHandle(0)))
            .idx();
};

bool least_error_first(const std::vector<Candidate>& list) {
    return std::is_sorted(list.begin(), list.end(),
                          [](const Candidate& a, const Candidate& b) { return a.error < b.error; });
}

TEST_F(CandidatesOnASphere, GoByTheirError) {
    const std::vector<Candidate> best = ask(Placement::best, false, 0);
    EXPECT_GE(best.size(), 3);
    EXPECT_TRUE(least_error_first(best));
    EXPECT_TRUE(least_error_first(ask(Placement::best, true, 0)));
    EXPECT_EQ(ask(Placement::endpoint, false, 0).size(), 2);
    EXPECT_EQ(ask(Placement::midpoint, true, 1).size(), 1);
    EXPECT_EQ(ask(Placement::quadric, true, 1).size(), 1);
}

TEST_F(CandidatesOnASphere, EndsThatKeepTheirDirectionGoFirstWhereTheyAreGoodEnough) {
    const std::vector<Candidate> list = ask(Placement::best, true, 1e6);
    ASSERT_GE(list.size(), 5);
    EXPECT_TRUE(list[0].keeps_direction && list[1].keeps_direction);
    EXPECT_THAT((std::vector{list[0].at, list[1].at}), testing::UnorderedElementsAre(0, neighbour_));
    EXPECT_LE(list[0].error, list[1].error);
    for (std::size_t n = 2; n < list.size(); ++n) {
        EXPECT_FALSE(list[n].keeps_direction);
    }
    EXPECT_TRUE(least_error_first({list.begin() + 2, list.end()}));
}

TEST_F(CandidatesOnASphere, AFixedVertexHasOnlyItsPlace) {
    const std::vector<Candidate> list = ask(Placement::best, true, 0, true);
    ASSERT_EQ(list.size(), 2);
    EXPECT_TRUE(list[0].at == neighbour_ && list[1].at == neighbour_);
    EXPECT_TRUE(list[0].keeps_direction && !list[1].keeps_direction);
}

} // namespace
} // namespace foldless
