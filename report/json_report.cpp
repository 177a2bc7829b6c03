#include <foldless/report/json_report.h>

#include <foldless/report/option_names.h>
#include <foldless/report/version.h>

#include <nlohmann/json.hpp>

#include <span>
#include <utility>

namespace foldless {

namespace {

using Json = nlohmann::ordered_json;
using NamedTime = std::pair<const char*, PhaseTime>;

constexpr int indentation = 2;

template <class Value>
Json value_or_null(const std::optional<Value>& value) {
    return value ? Json(*value) : Json(nullptr);
}

/// Null for a text that is empty: what was not written, what was not refused.
Json text_or_null(const std::string& text) {
    return text.empty() ? Json(nullptr) : Json(text);
}

Json point_json(const Vec3& point) {
    return {point.x(), point.y(), point.z()};
}

Json heading(const char* command) {
    return {{"foldless", version()}, {"command", command}};
}

Json options_json(Preset preset, const DecimateOptions& options, bool verified) {
    return {
        {"preset", option_name(preset)},
        {"faces", value_or_null(options.target_faces)},
        {"directions", option_name(options.directions)},
        {"store_directions", options.store_directions},
        {"placement", option_name(options.placement)},
        {"boundary", option_name(options.boundary)},
        {"max_displacement", value_or_null(options.max_displacement)},
        {"edge_valence_limit", options.edge_valence_limit},
        {"time_limit", value_or_null(options.time_limit)},
        {"verify", verified},
    };
}

void add_topology(Json& json, const Topology& topology) {
    json["unused_vertices"] = topology.unused_vertices;
    json["components"] = topology.components;
    json["boundary_loops"] = topology.boundary_loops;
    json["boundary_edges"] = topology.boundary_edges;
    json["euler_characteristic"] = topology.euler_characteristic;
}

Json mesh_json(const InputRecord& input) {
    Json json{{"path", input.path}, {"vertices", input.vertices}, {"faces", input.faces}};
    add_topology(json, input.topology);
    return json;
}

Json output_json(const OutputRecord& output) {
    return {{"path", text_or_null(output.path)},
            {"vertices", output.vertices},
            {"faces", output.faces},
            {"frozen_faces", output.frozen_faces}};
}

Json refusals_json(const VerdictCounts& counts) {
    Json json = Json::object();
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] > 0) {
            json[std::string(name(static_cast<Verdict>(i)))] = counts[i];
        }
    }
    return json;
}

Json displacement_json(const DisplacementStatistics& displacement) {
    return {{"min", displacement.min},
            {"max", displacement.max},
            {"rms", displacement.rms},
            {"max_relative_to_diagonal", displacement.max_relative_to_diagonal}};
}

Json violations_json(const VerifyResult& result) {
    Json json = Json::object();
    for (std::size_t i = 0; i < violation_count; ++i) {
        json[std::string(name(static_cast<Violation>(i)))] = result.violations[i];
    }
    return json;
}

Json located_json(const VerifyResult& result) {
    Json list = Json::array();
    for (const LocatedViolation& found : result.located) {
        list.push_back({{"violation", name(found.violation)},
                        {"scan_vertex", found.scan_vertex},
                        {"scan_face", found.scan_face},
                        {"base_face", found.base_face},
                        {"position", point_json(found.position)}});
    }
    return list;
}

Json certificate_json(const VerifyResult& result) {
    return {{"level", name(result.level)},
            {"signs", {{"filtered", result.signs.filtered}, {"exact", result.signs.exact}}},
            {"violations", result.violation_total()},
            {"ambiguous_vertices", result.ambiguous_vertices},
            {"uncovered_fraction", result.uncovered_fraction},
            {"ranges_computed", result.ranges_computed},
            {"violations_by_name", violations_json(result)},
            {"located", located_json(result)}};
}

