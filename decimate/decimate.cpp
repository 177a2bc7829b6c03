#include <foldless/decimate/decimate.h>

#include <foldless/decimate/base_mesh_export.h>
#include <foldless/decimate/decimator.h>
#include <foldless/decimate/local_order.h>
#include <foldless/io/defects.h>
#include <foldless/predicates/default_arithmetic.h>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <chrono>
#include <ctime>
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

DecimateResult run(const Scan& scan, const DecimateOptions& options) {
    const Stopwatch setup;
    require_no_defects(scan);
    const LocalOrder order = local_order(scan);
    const Scan ordered = in_order(scan, order);
    Decimator decimator(ordered, options);
    const double setup_seconds = setup.wall();
    const double setup_cpu_seconds = setup.cpu();
    const Stopwatch loop;
    DecimateResult result;
    result.stop_reason = decimator.run();
    result.statistics = decimator.statistics();
    ExportedMesh left = export_base_mesh(decimator.base(), order, options.directions == Directions::face, scan.float32);
    result.base = std::move(left.base);
    result.correspondence = std::move(left.correspondence);
    result.statistics.setup_seconds = setup_seconds;
    result.statistics.setup_cpu_seconds = setup_cpu_seconds;
    result.statistics.decimate_seconds = loop.wall();
    result.statistics.decimate_cpu_seconds = loop.cpu();
    return result;
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
    const DefaultArithmetic arithmetic;
    std::optional<tbb::global_control> threads;
    if (options.threads) {
        threads.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(*options.threads));
    }
    tbb::task_arena arena; // its threads compute as this one does
    return arena.execute([&] { return run(scan, options); });
}

} // namespace foldless
