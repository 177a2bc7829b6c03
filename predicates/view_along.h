/// \file
/// Which way round two vectors follow each other, seen along a direction: what a kept vertex sees of the edges that
/// leave it, along its pillar.
#pragma once

#include <foldless/predicates/rounding.h>
#include <foldless/predicates/sign.h>
#include <foldless/predicates/vector.h>

#include <algorithm>
#include <cmath>

namespace foldless {

/// The plane that is left of space when a direction d is looked along, tip towards the eye. A vector is projected once
/// and then compared with many.
class ViewAlong {
public:
    /// A projected vector.
    struct Seen {
        double x, y;
        double size; ///< the largest component of the vector itself
    };

    explicit ViewAlong(const Vec3& d) {
        d.cwiseAbs().maxCoeff(&depth_);
        across_ = (depth_ + 1) % 3;
        up_ = (depth_ + 2) % 3;
        slope_across_ = d[across_] / d[depth_];
        slope_up_ = d[up_] / d[depth_];
        towards_eye_ = std::copysign(1.0, d[depth_]);
    }

    /// e - (e_k / d_k) d without its component k, the largest of d; a view from below is mirrored.
    [[nodiscard]] Seen see(const Vec3& e) const {
        return {e[across_] - e[depth_] * slope_across_, towards_eye_ * (e[up_] - e[depth_] * slope_up_), max_norm(e)};
    }

private:
    int depth_ = 0;
    int across_, up_;
    double slope_across_, slope_up_; ///< at most 1
    double towards_eye_;
};

/// The sign of (a x b).d: positive if b follows a counter-clockwise by less than half a turn. Both must be of one view,
/// and each vector may itself be off by one rounding of each component, as a difference of positions is. Where it is
/// undecided, seen_along() decides it exactly, for d and the triangle that the two vectors span.
[[nodiscard]] inline Sign turn(const ViewAlong::Seen& a, const ViewAlong::Seen& b) {
    // (a x b).d = |d_k| (a_x b_y - a_y b_x). With u the rounding and A, B the sizes: a component of a is off by 6 u A
    // (one of the vector, two of the product and its slope, on two terms, one of the difference) and no larger than 2
    // A. So each product is off by 24 u AB and 4 u AB more for its own rounding, the difference by 8 u AB: 64 u AB in
    // all, 70 with the second order.
    const bool counted = std::min(a.size, b.size) >= least_length;
    return counted ? sign_within(a.x * b.y - a.y * b.x, 70 * unit_roundoff * a.size * b.size) : Sign::undecided;
}

/// A vertex and its displacement direction: at displacement t it is at v + t d.
struct DisplacedVertex {
    Vec3 v;
    Vec3 d;
};

/// The sign of ((a - centre) x (b - centre)).d at displacement t, d being the direction of the centre, exactly: which
/// way round b follows a around the pillar. Undecided only if something is not finite. (docs/certificate.md, C1 and K)
[[nodiscard]] Sign turn_at(const DisplacedVertex& centre, const DisplacedVertex& a, const DisplacedVertex& b, double t);

} // namespace foldless