void add_usage(Json& json, const Usage& usage, std::span<const NamedTime> phases) {
    for (const auto& [phase, time] : phases) {
        json["seconds"][phase] = time.seconds;
        json["cpu_seconds"][phase] = time.cpu_seconds;
    }
    json["peak_memory_bytes"] = usage.peak_memory_bytes;
    json["threads"] = usage.threads;
}

const char* directions_word(InfoRecord::DirectionsFound directions) {
    switch (directions) {
    case InfoRecord::DirectionsFound::none: return "none";
    case InfoRecord::DirectionsFound::vertices: return "vertices";
    case InfoRecord::DirectionsFound::faces: return "faces";
    }
    return "none";
}

Json defects_json(const Defects& defects) {
    return {{"no_faces", defects.no_faces},
            {"not_finite", defects.not_finite},
            {"index_out_of_range", defects.index_out_of_range},
            {"repeated_index", defects.repeated_index},
            {"zero_area", defects.zero_area},
            {"non_manifold_edges", defects.non_manifold_edges},
            {"inconsistent_edges", defects.inconsistent_edges},
            {"non_manifold_vertices", defects.non_manifold_vertices},
            {"non_orientable_components", defects.non_orientable_components}};
}

Json repairs_json(const RepairCounts& counts) {
    Json json = Json::object();
    for (const RepairCountName& name : repair_count_names) {
        json[name.key] = counts.*name.count;
    }
    return json;
}

Json outlook_json(const RepairOutlook& outlook) {
    return {{"vertices", outlook.vertices}, {"faces", outlook.faces}, {"repairs", repairs_json(outlook.counts)}};
}

Json notes_json(const ReadNotes& notes) {
    return {{"fanned_polygons", notes.fanned_polygons},
            {"welded_vertices", notes.welded_vertices},
            {"ignored", notes.ignored}};
}

Json maps_json(const MapsRecord& maps) {
    return {{"path", text_or_null(maps.path)},
            {"method", maps.method == BakeMethod::direct ? "direct" : "inverse"},
            {"size", maps.size},
            {"samples", maps.samples},
            {"uncovered", maps.uncovered},
            {"contested", maps.contested}};
}

Json one_sided_json(const OneSidedDistance& distance, double diagonal) {
    return {{"maximum", distance.maximum},
            {"maximum_bound", distance.maximum_bound},
            {"maximum_relative_to_diagonal", distance.maximum / diagonal},
            {"rms", distance.rms},
            {"rms_relative_to_diagonal", distance.rms / diagonal},
            {"furthest", point_json(distance.furthest)},
            {"nearest", point_json(distance.nearest)}};
}

Json comparison_json(const Comparison& comparison) {
    return {{"scan", mesh_json(comparison.scan)},
            {"bounding_box_diagonal", comparison.diagonal},
            {"bound", comparison.bound},
            {"from_scan", one_sided_json(comparison.distance.there, comparison.diagonal)},
            {"to_scan", one_sided_json(comparison.distance.back, comparison.diagonal)}};
}

Json fit_json(const FitRecord& record) {
    return {{"max_error", record.max_error},
            {"fits", record.fit.fits},
            {"level", record.fit.level},
            {"bounding_box_diagonal", record.diagonal},
            {"from_scan", one_sided_json(record.fit.distance.there, record.diagonal)},
            {"to_scan", one_sided_json(record.fit.distance.back, record.diagonal)}};
}

