/// \file
/// Normals of scan triangles in few bytes.
#pragma once

#include <foldless/predicates/scan_normal.h>

#include <array>
#include <cstdint>

namespace foldless {

/// The direction of a normal, to a rounding of 1.5e-5. 6 bytes.
class CoarseNormal {
public:
    /// Of no triangle.
    CoarseNormal() = default;
    /// What has no area, or hardly one, has a coarse normal that decides no sign.
    explicit CoarseNormal(const ScanNormal& normal);

    /// The same times a positive number, with a bound on its error.
    [[nodiscard]] ScanNormal value() const { return {Vec3(parts_[0], parts_[1], parts_[2]), largest_error}; }

private:
    static constexpr double scale = 32767; ///< of a component of a normal of length 1
    /// Half for the nearest integer. The rest is for the rounding of the normal and of a dot product with this one, up
    /// to 2^-30 of the length.
    static constexpr double largest_error = 0.501;

    std::array<std::int16_t, 3> parts_{};
};

} // namespace foldless
