/// \file
/// Where a point of the scan lies on the base mesh.
#pragma once

#include <foldless/verify/base_faces.h>

#include <foldless/predicates/enclosure.h>
#include <foldless/predicates/sign.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace foldless::verification {

/// The walls of a face on which a point lies as far as rounding can tell: bit k for the wall opposite corner k.
using Walls = unsigned;

[[nodiscard]] constexpr Walls wall_bit(int k) {
    return 1U << static_cast<unsigned>(k);
}

/// Both walls that meet in the pillar of corner k.
[[nodiscard]] constexpr Walls walls_at_corner(int k) {
    return 7U & ~wall_bit(k);
}

/// The corner whose pillar two walls share, or -1 if the mask is not of two walls.
[[nodiscard]] int pillar_of(Walls walls);

/// An inverse displacement in the prismoid of one face.
struct FacePlace {
    std::int32_t face = -1;
    Walls walls = 0;     ///< where alpha_k is undecided
    bool decided = true; ///< false: it may as well lie outside the face or its range, or may not exist
    Enclosure at{};
};

/// A face that holds a point, with the walls of that face on which the point lies.
struct Foothold {
    std::int32_t face;
    Walls walls;
    double t = 0.0;
    double t_error = 0.0;
};

/// The place of a scan vertex: at a kept vertex, or a place in a face. A place on a wall belongs to the faces on both
/// sides, one on a pillar to all moving faces around it; it is given for one of them.
struct Place {
    std::int32_t kept = -1; ///< the base vertex that it is kept as, or -1
    FacePlace in{};         ///< if it is not kept
    [[nodiscard]] bool exists() const { return kept >= 0 || in.face >= 0; }
};

/// Whether t, known within t_error, lies in the range.
[[nodiscard]] Sign within(const Range& range, double t, double t_error);

/// The number that wall k of the face has in the moving face across it. \pre that face exists
[[nodiscard]] int wall_across(const BaseFaces& base, std::int32_t face, int k);

/// The inverse displacement of q in the face within its range, if there is one or may be one; `q_error` bounds how far
/// each coordinate of q may be from the meant point. At most one where J > 0 on the range (docs/certificate.md).
///
/// A displacement that cannot be told from an end of the range is taken as within, provided that J > 0 there too: the
/// prismoid that ends a rounding error later is as good.
[[nodiscard]] std::optional<FacePlace> place_in(const BaseFaces& base, std::int32_t face, const Vec3& q,
                                                double q_error);

/// All faces that hold the place, ascending.
/// With constant face directions places off the base surface belong to one face alone.
void footholds(const BaseFaces& base, const Place& place, std::vector<Foothold>& out);
/// All moving faces around a base vertex, ascending, at t = 0.
void footholds_at(const BaseFaces& base, std::int32_t vertex, std::vector<Foothold>& out);

/// Barycentric coordinates and displacement of a place in one of the faces that hold it.
[[nodiscard]] Enclosure coordinates_in(const BaseFaces& base, const Place& place, std::int32_t face, const Vec3& q);

/// t |d(alpha)|, model units.
[[nodiscard]] double displacement(const BaseFaces& base, const Place& place);

} // namespace foldless::verification
