#include <foldless/report/summary.h>

#include <foldless/io/printable.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

namespace foldless {

namespace {

/// How many kinds of refusals a summary names, the most frequent first; the report has them all.
constexpr std::size_t refusals_shown = 4;

constexpr double percent = 100.0;
constexpr double bytes_per_megabyte = 1e6;

std::string size_text(std::size_t vertices, std::size_t faces) {
    return fmt::format("{}, {}", counted(vertices, "vertex", "vertices"), counted(faces, "face", "faces"));
}

std::string topology_text(const Topology& topology) {
    std::string text =
        fmt::format("{}, Euler characteristic {}, ", counted(topology.components, "component", "components"),
                    topology.euler_characteristic);
    text += topology.boundary_edges == 0
                ? "closed"
                : fmt::format("{} with {}", counted(topology.boundary_loops, "boundary loop", "boundary loops"),
                              counted(topology.boundary_edges, "edge", "edges"));
    if (topology.unused_vertices > 0) {
        text += fmt::format(", {}", counted(topology.unused_vertices, "unused vertex", "unused vertices"));
    }
    return text;
}

std::string output_text(const SimplifyRecord& record) {
    const OutputRecord& output = record.output;
    std::string text =
        fmt::format("{}: {}, {:.2f} % fewer faces", printable(output.path), size_text(output.vertices, output.faces),
                    percent * decimation_rate(record.input, output));
    if (output.frozen_faces > 0) {
        text += fmt::format(", {} frozen", output.frozen_faces);
    }
    return text;
}

std::string_view stop_text(StopReason reason) {
    switch (reason) {
    case StopReason::target_reached: return "the target is reached";
    case StopReason::every_edge_refused: return "every edge is refused";
    case StopReason::time_limit: return "the time limit is reached";
    case StopReason::cancelled: return "cancelled";
    }
    return "";
}

std::string refusals_text(const VerdictCounts& counts) {
    std::array<std::size_t, verdict_count> order;
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return counts[i]; });
    std::vector<std::string> texts;
    for (const std::size_t i : order) {
        if (counts[i] > 0 && texts.size() < refusals_shown) {
            texts.push_back(fmt::format("{} {}", counts[i], name(static_cast<Verdict>(i))));
        }
    }
    return fmt::format("{}", fmt::join(texts, ", "));
}

std::string collapses_text(const SimplifyRecord& record) {
    const DecimateStatistics& statistics = record.statistics;
    std::string text = fmt::format("{}; {} of {}", stop_text(record.stop_reason), statistics.accepted,
                                   counted(statistics.attempted, "asked edge collapsed", "asked edges collapsed"));
    if (const std::string refusals = refusals_text(statistics.refused); !refusals.empty()) {
        text += fmt::format("; refused placements: {}", refusals);
    }
    return text;
}

std::string displacement_text(const DisplacementStatistics& displacement) {
    return fmt::format("displacements {:.4g} to {:.4g}, at most {:.3g} % of the diagonal", displacement.min,
                       displacement.max, percent * displacement.max_relative_to_diagonal);
}

std::string usage_text(const Usage& usage) {
    const PhaseTimes& times = usage.times;
    const double total =
        times.read.seconds + times.setup.seconds + times.decimate.seconds + times.verify.seconds + times.write.seconds;
    return fmt::format("{:.1f} s (read {:.1f}, setup {:.1f}, decimate {:.1f}, verify {:.1f}, write {:.1f}), {:.0f} MB",
                       total, times.read.seconds, times.setup.seconds, times.decimate.seconds, times.verify.seconds,
                       times.write.seconds, static_cast<double>(usage.peak_memory_bytes) / bytes_per_megabyte);
}

std::string located_text(const LocatedViolation& found) {
    std::string text(name(found.violation));
    const std::pair<const char*, std::int32_t> indices[]{
        {"scan vertex", found.scan_vertex}, {"scan face", found.scan_face}, {"base face", found.base_face}};
    for (const auto& [what, index] : indices) {
        if (index >= 0) {
            text += fmt::format(", {} {}", what, index);
        }
    }
    return text +
           fmt::format(", at ({:.9g}, {:.9g}, {:.9g})", found.position.x(), found.position.y(), found.position.z());
}

