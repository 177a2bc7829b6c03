/// \file
/// Records of made-up runs with a different number in every field, so that none can stand for another.
#pragma once

#include <foldless/report/run_record.h>

namespace foldless {

inline VerifyResult clean_result() {
    VerifyResult result;
    result.ambiguous_vertices = 3;
    result.frozen_faces = 12;
    result.uncovered_fraction = 0.25;
    return result;
}

inline VerifyResult violated_result() {
    VerifyResult result = clean_result();
    result.violations[static_cast<std::size_t>(Violation::orientation)] = 2;
    result.violations[static_cast<std::size_t>(Violation::no_preimage)] = 5;
    result.located = {{Violation::no_preimage, 7, -1, 9, Vec3(0.5, -1.5, 2.0)}};
    return result;
}

inline SimplifyRecord simplify_record() {
    SimplifyRecord record;
    record.options.target_faces = 300;
    record.options.time_limit = 60.0;
    record.input = {"in put.ply", 102, 200, {1, 2, 3, 40, -5}};
    record.output = {"out.ply", 31, 50, 12};
    record.statistics.attempted = 90;
    record.statistics.refused_between_vertices = 7;
    record.statistics.accepted = 75;
    record.statistics.refused[static_cast<std::size_t>(Verdict::jacobian)] = 11;
    record.statistics.refused[static_cast<std::size_t>(Verdict::flip)] = 44;
    record.statistics.unserved_vertices = 6;
    record.displacement = {-0.5, 0.75, 0.125, 0.01};
    record.certificate = clean_result();
    record.usage = {{{1.5, 1.25}, {2.5, 2.25}, {3.5, 3.25}, {4.5, 4.25}, {5.5, 5.25}, {}}, 64'000'000, 8};
    return record;
}

inline VerifyRecord verify_record() {
    VerifyRecord record;
    record.input = {"scan.ply", 102, 200, {1, 2, 3, 40, -5}};
    record.output = {"base.ply", 31, 50, 12};
    record.displacement = {-0.5, 0.75, 0.125, 0.01};
    record.certificate = violated_result();
    record.usage = {{{1.5, 1.25}, {}, {}, {4.5, 4.25}, {}, {}}, 64'000'000, 8};
    return record;
}

inline RepairRecord repair_record() {
    RepairRecord record;
    record.options.min_component_faces = 21;
    record.input = {"in put.ply", 102, 200, {}};
    record.defects.zero_area = 22;
    std::size_t number = 30;
    for (const RepairCountName& name : repair_count_names) {
        record.counts.*name.count = number++;
    }
    record.output = {"out.ply", 101, 190, {1, 2, 3, 40, -5}};
    record.usage = {{{1.5, 1.25}, {}, {}, {}, {5.5, 5.25}, {6.5, 6.25}}, 64'000'000, 1};
    return record;
}

inline InfoRecord info_record() {
    InfoRecord record;
    record.path = "mesh.ply";
    record.vertices = 4;
    record.faces = 5;
    return record;
}

} // namespace foldless
