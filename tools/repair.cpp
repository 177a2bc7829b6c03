#include <foldless/tools/repair.h>

#include <foldless/io/atomic_file.h>
#include <foldless/io/defects.h>
#include <foldless/io/errors.h>
#include <foldless/io/printable.h>
#include <foldless/io/read_mesh.h>
#include <foldless/io/write_mesh.h>
#include <foldless/report/header_comments.h>
#include <foldless/report/json_report.h>
#include <foldless/report/process_usage.h>
#include <foldless/report/summary.h>
#include <foldless/tools/console.h>
#include <foldless/tools/input.h>
#include <foldless/tools/plain_mesh.h>

#include <fmt/format.h>

#include <stdexcept>
#include <utility>
#include <vector>

namespace foldless {

namespace {

RepairResult repair_named(const std::filesystem::path& path, Scan scan, const RepairOptions& options) {
    try {
        return repair(std::move(scan), options);
    } catch (const RefusedMesh& refusal) {
        throw RefusedMesh(fmt::format("{}: {}", printable(path), refusal.what()));
    }
}

/// What was promised is looked at before it is written.
Topology topology_of_repaired(const Scan& scan) {
    const Inspection inspection = inspect(scan);
    if (inspection.defects.any()) {
        throw std::logic_error(fmt::format("the repair left {}", inspection.defects.text()));
    }
    return inspection.topology;
}

struct Repaired {
    Scan scan;
    RepairRecord record;
};

Repaired repair_file(const RepairCommand& command) {
    RepairRecord record;
    Stopwatch watch;
    ReadScan read = read_scan(command.scan);
    Scan& scan = read.scan;
    record.options = command.options;
    record.input = {command.scan.string(), scan.positions.size(), scan.faces.size(), {}};
    record.defects = inspect(scan).defects;
    record.usage.times.read = watch.lap();
    RepairResult result = repair_named(command.scan, std::move(scan), command.options);
    note_ignored(command.scan, read.notes, Console(command.quiet));
    record.counts = result.counts;
    record.output = {command.output.string(), result.scan.positions.size(), result.scan.faces.size(),
                     topology_of_repaired(result.scan)};
    record.usage.times.repair = watch.lap();
    return {std::move(result.scan), std::move(record)};
}

std::vector<AtomicFile> stage_outputs(const RepairCommand& command, Scan scan, RepairRecord& record) {
    Stopwatch watch;
    std::vector<AtomicFile> files;
    files.push_back(
        stage_base_mesh(command.output, without_directions(std::move(scan)), header_comments(command.options)));
    record.usage.times.write = watch.lap();
    record.usage.peak_memory_bytes = peak_memory_bytes();
    if (command.report) {
        files.push_back(stage_text(*command.report, json_report(record)));
    }
    return files;
}

} // namespace

ExitCode run(const RepairCommand& command) {
    require_writable(command.output);
    if (command.report) {
        require_writable(*command.report);
    }
    auto [scan, record] = repair_file(command);
    std::vector<AtomicFile> files = stage_outputs(command, std::move(scan), record);
    const std::vector<std::string> lines = summary(record);
    commit_all(files);
    Console(command.quiet).print(lines);
    return ExitCode::done;
}

} // namespace foldless
