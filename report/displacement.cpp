#include <foldless/report/displacement.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldless {

namespace {

/// The interpolated direction at a place in a face.
Vec3 direction_at(const BaseMesh& base, std::int32_t face, const Vec3& alpha) {
    if (!base.face_directions.empty()) {
        return base.face_directions[face];
    }
    Vec3 direction = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        direction += alpha[k] * base.directions[base.faces[face][k]];
    }
    return direction;
}

} // namespace

DisplacementStatistics with_share_of_diagonal(DisplacementStatistics statistics, double diagonal) {
    const double largest = std::max(std::abs(statistics.min), std::abs(statistics.max));
    statistics.max_relative_to_diagonal = diagonal > 0.0 ? largest / diagonal : 0.0;
    return statistics;
}

DisplacementStatistics displacement_statistics(const BaseMesh& base, const Correspondence& correspondence,
                                               double diagonal) {
    DisplacementStatistics statistics{std::numeric_limits<double>::infinity(),
                                      -std::numeric_limits<double>::infinity()};
    double sum_of_squares = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < correspondence.base_face.size(); ++i) {
        const std::int32_t face = correspondence.base_face[i];
        if (face < 0) {
            continue;
        }
        const double displacement = correspondence.t[i] * direction_at(base, face, correspondence.alpha[i]).norm();
        statistics.min = std::min(statistics.min, displacement);
        statistics.max = std::max(statistics.max, displacement);
        sum_of_squares += displacement * displacement;
        ++count;
    }
    if (count == 0) {
        return {};
    }
    statistics.rms = std::sqrt(sum_of_squares / static_cast<double>(count));
    return with_share_of_diagonal(statistics, diagonal);
}

} // namespace foldless
