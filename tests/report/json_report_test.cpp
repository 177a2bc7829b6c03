#include <foldless/report/json_report.h>

#include "records.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <string>
#include <vector>

namespace foldless {

namespace {

using nlohmann::json;
using testing::UnorderedElementsAre;

std::vector<std::string> keys(const json& object) {
    std::vector<std::string> found;
    for (const auto& item : object.items()) {
        found.push_back(item.key());
    }
    return found;
}

template <class Record>
json parsed(const Record& record) {
    return json::parse(json_report(record));
}

TEST(SimplifyReport, HasTheKeysThatArePromised) {
    const json report = parsed(simplify_record());
    EXPECT_THAT(keys(report),
                UnorderedElementsAre("foldless", "command", "options", "input", "output", "unserved_vertices",
                                     "decimation_rate", "stop_reason", "collapses", "displacement", "certificate",
                                     "seconds", "cpu_seconds", "peak_memory_bytes", "threads"));
    EXPECT_THAT(keys(report["input"]),
                UnorderedElementsAre("path", "vertices", "faces", "unused_vertices", "components", "boundary_loops",
                                     "boundary_edges", "euler_characteristic"));
    EXPECT_THAT(keys(report["output"]), UnorderedElementsAre("path", "vertices", "faces", "frozen_faces"));
    EXPECT_THAT(keys(report["displacement"]), UnorderedElementsAre("min", "max", "rms", "max_relative_to_diagonal"));
    EXPECT_THAT(keys(report["seconds"]), UnorderedElementsAre("read", "setup", "decimate", "verify", "write"));
    EXPECT_THAT(keys(report["cpu_seconds"]), UnorderedElementsAre("read", "setup", "decimate", "verify", "write"));
}

TEST(SimplifyReport, PutsEachNumberInItsPlace) {
    const json report = parsed(simplify_record());
    EXPECT_EQ(report["command"], "simplify");
    EXPECT_EQ(report["input"], json::parse(R"({"path": "in put.ply", "vertices": 102, "faces": 200,
        "unused_vertices": 1, "components": 2, "boundary_loops": 3, "boundary_edges": 40,
        "euler_characteristic": -5})"));
    EXPECT_EQ(report["output"], json::parse(R"({"path": "out.ply", "vertices": 31, "faces": 50, "frozen_faces": 12})"));
    EXPECT_EQ(report["unserved_vertices"], 6);
    EXPECT_EQ(report["decimation_rate"], 0.75);
    EXPECT_EQ(report["displacement"],
              json::parse(R"({"min": -0.5, "max": 0.75, "rms": 0.125, "max_relative_to_diagonal": 0.01})"));
    EXPECT_EQ(report["seconds"],
              json::parse(R"({"read": 1.5, "setup": 2.5, "decimate": 3.5, "verify": 4.5, "write": 5.5})"));
    EXPECT_EQ(report["cpu_seconds"],
              json::parse(R"({"read": 1.25, "setup": 2.25, "decimate": 3.25, "verify": 4.25, "write": 5.25})"));
    EXPECT_EQ(report["peak_memory_bytes"], 64'000'000);
    EXPECT_EQ(report["threads"], 8);
}

TEST(SimplifyReport, CountsRefusalsByTheirNames) {
    EXPECT_EQ(parsed(simplify_record())["collapses"],
              json::parse(R"({"attempted": 90, "accepted": 75, "refused": {"flip": 44, "jacobian": 11},
                               "refused_between_vertices": 7})"));
}

TEST(SimplifyReport, NamesEachStopReason) {
    SimplifyRecord record = simplify_record();
    for (const auto& [reason, word] : {std::pair(StopReason::target_reached, "target_reached"),
                                       std::pair(StopReason::every_edge_refused, "every_edge_refused"),
                                       std::pair(StopReason::time_limit, "time_limit")}) {
        record.stop_reason = reason;
        EXPECT_EQ(parsed(record)["stop_reason"], word);
    }
}

TEST(SimplifyReport, TellsOptionsThatWereNotGivenByNull) {
    const json options = parsed(simplify_record())["options"];
    EXPECT_EQ(options["preset"], "default");
    EXPECT_EQ(options["faces"], 300);
    EXPECT_EQ(options["time_limit"], 60.0);
    EXPECT_TRUE(options["max_displacement"].is_null());
}

TEST(SimplifyReport, HasNoCertificateIfNothingWasVerified) {
    SimplifyRecord record = simplify_record();
    record.certificate.reset();
    EXPECT_TRUE(parsed(record)["certificate"].is_null());
    EXPECT_EQ(parsed(record)["options"]["verify"], false);
}

TEST(SimplifyReport, HasNoPathOfAnOutputThatWasNotWritten) {
    SimplifyRecord record = simplify_record();
    record.output.path.clear();
    EXPECT_TRUE(parsed(record)["output"]["path"].is_null());
}

TEST(SimplifyReport, StaysJsonWithNumbersThatAreNotFinite) {
    SimplifyRecord record = simplify_record();
    record.displacement.max = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(parsed(record)["displacement"]["max"].is_null());
}

TEST(SimplifyReport, StaysJsonWithPathsThatAreNotUtf8) {
    SimplifyRecord record = simplify_record();
    record.input.path = "scan\xff\".ply";
    EXPECT_EQ(parsed(record)["input"]["path"], "scan\uFFFD\".ply");
}

TEST(VerifyReport, CountsViolationsByNameAndLocatesThem) {
    const json report = parsed(verify_record());
    EXPECT_EQ(report["command"], "verify");
    const json& certificate = report["certificate"];
    EXPECT_EQ(certificate["level"], "vertices");
    EXPECT_EQ(certificate["violations"], 7);
    EXPECT_EQ(certificate["ambiguous_vertices"], 3);
    EXPECT_EQ(certificate["uncovered_fraction"], 0.25);
    EXPECT_EQ(certificate["violations_by_name"]["orientation"], 2);
    EXPECT_EQ(certificate["violations_by_name"]["no_preimage"], 5);
    EXPECT_EQ(certificate["violations_by_name"]["topology"], 0);
    EXPECT_EQ(certificate["violations_by_name"].size(), violation_count);
    EXPECT_EQ(certificate["located"], json::parse(R"([{"violation": "no_preimage", "scan_vertex": 7, "scan_face": -1,
        "base_face": 9, "position": [0.5, -1.5, 2.0]}])"));
}

TEST(VerifyReport, SpeaksOfTheScanAsInputAndOfTheBaseMeshAsOutput) {
    const json report = parsed(verify_record());
    EXPECT_EQ(report["input"]["path"], "scan.ply");
    EXPECT_EQ(report["output"]["path"], "base.ply");
    EXPECT_EQ(report["decimation_rate"], 0.75);
    EXPECT_EQ(report["seconds"], json::parse(R"({"read": 1.5, "verify": 4.5})"));
    EXPECT_EQ(report["cpu_seconds"], json::parse(R"({"read": 1.25, "verify": 4.25})"));
}

TEST(InfoReport, TellsTopologyOfAnAcceptedMeshOnly) {
    InfoRecord record = info_record();
    record.inspection.topology.euler_characteristic = 2;
    EXPECT_EQ(parsed(record)["accepted"], true);
    EXPECT_EQ(parsed(record)["euler_characteristic"], 2);
    EXPECT_TRUE(parsed(record)["refusal"].is_null());
    record.inspection.defects.zero_area = 3;
    record.refusal = "3 zero-area faces";
    EXPECT_EQ(parsed(record)["accepted"], false);
    EXPECT_FALSE(parsed(record).contains("euler_characteristic"));
    EXPECT_EQ(parsed(record)["refusal"], "3 zero-area faces");
    EXPECT_EQ(parsed(record)["defects"]["zero_area"], 3);
}

TEST(InfoReport, TellsWhichRepairWouldMakeAMeshAcceptable) {
    InfoRecord record = info_record();
    EXPECT_TRUE(parsed(record)["repair"].is_null());
    record.refusal = "3 zero-area faces";
    EXPECT_TRUE(parsed(record)["repair"].is_null()) << "no repair would";
    record.repair = RepairOutlook{9, 8, {}};
    record.repair->counts.zero_area_faces = 3;
    EXPECT_EQ(parsed(record)["repair"]["vertices"], 9);
    EXPECT_EQ(parsed(record)["repair"]["faces"], 8);
    EXPECT_EQ(parsed(record)["repair"]["repairs"]["zero_area_faces"], 3);
}

TEST(RepairReport, HasEveryCountUnderItsName) {
    const auto report = parsed(repair_record());
    EXPECT_EQ(report["command"], "repair");
    EXPECT_EQ(report["options"]["min_component_faces"], 21);
    EXPECT_EQ(report["options"]["drop_unserved"], false);
    EXPECT_EQ(report["input"]["faces"], 200);
    EXPECT_EQ(report["input"]["defects"]["zero_area"], 22);
    EXPECT_EQ(report["repairs"].size(), repair_count_names.size());
    std::size_t number = 30;
    for (const RepairCountName& name : repair_count_names) {
        EXPECT_EQ(report["repairs"][name.key], number++) << name.key;
    }
    EXPECT_EQ(report["output"]["faces"], 190);
    EXPECT_EQ(report["output"]["boundary_edges"], 40);
    EXPECT_EQ(report["seconds"]["repair"], 6.5);
    EXPECT_EQ(report["cpu_seconds"]["write"], 5.25);
}

} // namespace

} // namespace foldless
