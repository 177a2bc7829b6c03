/// \file
/// Inverse displacements of several points at a time.
#pragma once

#include <foldless/predicates/instruction_set.h>
#include <foldless/predicates/inverse_displacement.h>

#include <array>

namespace foldless {

/// Up to sixteen points, each with the range in which its displacements are looked for. Apart by coordinate, as the
/// lanes of a kernel take them.
struct PointBatch {
    static constexpr int capacity = 16; ///< as many lanes as keep the processor busy while one waits for a division
    using Row = std::array<double, capacity>;

    alignas(64) Row x{}; ///< model units
    alignas(64) Row y{};
    alignas(64) Row z{};
    alignas(64) Row lo{}; ///< displacements
    alignas(64) Row hi{};
    int size = 0;

    [[nodiscard]] Vec3 point(int k) const { return {x[k], y[k], z[k]}; }
    [[nodiscard]] Range range(int k) const { return {lo[k], hi[k]}; }

    /// \pre size < capacity
    void push_back(const Vec3& q, const Range& range) {
        x[size] = q[0];
        y[size] = q[1];
        z[size] = q[2];
        lo[size] = range.lo;
        hi[size] = range.hi;
        ++size;
    }
};

/// What a kernel says of a batch. Bit k of a mask is that of point k; a point in neither mask is not decided. What lies
/// beyond the size of the batch has no meaning.
struct BatchAnswers {
    alignas(64) std::array<PointBatch::Row, 3> alpha;
    alignas(64) PointBatch::Row t;
    alignas(64) PointBatch::Row slope;
    unsigned none;   ///< no solution in the range
    unsigned single; ///< exactly the solution that is listed
};

/// The solutions of a batch of points in one base triangle: bit for bit those of InverseDisplacement::preimages(q,
/// range), whatever the instruction set.
///
/// The points for which the cubic certainly rises over the range are solved side by side, each by the operations of the
/// scalar code in their order, iterations included: a point that is done keeps its root while the others go on. What is
/// not as plain (other roots near, a slice that may be degenerate, numbers that overflow) is left to the scalar code.
class BatchInversion {
public:
    /// Refers to both.
    BatchInversion(const InverseDisplacement& inverse, const PointBatch& points, InstructionSet set);

    /// Bit k is set unless point k certainly has no solution in its range.
    [[nodiscard]] unsigned candidates() const { return ((1U << points_->size) - 1U) & ~answers_.none; }

    /// Bit k is set if point k has exactly one solution, which preimage() gives.
    [[nodiscard]] unsigned single() const { return ((1U << points_->size) - 1U) & answers_.single; }

    /// The solution of point k. \pre its bit is set in single()
    [[nodiscard]] Preimage preimage(int k) const {
        return {Vec3(answers_.alpha[0][k], answers_.alpha[1][k], answers_.alpha[2][k]), answers_.t[k],
                answers_.slope[k]};
    }

    /// All solutions of point k. \pre 0 <= k < size of the batch
    [[nodiscard]] Preimages preimages(int k) const;

private:
    [[nodiscard]] Preimages decided(int k) const;

    const InverseDisplacement* inverse_;
    const PointBatch* points_;
    BatchAnswers answers_;
};

} // namespace foldless
