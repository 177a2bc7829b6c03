#include <foldless/report/summary.h>

#include "records.h"

#include <gmock/gmock.h>

namespace foldless {

namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(NotesText, IsEmptyIfThereIsNothingToSay) {
    EXPECT_EQ(notes_text({}), "");
}

TEST(NotesText, SaysInOneLineWhatWasIgnoredFannedAndMerged) {
    EXPECT_EQ(notes_text({2, {"colours", "materials"}, 1}),
              "ignored colours, materials; fanned 2 polygons; merged 1 corner at equal positions");
}

TEST(ViolationsText, CountsByName) {
    EXPECT_EQ(violations_text(violated_result()), "5 no_preimage, 2 orientation");
    EXPECT_EQ(violations_text(clean_result()), "");
}

TEST(LocatedLines, NameTheIndicesThatApply) {
    EXPECT_THAT(located_lines(violated_result()),
                ElementsAre("no_preimage, scan vertex 7, base face 9, at (0.5, -1.5, 2)"));
}

TEST(CertificateText, TellsTheLevelAndWhatIsReportedBesides) {
    EXPECT_EQ(certificate_text(clean_result()),
              "level vertices, 3 ambiguous vertices, 25 % of the base mesh uncovered");
}

TEST(CertificateText, SaysThatRangesWereComputed) {
    VerifyResult result = clean_result();
    result.ranges_computed = true;
    EXPECT_THAT(certificate_text(result), HasSubstr("ranges computed"));
}

TEST(SimplifySummary, TellsWhatBecameOfTheScan) {
    const Lines lines = summary(simplify_record());
    EXPECT_THAT(lines, Contains("in put.ply: 102 vertices, 200 faces, 2 components, Euler characteristic -5, "
                                "3 boundary loops with 40 edges, 1 unused vertex"));
    EXPECT_THAT(lines, Contains("out.ply: 31 vertices, 50 faces, 75.00 % fewer faces, 12 frozen"));
    EXPECT_THAT(lines, Contains(HasSubstr("every edge is refused; 75 of 90 asked edges collapsed; refused placements: "
                                          "44 flip, 11 jacobian")));
    EXPECT_THAT(lines, Contains(HasSubstr("6 scan vertices that no direction serves")));
    EXPECT_THAT(lines, Contains("displacements -0.5 to 0.75, at most 1 % of the diagonal"));
    EXPECT_THAT(lines, Contains(HasSubstr("certified: level vertices")));
    EXPECT_THAT(lines, Contains("17.5 s (read 1.5, setup 2.5, decimate 3.5, verify 4.5, write 5.5), 64 MB"));
}

TEST(SimplifySummary, SaysThatNothingWasVerified) {
    SimplifyRecord record = simplify_record();
    record.certificate.reset();
    EXPECT_THAT(summary(record), Contains("not verified"));
    EXPECT_THAT(summary(record), Not(Contains(HasSubstr("certified"))));
}

TEST(InfoSummary, SaysWhatSimplifyWouldSay) {
    InfoRecord record = info_record();
    EXPECT_THAT(summary(record), Contains("simplify accepts this mesh"));
    record.refusal = "3 zero-area faces";
    EXPECT_THAT(summary(record), Contains("simplify refuses this mesh: 3 zero-area faces"));
}

TEST(InfoSummary, SaysWhichRepairWouldMakeItAcceptable) {
    InfoRecord record = info_record();
    EXPECT_THAT(summary(record), Not(Contains(HasSubstr("repair"))));
    record.refusal = "3 zero-area faces";
    EXPECT_EQ(summary(record).back(), "foldless repair would refuse this mesh, too");
    record.repair = RepairOutlook{9, 8, {}};
    record.repair->counts.zero_area_faces = 3;
    EXPECT_EQ(summary(record).back(),
              "foldless repair would make it acceptable: 3 zero-area faces dropped; 9 vertices, 8 faces left");
}

TEST(RepairSummary, CountsDefectsRepairsAndWhatIsLeft) {
    RepairRecord record = repair_record();
    record.counts = {};
    record.counts.zero_area_faces = 22;
    EXPECT_THAT(summary(record),
                ElementsAre("in put.ply: 102 vertices, 200 faces, 22 zero-area faces", "22 zero-area faces dropped",
                            "out.ply: 101 vertices, 190 faces, 2 components, Euler characteristic -5, 3 boundary loops "
                            "with 40 edges, 1 unused vertex"));
    record.counts = {};
    record.defects = {};
    EXPECT_THAT(summary(record), Contains("nothing to repair"));
    EXPECT_THAT(summary(record), Contains(HasSubstr("no defects")));
}

TEST(InfoSummary, SpeaksOfDirectionsWhereThereAreSome) {
    InfoRecord record = info_record();
    EXPECT_THAT(summary(record), Not(Contains(HasSubstr("directions"))));
    record.directions = InfoRecord::DirectionsFound::vertices;
    record.has_ranges = true;
    EXPECT_THAT(summary(record),
                Contains("normals or displacement directions per vertex, with ranges of displacements"));
}

} // namespace

} // namespace foldless
