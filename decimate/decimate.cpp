#include <foldless/decimate/decimate.h>

#include <foldless/decimate/base_mesh_export.h>
#include <foldless/decimate/decimator.h>
#include <foldless/decimate/local_order.h>
#include <foldless/io/defects.h>
#include <foldless/predicates/default_arithmetic.h>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <memory>
#include <stdexcept>
#include <utility>

namespace foldless {
namespace {

/// Wall and CPU seconds since it was made.
class Stopwatch {
public:
    [[nodiscard]] double wall() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_).count();
    }
    [[nodiscard]] double cpu() const { return static_cast<double>(std::clock() - cpu_) / CLOCKS_PER_SEC; }

private:
    std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
    std::clock_t cpu_ = std::clock();
};

/// What is no number fails each of these.
void require_sensible(const DecimateOptions& options) {
    const auto require = [](bool condition, const char* reason) {
        if (!condition) {
            throw std::invalid_argument(reason);
        }
    };
    require(options.threads.value_or(1) >= 1, "DecimateOptions: threads is less than 1");
    require(options.time_limit.value_or(0.0) >= 0.0, "DecimateOptions: time_limit is not 0 or more");
    require(options.max_displacement.value_or(0.0) >= 0.0, "DecimateOptions: max_displacement is not 0 or more");
}

/// Of a scan in the given order. The setup is timed from the start of the stopwatch.
DecimateResult run_in_order(const Scan& scan, const LocalOrder& order, const DecimateOptions& options,
                            const Stopwatch& setup) {
    BaseSurface base(scan);
    auto decimator = std::make_unique<Decimator>(base, scan, options);
    const double setup_seconds = setup.wall();
    const double setup_cpu_seconds = setup.cpu();
    const Stopwatch loop;
    DecimateResult result;
    result.stop_reason = decimator->run();
    result.statistics = decimator->statistics();
    decimator.reset(); // what is exported needs room
    ExportedMesh left = export_base_mesh(base, order, options.directions == Directions::face, scan.float32);
    result.base = std::move(left.base);
    result.correspondence = std::move(left.correspondence);
    result.statistics.setup_seconds = setup_seconds;
    result.statistics.setup_cpu_seconds = setup_cpu_seconds;
    result.statistics.decimate_seconds = loop.wall();
    result.statistics.decimate_cpu_seconds = loop.cpu();
    return result;
}

DecimateResult run(Scan& scan, const DecimateOptions& options) {
    const Stopwatch setup;
    require_no_defects(scan);
    const LocalOrder order = local_order(scan);
    scan = in_order(std::move(scan), order);
    DecimateResult result = run_in_order(scan, order, options, setup);
    scan = as_before(std::move(scan), order);
    return result;
}

/// As many threads as are asked for; never more than the process may have.
int concurrency(const DecimateOptions& options) {
    const auto allowed =
        static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
    return std::min(options.threads.value_or(allowed), allowed);
}

} // namespace

DecimateOptions paper_options() {
    DecimateOptions options;
    options.directions = Directions::area;
    options.store_directions = false;
    options.placement = Placement::midpoint;
    options.unique_among_fold_free = true;
    options.orientation_test = true;
    options.edge_valence_limit = 12;
    return options;
}

DecimateResult decimate(const Scan& scan, const DecimateOptions& options) {
    Scan copy = scan;
    return decimate_in_place(copy, options);
}

DecimateResult decimate_in_place(Scan& scan, const DecimateOptions& options) {
    require_sensible(options);
    const DefaultArithmetic arithmetic;
    tbb::task_arena arena(concurrency(options)); // its threads compute as this one does
    return arena.execute([&] { return run(scan, options); });
}

} // namespace foldless
