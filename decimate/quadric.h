/// \file
/// Error quadrics: the sum of squared distances to a set of planes.
#pragma once

#include <foldless/decimate/pool.h>
#include <foldless/decimate/scan_topology.h>
#include <foldless/io/scan.h>
#include <foldless/predicates/vector.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace foldless {

/// x^T A x - 2 b^T x + c, the weighted squared distance of x to planes, relative to a fixed origin near the model
/// (Garland & Heckbert 1997).
class Quadric {
public:
    /// Adds the plane through p with the given normal, weighted by the square of its length.
    void add_plane(const Vec3& p, const Vec3& normal);
    Quadric& operator+=(const Quadric& other);

    /// The error at x.
    [[nodiscard]] double operator()(const Vec3& x) const;

    /// The sum of the weights: the error of a point that is one unit away from every plane.
    [[nodiscard]] double weight() const { return xx_ + yy_ + zz_; }

    /// The point of least error, if it is well determined.
    [[nodiscard]] std::optional<Vec3> minimiser() const;

private:
    double xx_ = 0, xy_ = 0, xz_ = 0, yy_ = 0, yz_ = 0, zz_ = 0;
    Vec3 b_ = Vec3::Zero();
    double c_ = 0;
};

/// The quadric of each vertex while vertices merge. At first it has the planes of the scan faces around the scan
/// vertex, weighted by twice their areas, relative to `origin`; those are added up when they are asked for, which is
/// seldom beside all else that is asked about an edge. Only vertices that have merged, at most a third of the vertices
/// at once, take 80 bytes.
class VertexQuadrics {
public:
    /// The scan and its topology must outlive the quadrics.
    VertexQuadrics(const Scan& scan, const ScanTopology& topology, const Vec3& origin);

    /// Time linear in the scan faces around the vertex.
    [[nodiscard]] Quadric operator[](std::int32_t v) const;
    /// Adds the quadric of the vertex that goes to that of the one that stays.
    void merge(std::int32_t stays, std::int32_t gone);

private:
    [[nodiscard]] Quadric of_scan_vertex(std::int32_t v) const;
    void give_back_room();

    const Scan* scan_;
    const ScanTopology* topology_;
    Vec3 origin_;
    std::vector<std::int32_t> index_; ///< per vertex: in merged_, or -1
    Pool<Quadric> merged_;
};

} // namespace foldless
