#include <foldless/tools/info.h>

#include <foldless/io/bounding_box.h>
#include <foldless/io/errors.h>
#include <foldless/io/file_type.h>
#include <foldless/io/read_mesh.h>
#include <foldless/repair/repair.h>
#include <foldless/report/json_report.h>
#include <foldless/report/summary.h>
#include <foldless/tools/standard_streams.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <utility>

namespace foldless {

namespace {

/// Adds what a base mesh has and a scan has not. That a scan has nothing of it is no failure.
void add_base_mesh(InfoRecord& record, const std::filesystem::path& path) {
    const FileType type = file_type(path);
    if (type != FileType::ply && type != FileType::obj) {
        return;
    }
    try {
        const auto [base, notes] = read_base_mesh(path);
        record.directions =
            base.directions.empty() ? InfoRecord::DirectionsFound::faces : InfoRecord::DirectionsFound::vertices;
        record.has_ranges = !base.ranges.empty();
        record.notes = notes; // directions and ranges are not ignored here
    } catch (const RefusedMesh&) {
        record.directions = InfoRecord::DirectionsFound::none;
    }
}

/// What a repair with no options would make of a mesh with defects; nothing if no face would be left.
std::optional<RepairOutlook> outlook_of(Scan scan) {
    try {
        const RepairResult result = repair(std::move(scan));
        return RepairOutlook{result.scan.positions.size(), result.scan.faces.size(), result.counts};
    } catch (const RefusedMesh&) {
        return std::nullopt;
    }
}

void add_scan(InfoRecord& record, ReadScan read) {
    record.vertices = read.scan.positions.size();
    record.faces = read.scan.faces.size();
    record.float32 = read.scan.float32;
    record.notes = read.notes;
    record.inspection = inspect(read.scan);
    record.refusal = record.inspection.defects.text();
    if (record.refusal.empty()) {
        record.diagonal = bounding_box_diagonal(read.scan);
    } else {
        record.repair = outlook_of(std::move(read.scan));
    }
}

InfoRecord record_of(const std::filesystem::path& path) {
    InfoRecord record;
    record.path = path.string();
    try {
        add_scan(record, read_scan(path));
    } catch (const RefusedMesh& refusal) {
        record.refusal = refusal.what();
    }
    add_base_mesh(record, path);
    return record;
}

} // namespace

ExitCode run(const InfoCommand& command) {
    const InfoRecord record = record_of(command.mesh);
    write_result(command.json ? json_report(record) : fmt::format("{}\n", fmt::join(summary(record), "\n")));
    return ExitCode::done;
}

} // namespace foldless
