/// \file
/// The image of a piece of a scan line on one base triangle, and whether two such arcs certainly do not meet.
#pragma once

#include <foldless/predicates/prismoid_point.h>
#include <foldless/predicates/vector.h>

#include <array>
#include <cstdint>
#include <memory>

namespace foldless {

/// A curve of barycentric coordinates: where the lift of a scan line lies on one base triangle, from one point of its
/// prismoid to another. It is a conic; it is enclosed by boxes, which shrink as the line is halved.
///
/// \pre J > 0 on the displacements between both ends, and the lift between them is in the prismoid (condition E)
class ImageArc {
public:
    /// Whether an end is that of the line; otherwise the line comes in, or goes out, through the wall on which that
    /// lies.
    struct End {
        PrismoidPoint at{};
        bool is_of_line = false;
    };

    /// Copies the triangle; refers to the points of the line.
    ImageArc(const BaseTriangle& triangle, const ScanLine& line, const End& from, const End& to);
    ImageArc(ImageArc&&) noexcept;
    ImageArc& operator=(ImageArc&&) noexcept;
    ~ImageArc();

    /// Bounds of alpha_k.
    [[nodiscard]] Range bounds(int k) const;
    /// Parameters of the line, from 0 to 1, that are on the arc for certain: those between these; none if lo >= hi.
    [[nodiscard]] Range parameters() const;

    /// For the sources of this layer.
    class Curve;
    [[nodiscard]] const Curve& curve() const { return *curve_; }

private:
    std::unique_ptr<Curve> curve_;
};

/// At which end of an arc a point is that it shares with another arc.
enum class SharedEnd { none, from, to };

/// The point that two arcs share, if they do: at these ends.
struct SharedPoint {
    SharedEnd a = SharedEnd::none;
    SharedEnd b = SharedEnd::none;
};

/// What two arcs share whose ends are these vertices, from and to, or on a wall (-1).
[[nodiscard]] SharedPoint shared_point(const std::array<std::int32_t, 2>& a, const std::array<std::int32_t, 2>& b);

/// Whether two arcs on one triangle certainly have no point in common, but for the one that they share. Boxes around
/// pieces of both are separated; around the shared point, the cones of their directions. False if they meet, or if they
/// come so close that the pieces have no end.
[[nodiscard]] bool are_apart(const ImageArc& a, const ImageArc& b, const SharedPoint& shared);

/// A wall between two triangles: opposite corner `a` of the one and corner `b` of the other, which runs along it the
/// other way.
struct CommonWall {
    int a;
    int b;
};

/// The same for arcs on two neighbouring triangles, which can meet on the common wall only.
[[nodiscard]] bool are_apart_on_wall(const ImageArc& a, const ImageArc& b, const CommonWall& wall,
                                     const SharedPoint& shared);

/// Whether the line p + tau d(alpha) through the point at s of the arc's line, where alpha is its place, certainly
/// misses the scan triangle as long as the displacement is in the range. \pre s is strictly within arc.parameters()
[[nodiscard]] bool certainly_misses(const ImageArc& arc, double s, const ScanTriangle& triangle, Range range);

} // namespace foldless
