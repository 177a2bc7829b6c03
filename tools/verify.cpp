#include <foldless/tools/verify.h>

#include <foldless/io/bounding_box.h>
#include <foldless/io/printable.h>
#include <foldless/io/read_mesh.h>
#include <foldless/io/write_mesh.h>
#include <foldless/report/json_report.h>
#include <foldless/report/process_usage.h>
#include <foldless/report/summary.h>
#include <foldless/tools/input.h>
#include <foldless/tools/wrong_usage.h>

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

namespace foldless {

namespace {

void require_report_apart(const VerifyCommand& command) {
    std::error_code ignored;
    if (command.report && (std::filesystem::equivalent(*command.report, command.base, ignored) ||
                           std::filesystem::equivalent(*command.report, command.scan, ignored))) {
        throw WrongUsage(fmt::format("--report would overwrite the mesh {}", printable(*command.report)));
    }
}

BaseMesh read_base(const std::filesystem::path& path, const Console& console) {
    ReadBaseMesh read = read_base_mesh(path);
    if (const std::string notes = notes_text(read.notes); !notes.empty()) {
        console.note(fmt::format("{}: {}", printable(path), notes));
    }
    return std::move(read.base);
}

DisplacementStatistics displacement_of(const VerifyResult& result, const Scan& scan) {
    return with_share_of_diagonal({result.min_displacement, result.max_displacement, result.rms_displacement},
                                  bounding_box_diagonal(scan));
}

/// The scan has been inspected before, so that whatever verify() refuses is the base mesh.
VerifyResult verify_base(const std::filesystem::path& path, const BaseMesh& base, const Input& input,
                         const VerifyCommand& command) {
    try {
        return verify_with_bar(base, input.scan, threads_to_use(command.threads), Console(command.quiet));
    } catch (const RefusedMesh& refusal) {
        throw RefusedMesh(fmt::format("{}: {}", printable(path), refusal.what()));
    }
}

VerifyRecord record_of(const VerifyCommand& command) {
    const Console console(command.quiet);
    Stopwatch watch;
    const BaseMesh base = read_base(command.base, console);
    const Input input = read_input(command.scan, console);
    VerifyRecord record;
    record.usage.times.read = watch.lap();
    record.certificate = verify_base(command.base, base, input, command);
    record.usage.times.verify = watch.lap();
    record.usage.peak_memory_bytes = peak_memory_bytes();
    record.usage.threads = threads_to_use(command.threads);
    record.input = input.record;
    record.output = {command.base.string(), base.positions.size(), base.faces.size(), record.certificate.frozen_faces};
    record.displacement = displacement_of(record.certificate, input.scan);
    return record;
}

} // namespace

VerifyResult verify_with_bar(const BaseMesh& base, const Scan& scan, int threads, const Console& console) {
    ProgressBar bar(console.bar_output());
    VerifyOptions options;
    options.threads = threads;
    options.progress = [&](double share) {
        bar.show("verifying", share, "");
        return true;
    };
    return verify(base, scan, options);
}

void print_violations(std::string_view name, const VerifyResult& result) {
    print_message(fmt::format("{}: not certified: {}", name, violations_text(result)));
    std::ranges::for_each(located_lines(result), print_message);
}

ExitCode run(const VerifyCommand& command) {
    require_report_apart(command);
    if (command.report) {
        require_writable(*command.report);
    }
    const VerifyRecord record = record_of(command);
    if (command.report) {
        write_text(*command.report, json_report(record));
    }
    if (!record.certificate.certified()) {
        print_violations(printable(command.base), record.certificate);
        return ExitCode::not_certified;
    }
    Console(command.quiet)
        .note(fmt::format("{} represents {}: certified, {}", printable(command.base), printable(command.scan),
                          certificate_text(record.certificate)));
    return ExitCode::done;
}

} // namespace foldless
