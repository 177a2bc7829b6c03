/// \file
/// Which scan faces meet at a scan vertex, and where the scan ends.
#pragma once

#include <foldless/io/scan.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foldless {

/// The incidences of a scan without defects. 12 bytes per face and 4 per vertex, 8 if the scan has a border; built in
/// linear time.
class ScanTopology {
public:
    explicit ScanTopology(const Scan& scan);

    /// The faces around a vertex, in ascending order; empty for a vertex that no face uses.
    [[nodiscard]] std::span<const std::int32_t> faces_around(std::int32_t vertex) const {
        return {faces_.data() + offsets_[vertex], faces_.data() + offsets_[vertex + 1]};
    }

    /// The vertex that follows along the border, the surface on the left, or -1 for an inner vertex.
    [[nodiscard]] std::int32_t border_successor(std::int32_t vertex) const {
        return border_successor_.empty() ? -1 : border_successor_[vertex];
    }

    /// Whether the scan has a border edge between the two vertices.
    [[nodiscard]] bool is_border_edge(std::int32_t a, std::int32_t b) const {
        return border_successor(a) == b || border_successor(b) == a;
    }

private:
    std::vector<std::uint32_t> offsets_;
    std::vector<std::int32_t> faces_;
    std::vector<std::int32_t> border_successor_; ///< empty for a closed scan
};

} // namespace foldless
