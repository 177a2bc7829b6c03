/// \file
/// From the base mesh back to the scan: does every base point reach the scan, once, from inside?
#pragma once

#include <foldless/verify/face_checks.h>
#include <foldless/verify/scan_image.h>
#include <foldless/verify/stages.h>

#include <cstddef>

namespace foldless::verification {

struct RayOptions {
    int rays_per_face = 64; ///< at least so many; the next square is taken
    bool covers_all = true; ///< the border is locked or absent, so that every base point belongs to a scan point
    bool judges = true;     ///< false: what the rays meet is proven otherwise, and only the share is wanted
};

/// A sample: of the share that a trimmed scan does not cover; and of everything where no proof is, with constant face
/// directions.
///
/// Casts the rays X + t d(alpha), t in the face's range, from points X spread over every moving base face. A ray meets
/// the scan face that it hits where the place of the hit point is in the base face; another sheet of the scan that it
/// passes within the range belongs elsewhere. Every ray must meet the scan, if the base mesh is to be covered, and none
/// may meet it from behind or at two displacements: `base_ray`. That is stricter than the truth: a sheet that belongs
/// to a face further away may pass within the range.
class BaseRays {
public:
    BaseRays(const Correspondents& all, const Meetings& meetings, const RayOptions& options)
        : all_(all), meetings_(meetings), options_(options) {}

    /// Returns the share of the base mesh's area that meets nothing, by the rays; frozen faces are covered.
    [[nodiscard]] double check(Stages& stages, double share, Findings& findings) const;

private:
    [[nodiscard]] double check_face(std::int32_t face, Findings& findings) const;

    const Correspondents& all_;
    const Meetings& meetings_;
    RayOptions options_;
};

} // namespace foldless::verification
