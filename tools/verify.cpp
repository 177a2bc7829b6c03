#include <foldless/tools/verify.h>

#include <foldless/io/atomic_file.h>
#include <foldless/io/bounding_box.h>
#include <foldless/io/printable.h>
#include <foldless/io/read_mesh.h>
#include <foldless/io/write_mesh.h>
#include <foldless/report/json_report.h>
#include <foldless/report/process_usage.h>
#include <foldless/report/summary.h>
#include <foldless/report/violations_ply.h>
#include <foldless/tools/base_input.h>
#include <foldless/tools/input.h>
#include <foldless/tools/threads.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace foldless {

namespace {

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

struct Verification {
    BaseMesh base;
    Input input;
    VerifyRecord record;
};

Verification verify_files(const VerifyCommand& command) {
    const Console console(command.quiet);
    Stopwatch watch;
    Verification done{read_base(command.base, console), read_input(command.scan, console), {}};
    VerifyRecord& record = done.record;
    record.usage.times.read = watch.lap();
    record.certificate = verify_base(command.base, done.base, done.input, command);
    record.usage.times.verify = watch.lap();
    record.usage.peak_memory_bytes = peak_memory_bytes();
    record.usage.threads = threads_to_use(command.threads);
    record.input = done.input.record;
    record.output = {command.base.string(), done.base.positions.size(), done.base.faces.size(),
                     record.certificate.frozen_faces};
    record.displacement = displacement_of(record.certificate, done.input.scan);
    return done;
}

std::vector<AtomicFile> stage_outputs(const VerifyCommand& command, const Verification& done) {
    std::vector<AtomicFile> files;
    if (command.violations) {
        files.push_back(
            stage_text(*command.violations, violations_ply(done.record.certificate, done.base, done.input.scan)));
    }
    if (command.report) {
        files.push_back(stage_text(*command.report, json_report(done.record)));
    }
    return files;
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

std::vector<std::string> violation_messages(std::string_view name, const VerifyResult& result) {
    if (result.certified()) {
        return {};
    }
    std::vector<std::string> messages{fmt::format("{}: not certified: {}", name, violations_text(result))};
    std::ranges::move(located_lines(result), std::back_inserter(messages));
    return messages;
}

ExitCode run(const VerifyCommand& command) {
    for (const auto& output : {command.report, command.violations}) {
        if (output) {
            require_writable(*output);
        }
    }
    const ThreadAllowance allowance(threads_to_use(command.threads));
    const Verification done = verify_files(command);
    const VerifyResult& certificate = done.record.certificate;
    std::vector<AtomicFile> files = stage_outputs(command, done);
    const std::vector<std::string> violations = violation_messages(printable(command.base), certificate);
    const std::string proof = fmt::format("{} represents {}: certified, {}", printable(command.base),
                                          printable(command.scan), certificate_text(certificate));
    commit_all(files);
    if (!certificate.certified()) {
        std::ranges::for_each(violations, print_message);
        return ExitCode::not_certified;
    }
    Console(command.quiet).note(proof);
    return ExitCode::done;
}

} // namespace foldless
