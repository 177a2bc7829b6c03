#include <foldless/verify/base_rays.h>

#include <foldless/verify/box_tree.h>
#include <foldless/verify/sampling.h>

#include <foldless/predicates/rounding.h>
#include <foldless/predicates/scan_normal.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace foldless::verification {
namespace {

/// A line through a base point along its direction.
struct BaseRay {
    Vec3 origin;
    Vec3 direction;
};

struct Hit {
    Sign facing; ///< positive: the ray leaves through the front
    Vec3 position;
};

/// Where the line meets the triangle, border included as far as rounding can tell: a line that passes between two
/// triangles by rounding is counted for both, and for neither only if it passes outside.
std::optional<Hit> hit(const BaseRay& ray, const ScanTriangle& q) {
    const Sign facing = ScanNormal(q).seen_along(ray.direction);
    if (facing != Sign::positive && facing != Sign::negative) {
        return std::nullopt;
    }
    const std::array<Vec3, 3> x{q[0] - ray.origin, q[1] - ray.origin, q[2] - ray.origin};
    std::array<double, 3> weight; // of the corner opposite each edge: twice the area of its projection along the ray
    for (int k = 0; k < 3; ++k) {
        const Vec3& a = x[(k + 1) % 3];
        const Vec3& b = x[(k + 2) % 3];
        const double value = ray.direction.dot(a.cross(b)) * (facing == Sign::positive ? 1 : -1);
        const double error = 12 * unit_roundoff * 2 * sum_norm(ray.direction) * max_norm(a) * max_norm(b);
        if (value < -error) {
            return std::nullopt;
        }
        weight[k] = std::max(value, 0.0);
    }
    const double sum = weight[0] + weight[1] + weight[2];
    return Hit{facing, q[0] + weight[1] / sum * (q[1] - q[0]) + weight[2] / sum * (q[2] - q[0])};
}

Box box_of(const ScanTriangle& q) {
    Box box;
    std::for_each(q.begin(), q.end(), [&](const Vec3& corner) { box.extend(corner); });
    return box;
}

/// The rays of one base face against the scan faces that meet it.
class FaceRays {
public:
    using Meets = std::span<const std::pair<std::int32_t, std::int32_t>>;

    /// \pre the face does not fold
    FaceRays(const Correspondents& all, std::int32_t face, Meets meets)
        : all_(all), face_(face), finder_(all.base.face(face).triangle, all.base.face(face).range), meets_(meets) {
        std::vector<Box> boxes;
        for (const auto& [base_face, scan_face] : meets) {
            boxes.push_back(box_of(all.triangle(scan_face)));
        }
        tree_ = BoxTree(std::move(boxes));
    }

    /// What one ray meets.
    struct Answer {
        int sheets = 0;           ///< how many displacements
        bool from_behind = false; ///< one of them at least
        std::int32_t scan_face = -1;
        Vec3 origin;
    };
    [[nodiscard]] Answer cast(const Vec3& alpha) const;

private:
    /// Through an edge or a vertex of the scan the ray meets all faces there, one sheet.
    [[nodiscard]] bool share_vertex(std::int32_t a, std::int32_t b) const;
    [[nodiscard]] Box reach(const BaseRay& ray) const;

