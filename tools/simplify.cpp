#include <foldless/tools/simplify.h>

#include <foldless/io/atomic_file.h>
#include <foldless/io/bounding_box.h>
#include <foldless/io/file_type.h>
#include <foldless/io/printable.h>
#include <foldless/io/read_mesh.h>
#include <foldless/io/write_mesh.h>
#include <foldless/report/frozen_faces.h>
#include <foldless/report/header_comments.h>
#include <foldless/report/json_report.h>
#include <foldless/report/process_usage.h>
#include <foldless/report/summary.h>
#include <foldless/tools/bake.h>
#include <foldless/tools/console.h>
#include <foldless/tools/input.h>
#include <foldless/tools/lengths.h>
#include <foldless/tools/threads.h>
#include <foldless/tools/verify.h>

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace foldless {

namespace {

void require_writable_outputs(const SimplifyCommand& command) {
    require_writable(command.base);
    if (command.correspondence) {
        require_writable(*command.correspondence);
    }
    if (command.report) {
        require_writable(*command.report);
    }
    if (command.bake) {
        require_writable_outputs(*command.bake);
    }
}

/// The largest count whose share of `faces`, rounded to double, is at most `ratio`: 0.29 of 100 faces are 29, though
/// the double 0.29 is less than that. At least 1.
std::size_t faces_of_ratio(double ratio, std::size_t faces) {
    const auto share = [&](std::size_t count) { return static_cast<double>(count) / static_cast<double>(faces); };
    std::size_t count = std::min(faces, static_cast<std::size_t>(ratio * static_cast<double>(faces)) + 1);
    while (count > 1 && share(count) > ratio) {
        --count;
    }
    return count;
}

/// The options with what depends on the scan filled in. The time limit counts from the start of the program.
DecimateOptions options_for(const SimplifyCommand& command, const Scan& scan, double seconds_since_start) {
    DecimateOptions options = command.options;
    options.threads = threads_to_use(options.threads);
    if (command.ratio) {
        options.target_faces = faces_of_ratio(*command.ratio, scan.faces.size());
    }
    if (command.max_displacement) {
        const Length& length = *command.max_displacement;
        options.max_displacement = in_model_units(length, bounding_box_diagonal(scan));
    }
    if (options.time_limit) {
        options.time_limit = std::max(0.0, *options.time_limit - seconds_since_start);
    }
    return options;
}

/// The share of the way from the scan to the target; without a target, to no faces at all.
double share_done(const Progress& progress) {
    const std::size_t way = progress.input_faces - std::min(progress.target, progress.input_faces);
    return way == 0 ? 1.0 : static_cast<double>(progress.input_faces - progress.faces) / static_cast<double>(way);
}

DecimateResult decimate_with_bar(Scan& scan, DecimateOptions options, const Console& console) {
    ProgressBar bar(console.bar_output());
    options.progress = [&](const Progress& progress) {
        bar.show("decimating", share_done(progress), fmt::format("{} faces", progress.faces));
        return true;
    };
    return decimate_in_place(scan, options);
}

/// One run, step by step.
class Simplification {
public:
    explicit Simplification(const SimplifyCommand& command) : command_(command), console_(command.quiet) {}
    ExitCode run();

private:
    void read();
    void decimate_scan();
    [[nodiscard]] VerifyResult verify_staged(const AtomicFile& staged) const;
    ExitCode refuse();
    [[nodiscard]] std::vector<AtomicFile> stage_others();
    [[nodiscard]] std::optional<std::string> shortfall() const;
    void write_report();
    void note_usage();

    const SimplifyCommand& command_;
    Console console_;
    Stopwatch watch_;
    Input input_;
    DecimateResult result_;
    SimplifyRecord record_;
};

void Simplification::read() {
    input_ = read_input(command_.scan, console_);
    record_.usage.times.read = watch_.lap();
    record_.preset = command_.preset;
    record_.input = input_.record;
}

void Simplification::decimate_scan() {
    const DecimateOptions options = options_for(command_, input_.scan, record_.usage.times.read.seconds);
    result_ = decimate_with_bar(input_.scan, options, console_);
    watch_.lap();
    const DecimateStatistics& statistics = result_.statistics;
    record_.options = options;
    record_.options.time_limit = command_.options.time_limit;
    record_.usage.threads = *options.threads;
    record_.usage.times.setup = {statistics.setup_seconds, statistics.setup_cpu_seconds};
    record_.usage.times.decimate = {statistics.decimate_seconds, statistics.decimate_cpu_seconds};
    record_.statistics = statistics;
    record_.stop_reason = result_.stop_reason;
    const BaseMesh& base = result_.base;
    record_.output = {command_.base.string(), base.positions.size(), base.faces.size(),
                      count_frozen_faces(base, input_.scan)};
    record_.displacement = displacement_statistics(base, result_.correspondence, bounding_box_diagonal(input_.scan));
}

void Simplification::note_usage() {
    record_.usage.times.write += watch_.lap();
    record_.usage.peak_memory_bytes = peak_memory_bytes();
}

/// What is proven is what is on the disk: the base mesh is read back from the file that is about to get its name. What
/// OBJ has no room for, ranges and scan vertices, is taken from the result.
VerifyResult Simplification::verify_staged(const AtomicFile& staged) const {
    try {
        BaseMesh base = read_base_mesh(staged.temporary_path()).base;
        if (file_type(command_.base) == FileType::obj) {
            base.ranges = result_.base.ranges;
            base.scan_vertex = result_.base.scan_vertex;
            base.float32 = result_.base.float32;
        }
        return verify_with_bar(base, input_.scan, record_.usage.threads, console_);
    } catch (const UnreadableFile& error) {
        throw UnwritableFile(
            fmt::format("{}: what was written cannot be read back: {}", printable(command_.base), error.what()));
    } catch (const RefusedMesh& error) {
        throw std::logic_error(fmt::format("the base mesh was refused when it was read back: {}", error.what()));
    }
}

/// The report alone is written: it tells what is wrong.
ExitCode Simplification::refuse() {
    record_.output.path.clear();
    const std::vector<std::string> messages =
        violation_messages(printable(command_.base) + ", which was not written", *record_.certificate);
    write_report();
    std::ranges::for_each(messages, print_message);
    return ExitCode::not_certified;
}

void Simplification::write_report() {
    note_usage();
    if (command_.report) {
        write_text(*command_.report, json_report(record_));
    }
}

std::vector<AtomicFile> Simplification::stage_others() {
    std::vector<AtomicFile> files;
    if (command_.correspondence) {
        files.push_back(stage_correspondence(*command_.correspondence, input_.scan, result_.correspondence));
    }
    note_usage();
    if (command_.report) {
        files.push_back(stage_text(*command_.report, json_report(record_)));
    }
    return files;
}

std::optional<std::string> Simplification::shortfall() const {
    if (!record_.options.target_faces || record_.stop_reason == StopReason::target_reached) {
        return std::nullopt;
    }
    return fmt::format("the target of {} faces is not reached: {} at {} faces", *record_.options.target_faces,
                       record_.stop_reason == StopReason::time_limit ? "the time limit ended the run"
                                                                     : "every edge is refused",
                       record_.output.faces);
}

ExitCode Simplification::run() {
    require_writable_outputs(command_);
    read();
    decimate_scan();
    AtomicFile base = stage_base_mesh(command_.base, result_.base, header_comments(record_.preset, record_.options));
    record_.usage.times.write += watch_.lap();
    if (command_.verify) {
        record_.certificate = verify_staged(base);
        record_.usage.times.verify = watch_.lap();
        if (!record_.certificate->certified()) {
            return refuse();
        }
    }
    std::vector<AtomicFile> files = stage_others();
    files.push_back(std::move(base)); // the last to get its name
    const std::optional<std::string> shortfall = this->shortfall();
    const std::vector<std::string> lines = summary(record_);
    commit_all(files);
    if (shortfall) {
        print_message(*shortfall);
    }
    if (file_type(command_.base) == FileType::obj) {
        console_.note("OBJ has no room for the ranges of the displacements; PLY has");
    }
    console_.print(lines);
    return ExitCode::done;
}

} // namespace

ExitCode run(const SimplifyCommand& command) {
    const ThreadAllowance allowance(threads_to_use(command.options.threads));
    const ExitCode code = Simplification(command).run();
    return code == ExitCode::done && command.bake ? run(*command.bake) : code;
}

} // namespace foldless