/// What would make a refused mesh acceptable.
std::string outlook_text(const std::optional<RepairOutlook>& outlook) {
    return outlook ? fmt::format("foldless repair would make it acceptable: {}; {} left", outlook->counts.text(),
                                 size_text(outlook->vertices, outlook->faces))
                   : "foldless repair would refuse this mesh, too";
}

std::string directions_text(const InfoRecord& record) {
    const bool on_faces = record.directions == InfoRecord::DirectionsFound::faces;
    return fmt::format("normals or displacement directions per {}, {} of displacements", on_faces ? "face" : "vertex",
                       record.has_ranges ? "with ranges" : "no ranges");
}

} // namespace

std::string notes_text(const ReadNotes& notes) {
    std::vector<std::string> texts;
    if (!notes.ignored.empty()) {
        texts.push_back(fmt::format("ignored {}", fmt::join(notes.ignored, ", ")));
    }
    if (notes.fanned_polygons > 0) {
        texts.push_back(fmt::format("fanned {}", counted(notes.fanned_polygons, "polygon", "polygons")));
    }
    if (notes.welded_vertices > 0) {
        texts.push_back(
            fmt::format("merged {} at equal positions", counted(notes.welded_vertices, "corner", "corners")));
    }
    return fmt::format("{}", fmt::join(texts, "; "));
}

std::string violations_text(const VerifyResult& result) {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < violation_count; ++i) {
        if (result.violations[i] > 0) {
            texts.push_back(fmt::format("{} {}", result.violations[i], name(static_cast<Violation>(i))));
        }
    }
    return fmt::format("{}", fmt::join(texts, ", "));
}

Lines located_lines(const VerifyResult& result) {
    Lines lines;
    std::ranges::transform(result.located, std::back_inserter(lines), located_text);
    return lines;
}

std::string certificate_text(const VerifyResult& result) {
    return fmt::format("level {}, {}, {:.3g} % of the base mesh uncovered{}", name(result.level),
                       counted(result.ambiguous_vertices, "ambiguous vertex", "ambiguous vertices"),
                       percent * result.uncovered_fraction,
                       result.ranges_computed ? ", ranges computed, since the file has none" : "");
}

Lines summary(const SimplifyRecord& record) {
    const InputRecord& input = record.input;
    Lines lines{
        fmt::format("{}: {}, {}", printable(input.path), size_text(input.vertices, input.faces),
                    topology_text(input.topology)),
        output_text(record),
        collapses_text(record),
    };
    if (const std::size_t unserved = record.statistics.unserved_vertices; unserved > 0) {
        lines.push_back(fmt::format("{} that no direction serves: faces there stay those of the scan",
                                    counted(unserved, "scan vertex", "scan vertices")));
    }
    lines.push_back(displacement_text(record.displacement));
    lines.push_back(record.certificate ? fmt::format("certified: {}", certificate_text(*record.certificate))
                                       : "not verified");
    lines.push_back(usage_text(record.usage));
    return lines;
}

Lines summary(const RepairRecord& record) {
    const auto& [path, vertices, faces, topology] = record.output;
    return {
        fmt::format("{}: {}, {}", printable(record.input.path), size_text(record.input.vertices, record.input.faces),
                    record.defects.any() ? record.defects.text() : "no defects"),
        record.counts.any() ? record.counts.text() : "nothing to repair",
        fmt::format("{}: {}, {}", printable(path), size_text(vertices, faces), topology_text(topology)),
    };
}

Lines summary(const InfoRecord& record) {
    Lines lines{fmt::format("{}: {}", printable(record.path), size_text(record.vertices, record.faces))};
    if (record.refusal.empty()) {
        lines.push_back(topology_text(record.inspection.topology));
        lines.push_back(fmt::format("bounding box diagonal {:.6g}, coordinates are {}", record.diagonal,
                                    record.float32 ? "float32" : "float64"));
    }
    if (record.directions != InfoRecord::DirectionsFound::none) {
        lines.push_back(directions_text(record));
    }
    if (const std::string notes = notes_text(record.notes); !notes.empty()) {
        lines.push_back(notes);
    }
    if (record.refusal.empty()) {
        lines.emplace_back("simplify accepts this mesh");
        return lines;
    }
    lines.push_back(fmt::format("simplify refuses this mesh: {}", record.refusal));
    lines.push_back(outlook_text(record.repair));
    return lines;
}

} // namespace foldless