    const Correspondents& all_;
    std::int32_t face_;
    PointFinder finder_;
    Meets meets_;
    BoxTree tree_;
};

/// The box of the ray within the range of the face, a rounding error larger.
Box FaceRays::reach(const BaseRay& ray) const {
    const Range& range = all_.base.face(face_).range;
    Box box(ray.origin + range.lo * ray.direction);
    box.extend(ray.origin + range.hi * ray.direction);
    const double size =
        max_norm(ray.origin) + std::max(std::abs(range.lo), std::abs(range.hi)) * max_norm(ray.direction);
    const Vec3 margin = Vec3::Constant(16 * unit_roundoff * size);
    return Box(box.min() - margin, box.max() + margin);
}

bool FaceRays::share_vertex(std::int32_t a, std::int32_t b) const {
    const Triangle& face = all_.scan.faces[a];
    return std::any_of(face.begin(), face.end(),
                       [&](std::int32_t vertex) { return corner_of(all_.scan.faces[b], vertex) >= 0; });
}

FaceRays::Answer FaceRays::cast(const Vec3& alpha) const {
    const BaseTriangle& triangle = all_.base.face(face_).triangle;
    const BaseRay ray{alpha[0] * triangle.v[0] + alpha[1] * triangle.v[1] + alpha[2] * triangle.v[2],
                      alpha[0] * triangle.d[0] + alpha[1] * triangle.d[1] + alpha[2] * triangle.d[2]};
    Answer answer{.origin = ray.origin};
    std::vector<std::int32_t> sheets; // a scan face of each
    tree_.visit(reach(ray), [&](std::int32_t i) {
        const std::int32_t scan_face = meets_[i].second;
        const std::optional<Hit> at = hit(ray, all_.triangle(scan_face));
        if (!at || !finder_.find(at->position)) {
            return;
        }
        if (std::none_of(sheets.begin(), sheets.end(), [&](std::int32_t f) { return share_vertex(scan_face, f); })) {
            sheets.push_back(scan_face);
        }
        answer.from_behind = answer.from_behind || at->facing == Sign::negative;
        answer.scan_face = std::max(answer.scan_face, scan_face);
    });
    answer.sheets = static_cast<int>(sheets.size());
    return answer;
}

double area(const std::array<Vec3, 3>& corners) {
    return 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
}

/// The entries of one base face.
FaceRays::Meets meets_of(const Meetings& meetings, std::int32_t face) {
    const auto by_face = [](const auto& entry, std::int32_t wanted) { return entry.first < wanted; };
    const auto begin = std::lower_bound(meetings.begin(), meetings.end(), face, by_face);
    const auto end = std::lower_bound(begin, meetings.end(), face + 1, by_face);
    return {begin, end};
}

int square_root_up(int n) {
    int side = 1;
    while (side * side < n) {
        ++side;
    }
    return side;
}

} // namespace

/// Casts the rays of a face and returns the share that meets nothing.
double BaseRays::check_face(std::int32_t face, Findings& findings) const {
    if (!all_.base.face(face).is_fold_free()) {
        return 0.0; // that is a violation already
    }
    const FaceRays rays(all_, face, meets_of(meetings_, face));
    const int side = square_root_up(options_.rays_per_face);
    int uncovered = 0;
    for (int i = 0; i < side * side; ++i) {
        const FaceRays::Answer answer = rays.cast(stratified_point(static_cast<std::uint64_t>(face), side, i));
        uncovered += answer.sheets == 0 ? 1 : 0;
        const bool is_wrong = answer.sheets > 1 || answer.from_behind || (answer.sheets == 0 && options_.covers_all);
        if (options_.judges && is_wrong) {
            findings.add({.violation = Violation::base_ray,
                          .scan_face = answer.scan_face,
                          .base_face = face,
                          .position = answer.origin});
        }
    }
    return static_cast<double>(uncovered) / (side * side);
}

double BaseRays::check(Stages& stages, double share, Findings& findings) const {
    const std::vector<std::int32_t>& moving = all_.base.moving();
    std::vector<double> uncovered(moving.size(), 0.0);
    stages.for_each(moving.size(), share, [&](std::size_t i) { uncovered[i] = check_face(moving[i], findings); });
    double uncovered_area = 0.0;
    double total_area = 0.0;
    for (std::size_t i = 0; i < moving.size(); ++i) {
        uncovered_area += uncovered[i] * area(all_.base.face(moving[i]).triangle.v);
    }
    const BaseMesh& mesh = all_.base.mesh();
    for (const Triangle& corners : mesh.faces) {
        total_area += area({mesh.positions[corners[0]], mesh.positions[corners[1]], mesh.positions[corners[2]]});
    }
    return uncovered_area / total_area;
}

} // namespace foldless::verification
