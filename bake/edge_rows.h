/// \file
/// Which samples of a row of a lattice lie within the image of a scan face, but for rounding.
#pragma once

#include <foldless/predicates/vector.h>

#include <Eigen/Core>

#include <array>

namespace foldless {

/// An interval of alpha_1; empty if it ends before it begins.
struct Span {
    double lo;
    double hi;

    [[nodiscard]] bool empty() const { return !(lo <= hi); }
};

/// For a scan edge from a to b, det(a - X, b - X, d) on the lines X + t d(alpha) of a base face is a quadratic form in
/// alpha, and along a row of samples, where alpha_2 is constant, a quadratic in alpha_1. The three of a scan face are
/// not negative where the lines pass through it from behind: its image has sides that are arcs of conics.
class EdgeRows {
public:
    EdgeRows(const BaseTriangle& triangle, const ScanTriangle& scan);

    /// A part of `within` beyond which no sample of the row lies in the image: at most as wide as the image there,
    /// rounding apart, unless a side of it bends twice within the row.
    [[nodiscard]] Span narrowed(Span within, double alpha2) const;

private:
    struct Form {
        Eigen::Matrix3d matrix;
        Vec3 along;    ///< the matrix times the step along a row
        double bend;   ///< the step times that
        double margin; ///< of rounding
    };
    std::array<Form, 3> forms_;
};

} // namespace foldless