std::string text_of(const Json& json) {
    return json.dump(indentation, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace

std::string json_report(const SimplifyRecord& record) {
    Json json = heading("simplify");
    json["options"] = options_json(record.preset, record.options, record.certificate.has_value());
    json["input"] = mesh_json(record.input);
    json["output"] = output_json(record.output);
    json["unserved_vertices"] = record.statistics.unserved_vertices;
    json["decimation_rate"] = decimation_rate(record.input, record.output);
    json["stop_reason"] = option_name(record.stop_reason);
    json["collapses"] = {{"attempted", record.statistics.attempted},
                         {"accepted", record.statistics.accepted},
                         {"refused", refusals_json(record.statistics.refused)},
                         {"refused_between_vertices", record.statistics.refused_between_vertices}};
    json["displacement"] = displacement_json(record.displacement);
    json["certificate"] = record.certificate ? certificate_json(*record.certificate) : Json(nullptr);
    const PhaseTimes& times = record.usage.times;
    const NamedTime phases[]{{"read", times.read},
                             {"setup", times.setup},
                             {"decimate", times.decimate},
                             {"verify", times.verify},
                             {"write", times.write}};
    add_usage(json, record.usage, phases);
    return text_of(json);
}

std::string json_report(const VerifyRecord& record) {
    Json json = heading("verify");
    json["options"] = Json::object();
    json["input"] = mesh_json(record.input);
    json["output"] = output_json(record.output);
    json["decimation_rate"] = decimation_rate(record.input, record.output);
    json["displacement"] = displacement_json(record.displacement);
    json["certificate"] = certificate_json(record.certificate);
    const NamedTime phases[]{{"read", record.usage.times.read}, {"verify", record.usage.times.verify}};
    add_usage(json, record.usage, phases);
    return text_of(json);
}

std::string json_report(const RepairRecord& record) {
    Json json = heading("repair");
    json["options"] = {{"min_component_faces", record.options.min_component_faces},
                       {"drop_unserved", record.options.drop_unserved}};
    json["input"] = {{"path", record.input.path},
                     {"vertices", record.input.vertices},
                     {"faces", record.input.faces},
                     {"defects", defects_json(record.defects)}};
    json["repairs"] = repairs_json(record.counts);
    json["output"] = mesh_json(record.output);
    const PhaseTimes& times = record.usage.times;
    const NamedTime phases[]{{"read", times.read}, {"repair", times.repair}, {"write", times.write}};
    add_usage(json, record.usage, phases);
    return text_of(json);
}

std::string json_report(const BakeRecord& record) {
    Json json = heading("bake");
    json["input"] = mesh_json(record.input);
    json["base"] = output_json(record.base);
    json["maps"] = maps_json(record.maps);
    json["fit"] = record.fit ? fit_json(*record.fit) : Json(nullptr);
    json["certificate"] = certificate_json(record.certificate);
    const PhaseTimes& times = record.usage.times;
    const NamedTime phases[]{{"read", times.read},
                             {"verify", times.verify},
                             {"fit", times.fit},
                             {"bake", times.bake},
                             {"write", times.write}};
    add_usage(json, record.usage, phases);
    return text_of(json);
}

std::string json_report(const ReconstructRecord& record) {
    Json json = heading("reconstruct");
    json["options"] = {{"level", record.level}};
    json["base"] = record.base;
    json["maps"] = record.maps;
    json["output"] = {{"path", record.path}, {"vertices", record.vertices}, {"faces", record.faces}};
    json["comparison"] = record.comparison ? comparison_json(*record.comparison) : Json(nullptr);
    const PhaseTimes& times = record.usage.times;
    const NamedTime phases[]{
        {"read", times.read}, {"reconstruct", times.reconstruct}, {"compare", times.compare}, {"write", times.write}};
    add_usage(json, record.usage, phases);
    return text_of(json);
}

std::string json_report(const InfoRecord& record) {
    Json json = heading("info");
    json["path"] = record.path;
    json["vertices"] = record.vertices;
    json["faces"] = record.faces;
    if (record.refusal.empty()) {
        add_topology(json, record.inspection.topology);
    }
    json["bounding_box_diagonal"] = record.diagonal;
    json["float32"] = record.float32;
    json["defects"] = defects_json(record.inspection.defects);
    json["accepted"] = record.refusal.empty();
    json["refusal"] = text_or_null(record.refusal);
    json["repair"] = record.repair ? outlook_json(*record.repair) : Json(nullptr);
    json["directions"] = directions_word(record.directions);
    json["ranges"] = record.has_ranges;
    json["notes"] = notes_json(record.notes);
    return text_of(json);
}

} // namespace foldless
