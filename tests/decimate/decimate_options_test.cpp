// Every combination of the options that shape the result, on a closed and an open scan.

#include "deep_check.h"
#include "made_scans.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>

namespace foldless {
namespace {

using Combination = std::tuple<Directions, bool, Placement, bool>;

class DecimateWithOptions : public testing::TestWithParam<Combination> {
protected:
    static DecimateOptions options() {
        const auto& [directions, store, placement, unique] = GetParam();
        DecimateOptions options;
        options.directions = directions;
        options.store_directions = store;
        options.placement = placement;
        options.unique_among_fold_free = unique;
        return options;
    }

    static void check(const Scan& scan) {
        const DecimateResult result = decimate(scan, options());
        test::deep_check(scan, options(), result);
        // Each face along its own normal serves hardly any curved scan.
        EXPECT_TRUE(result.statistics.accepted > 0 || options().directions == Directions::face);
        EXPECT_EQ(result.stop_reason, StopReason::every_edge_refused);
    }
};

TEST_P(DecimateWithOptions, RepresentsAClosedScan) {
    check(test::bumpy_sphere(3));
}

TEST_P(DecimateWithOptions, RepresentsAnOpenScan) {
    check(test::terrain(10, 0.15));
}

std::string words(const testing::TestParamInfo<Combination>& info) {
    const auto& [directions, store, placement, unique] = info.param;
    const char* const of_directions[] = {"Visible", "Area", "Angle", "Face"};
    const char* const of_placement[] = {"Best", "Endpoint", "Midpoint", "Quadric"};
    return std::string(of_directions[static_cast<int>(directions)]) + (store ? "Stored" : "Recomputed") +
           of_placement[static_cast<int>(placement)] + (unique ? "FoldFree" : "InRange");
}

INSTANTIATE_TEST_SUITE_P(
    All, DecimateWithOptions,
    testing::Combine(testing::Values(Directions::visible, Directions::area, Directions::angle, Directions::face),
                     testing::Bool(),
                     testing::Values(Placement::best, Placement::endpoint, Placement::midpoint, Placement::quadric),
                     testing::Bool()),
    words);

TEST(PaperOptions, AreThoseOfTheirPreset) {
    const DecimateOptions options = paper_options();
    EXPECT_EQ(options.directions, Directions::area);
    EXPECT_FALSE(options.store_directions);
    EXPECT_EQ(options.placement, Placement::midpoint);
    EXPECT_TRUE(options.unique_among_fold_free);
    EXPECT_TRUE(options.orientation_test);
    EXPECT_EQ(options.edge_valence_limit, 12);
    const Scan scan = test::bumpy_sphere(3);
    const DecimateResult result = decimate(scan, options);
    test::deep_check(scan, options, result);
    EXPECT_LT(result.base.faces.size(), scan.faces.size() / 4);
}

// A scan that is flat over large parts, which can be represented along the normals of faces.
TEST(FaceDirections, RepresentAScanOfFlatParts) {
    DecimateOptions options;
    options.directions = Directions::face;
    const Scan scan = test::skew_cubes(3);
    const DecimateResult result = decimate(scan, options);
    test::deep_check(scan, options, result);
    EXPECT_GT(result.statistics.accepted, 0);
}

} // namespace
} // namespace foldless
