/// \file
/// The prismoid of a base face over a range of displacements, prepared for questions about many points.
#pragma once

#include <foldless/predicates/batch_inversion.h>
#include <foldless/predicates/instruction_set.h>
#include <foldless/predicates/inverse_displacement.h>
#include <foldless/predicates/vector.h>

#include <array>
#include <optional>

namespace foldless {

/// All sum alpha_i (v_i + t d_i) with alpha >= 0 and t in the range.
///
///        ____        A point inside at displacement t has the height t d(alpha).normal over the triangle. That
///        brackets
///       /    /       t, because d(alpha).normal lies between those of the corners; and at such t the slice lies behind
///      /____/        three planes, each along a wall, through the furthest corner of the two slices that end the
///     /___/          bracket.
class Prismoid {
public:
    Prismoid(const BaseTriangle& triangle, Range range);

    [[nodiscard]] Range range() const { return bounds_.range; }

    /// A part of the range that holds the displacements of all solutions for q inside the triangle, or nothing if there
    /// certainly are none.
    [[nodiscard]] std::optional<Range> displacements(const Vec3& q) const;

    /// The same for a batch of points, whose ranges become those parts: bit k is set unless point k certainly has no
    /// solution inside the triangle.
    [[nodiscard]] unsigned displacements(PointBatch& points, InstructionSet set) const;

    /// The solutions for q in the part of the range that displacements() gave: all that lie inside the triangle, and
    /// perhaps others.
    [[nodiscard]] Preimages preimages(const Vec3& q, Range part) const { return inverse_.preimages(q, part); }
    /// All solutions for q, in the triangle and in the range or not.
    [[nodiscard]] Preimages preimages(const Vec3& q) const { return inverse_.preimages(q); }

    /// Solutions of batches, each in its part of the range.
    [[nodiscard]] const InverseDisplacement& inverse() const { return inverse_; }

    /// A plane along a wall.
    struct Plane {
        Vec3 outward; ///< its normal
        Vec3 level;   ///< outward.(v_c - v_0) for the corners c
        Vec3 drift;   ///< outward.d_c
        double slack;
    };

    /// What displacements() uses.
    struct Bounds {
        /// Relative slack of brackets and planes: far above their rounding (1e-15), far below the size of a face, so
        /// that culling is safe and still sharp.
        static constexpr double cull_slack = 1e-9;

        Range range;
        Vec3 origin;
        Vec3 normal;                           ///< of the base triangle at t = 0
        double per_height, per_height_at_most; ///< 1 / the largest and the smallest d_i.normal
        double unit;                           ///< of displacements: as far as the triangle is wide
        std::array<Plane, 3> planes;

        /// Whether the corners' directions all have d_i.normal > 0, without which there are no brackets.
        [[nodiscard]] bool has_brackets() const { return per_height_at_most > 0 && per_height > 0; }
    };

private:
    InverseDisplacement inverse_;
    Bounds bounds_;
};

/// Planes that leave the walls of a base face, over a range of displacements, on their outer side.
///
///        \  plane  /       What lies behind all three of them with its corners lies behind them as a whole, and meets
///        no
///     wall\       /wall    wall: where a scan face is concerned, that saves following its edges.
///          \_____/
class WallPlanes {
public:
    WallPlanes(const BaseTriangle& triangle, Range range);

    /// Bit k is set if q, a point of the prismoid over the range, is certainly behind the plane of the wall opposite
    /// corner k.
    [[nodiscard]] unsigned behind(const Vec3& q) const {
        const Vec3 p = q - origin_;
        return (p.dot(outward_[0]) < level_[0] ? 1U : 0U) | (p.dot(outward_[1]) < level_[1] ? 2U : 0U) |
               (p.dot(outward_[2]) < level_[2] ? 4U : 0U);
    }

    static constexpr unsigned all = 7;

private:
    Vec3 origin_;
    std::array<Vec3, 3> outward_;
    std::array<double, 3> level_;
};

} // namespace foldless
