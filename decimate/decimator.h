/// \file
/// The decimation loop.
#pragma once

#include <foldless/decimate/answers_ahead.h>
#include <foldless/decimate/base_surface.h>
#include <foldless/decimate/collapse.h>
#include <foldless/decimate/decimate.h>
#include <foldless/decimate/edge_asker.h>
#include <foldless/decimate/edge_queue.h>
#include <foldless/decimate/prepared_scan.h>
#include <foldless/decimate/quadric.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

namespace foldless {

/// One decimation, from the scan as its own base mesh to the last collapse.
///
/// Edges are asked without touching anything; commit() is the only function that writes to the base mesh.
class Decimator {
public:
    /// Sets everything up: connectivity, directions, vertices that no direction serves, quadrics, the queue.
    /// The base mesh must be the scan itself.
    Decimator(BaseSurface& base, const Scan& scan, const DecimateOptions& options);

    /// Collapses until the target, the last edge, the time limit or the user stops it.
    [[nodiscard]] StopReason run();

    [[nodiscard]] const DecimateStatistics& statistics() const { return statistics_; }
    [[nodiscard]] std::size_t face_count() const { return face_count_; }

private:
    void find_directions();
    void freeze_unserved(const std::vector<char>& unserved);
    void freeze_faces_at(std::int32_t v, std::vector<char>& frozen);

    void count(const EdgeAnswer& answer);
    void commit(const EdgeAnswer& answer);
    void close_gaps();
    [[nodiscard]] std::optional<StopReason> interrupted();

    const Scan* scan_;
    DecimateOptions options_;
    PreparedScan prepared_;
    BaseSurface& base_;
    std::vector<Mobility> mobility_;
    VertexQuadrics quadrics_;
    EdgeQueue queue_;
    std::size_t face_count_;
    DecimateStatistics statistics_;
    std::chrono::steady_clock::time_point start_;
    std::size_t asked_since_check_ = 0;
    std::optional<AnswersAhead> answers_;
    std::vector<std::int32_t> edges_; ///< changed by a collapse
};

} // namespace foldless
