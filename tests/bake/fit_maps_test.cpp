#include "mapped_scan.h"

#include <foldless/bake/atlas.h>
#include <foldless/bake/fit_maps.h>
#include <foldless/io/bounding_box.h>

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <vector>

namespace foldless {
namespace {

class FitMaps : public testing::Test {
protected:
    /// \param share of the diagonal
    [[nodiscard]] FitOptions within(double share) const {
        FitOptions options;
        options.max_error = share * diagonal_;
        options.bound = 1e-4 * diagonal_;
        options.largest = 1024;
        options.threads = 1;
        return options;
    }
    [[nodiscard]] MapFit fit(const FitOptions& options) const {
        return fit_maps(mapped_.base, surface_, mapped_.map, options);
    }

    const test::MappedScan mapped_ = test::decimated_model(Shape::bumpy_sphere, 3000, 150);
    const std::vector<Eigen::Vector3f> no_colours_{};
    const ScanSurface surface_{mapped_.scan, no_colours_};
    const double diagonal_ = bounding_box_diagonal(mapped_.scan);
};

TEST_F(FitMaps, GrowWithWhatIsAskedFor) {
    const MapFit coarse = fit(within(0.02));
    const MapFit fine = fit(within(0.002));
    EXPECT_TRUE(coarse.fits);
    EXPECT_TRUE(fine.fits);
    EXPECT_EQ(coarse.size, FitOptions::smallest);
    EXPECT_LE(coarse.distance.maximum_bound(), 0.02 * diagonal_);
    EXPECT_LE(fine.distance.maximum_bound(), 0.002 * diagonal_);
    EXPECT_LT(coarse.level, fine.level);
    EXPECT_LE(coarse.size, fine.size);
}

TEST_F(FitMaps, AreTheLargestIfNoneFits) {
    FitOptions options = within(0.0);
    options.largest = 300;
    const MapFit found = fit(options);
    EXPECT_FALSE(found.fits);
    EXPECT_EQ(found.size, 300);
    EXPECT_GT(found.distance.maximum(), 0.0);
}

TEST_F(FitMaps, AreTheBaseMeshItselfIfAnythingWillDo) {
    const MapFit found = fit(within(10.0));
    EXPECT_TRUE(found.fits);
    EXPECT_EQ(found.size, FitOptions::smallest);
    EXPECT_EQ(found.level, 0);
}

TEST_F(FitMaps, StopWhenAsked) {
    FitOptions options = within(0.0);
    options.progress = [](double share) { return share == 0.0; };
    const MapFit found = fit(options);
    EXPECT_TRUE(found.cancelled);
    EXPECT_FALSE(found.fits);
    EXPECT_EQ(found.size, FitOptions::smallest);
}

TEST_F(FitMaps, RefuseSenselessOptions) {
    EXPECT_THROW((void)fit(within(-1.0)), std::invalid_argument);
    EXPECT_THROW((void)fit(within(std::numeric_limits<double>::quiet_NaN())), std::invalid_argument);
    FitOptions options = within(0.1);
    options.largest = 0;
    EXPECT_THROW((void)fit(options), std::invalid_argument);
    options.largest = 3;
    EXPECT_THROW((void)fit(options), AtlasTooSmall);
}

} // namespace
} // namespace foldless
