#include <foldless/report/header_comments.h>

#include <foldless/report/version.h>

#include <gmock/gmock.h>

namespace foldless {

namespace {

using testing::Contains;
using testing::ElementsAre;

TEST(HeaderComments, NameVersionPresetAndOptionsThatChangeTheResult) {
    DecimateOptions options;
    options.target_faces = 1000;
    options.max_displacement = 0.1;
    EXPECT_THAT(header_comments(Preset::standard, options),
                ElementsAre("foldless " + std::string(version()), "preset default", "directions visible",
                            "store-directions yes", "placement best", "boundary lock", "faces 1000",
                            "max-displacement 0.1"));
}

TEST(HeaderComments, DoNotDependOnThreadsOrTime) {
    DecimateOptions options;
    const auto plain = header_comments(Preset::standard, options);
    options.threads = 7;
    options.time_limit = 3.0;
    EXPECT_EQ(header_comments(Preset::standard, options), plain);
}

TEST(HeaderComments, NameThePresetOfThePaper) {
    EXPECT_THAT(header_comments(Preset::paper, {}), Contains("preset paper"));
}

} // namespace

} // namespace foldless
