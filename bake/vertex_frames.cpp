#include <foldless/bake/vertex_frames.h>

#include <cmath>
#include <utility>

namespace foldless {

namespace {

std::vector<Vec3> area_weighted_normals(const BaseMesh& base) {
    std::vector<Vec3> sums(base.positions.size(), Vec3::Zero());
    for (const auto& [a, b, c] : base.faces) {
        const Vec3& origin = base.positions[a];
        const Vec3 twice_area = (base.positions[b] - origin).cross(base.positions[c] - origin);
        for (const std::int32_t vertex : {a, b, c}) {
            sums[vertex] += twice_area;
        }
    }
    return sums;
}

/// The vector at unit length; zero stays zero. Scaled first, as the square of its length may overflow or vanish.
Vec3 unit(const Vec3& v) {
    const double scale = v.cwiseAbs().maxCoeff();
    return scale == 0 ? v : (v / scale).normalized();
}

/// The unit vector along the first that has a length.
Vec3 unit_normal(const Vec3& direction, const Vec3& fallback) {
    for (const Vec3& candidate : {direction, fallback}) {
        if (!candidate.isZero(0.0)) {
            return unit(candidate);
        }
    }
    return Vec3::UnitZ();
}

/// How the picture lies on a face.
struct PictureAxes {
    Vec3 right;         ///< along growing u, any length
    double orientation; ///< 1 as it is, -1 mirrored, 0 without area
};

PictureAxes picture_axes(const std::array<Vec3, 3>& p, const std::array<Eigen::Vector2f, 3>& uv) {
    const Eigen::Vector2d b = uv[1].cast<double>() - uv[0].cast<double>();
    const Eigen::Vector2d c = uv[2].cast<double>() - uv[0].cast<double>();
    // Seen from the front, an unmirrored picture turns the way of the face when v grows upwards; here it grows
    // downwards.
    const double twice_area = b.y() * c.x() - b.x() * c.y();
    const double orientation = twice_area > 0 ? 1.0 : twice_area < 0 ? -1.0 : 0.0;
    // The linear map that takes b to p1 - p0 and c to p2 - p0, at (1, 0): Cramer's rule, with the sign of its divisor.
    return {orientation * (b.y() * (p[2] - p[0]) - c.y() * (p[1] - p[0])), orientation};
}

double angle_at(const Vec3& corner, const Vec3& next, const Vec3& last) {
    const Vec3 a = next - corner;
    const Vec3 b = last - corner;
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

// What is left of a unit vector when its part along another is taken away has an error of about 1e-16: where less than
// this is left, its direction means nothing.
constexpr double least_across = 1e-12;

/// `v` without its part along the unit vector `normal`, at unit length; zero if nothing is left.
Vec3 unit_across(const Vec3& v, const Vec3& normal) {
    const Vec3 along = unit(v);
    const Vec3 across = along - along.dot(normal) * normal;
    return across.norm() < least_across ? Vec3(Vec3::Zero()) : Vec3(across.normalized());
}

/// Sums over the faces around each split vertex: of right in the picture, and of its orientation.
class TangentSums {
public:
    TangentSums(const BaseMesh& base, const SplitVertices& split, const std::vector<Vec3>& normals)
        : base_(base), split_(split), normals_(normals), sums_(split.uv.size(), Eigen::Vector4d::Zero()) {}

    void add_face(const std::array<std::uint32_t, 3>& face) {
        const std::array<Vec3, 3> p{position(face[0]), position(face[1]), position(face[2])};
        const PictureAxes axes = picture_axes(p, {split_.uv[face[0]], split_.uv[face[1]], split_.uv[face[2]]});
        for (std::size_t i = 0; i < 3; ++i) {
            const double weight = angle_at(p[i], p[(i + 1) % 3], p[(i + 2) % 3]);
            sums_[face[i]].head<3>() += weight * unit_across(axes.right, normals_[split_.base_vertex[face[i]]]);
            sums_[face[i]].w() += weight * axes.orientation;
        }
    }

    std::vector<Eigen::Vector4d> take() { return std::move(sums_); }

private:
    [[nodiscard]] const Vec3& position(std::uint32_t vertex) const {
        return base_.positions[split_.base_vertex[vertex]];
    }

    const BaseMesh& base_;
    const SplitVertices& split_;
    const std::vector<Vec3>& normals_;
    std::vector<Eigen::Vector4d> sums_;
};

Eigen::Vector4d tangent(const Eigen::Vector4d& sum, const Vec3& normal) {
    Eigen::Vector4d result;
    const Vec3 across = unit_across(sum.head<3>(), normal);
    if (across.isZero(0.0)) {
        result << normal.unitOrthogonal(), 1.0;
    } else {
        result << across, (sum.w() < 0 ? -1.0 : 1.0);
    }
    return result;
}

} // namespace

std::vector<Vec3> vertex_normals(const BaseMesh& base) {
    std::vector<Vec3> normals = area_weighted_normals(base);
    for (std::size_t vertex = 0; vertex < normals.size(); ++vertex) {
        const Vec3 direction = base.directions.empty() ? Vec3(Vec3::Zero()) : base.directions[vertex];
        normals[vertex] = unit_normal(direction, normals[vertex]);
    }
    return normals;
}

std::vector<Eigen::Vector4d> vertex_tangents(const BaseMesh& base, const SplitVertices& split,
                                             const std::vector<Vec3>& normals) {
    TangentSums sums(base, split, normals);
    for (const auto& face : split.faces) {
        sums.add_face(face);
    }
    std::vector<Eigen::Vector4d> tangents = sums.take();
    for (std::size_t vertex = 0; vertex < tangents.size(); ++vertex) {
        tangents[vertex] = tangent(tangents[vertex], normals[split.base_vertex[vertex]]);
    }
    return tangents;
}

} // namespace foldless
