#include <foldless/verify/prismoid_index.h>

#include <foldless/predicates/rounding.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace foldless::verification {
namespace {

/// The bounding box of the six corners of a prismoid, which is in their convex hull: every point is a combination of
/// a_i(lo) and a_i(hi). Rounding moves a corner by less than four units of its terms.
Box box_of(const MovingFace& face) {
    Box box;
    double size = 0;
    for (int k = 0; k < 3; ++k) {
        for (const double t : {face.range.lo, face.range.hi}) {
            box.extend(face.triangle.corner(k, t));
            size = std::max(size, max_norm(face.triangle.v[k]) + std::abs(t) * max_norm(face.triangle.d[k]));
        }
    }
    const Vec3 margin = Vec3::Constant(4 * unit_roundoff * size);
    return Box(box.min() - margin, box.max() + margin);
}

} // namespace

PrismoidIndex::PrismoidIndex(const BaseFaces& base) {
    std::vector<Box> boxes;
    for (const std::int32_t f : base.moving()) {
        const MovingFace& face = base.face(f);
        if (face.is_fold_free()) {
            faces_.push_back(f);
            finders_.emplace_back(face.triangle, face.range);
            boxes.push_back(box_of(face));
        }
    }
    tree_ = BoxTree(std::move(boxes));
}

void PrismoidIndex::points(const Vec3& q, std::vector<FacePoint>& out) const {
    out.clear();
    tree_.visit(Box(q), [&](std::int32_t i) {
        if (const std::optional<PrismoidPoint> at = finders_[i].find(q)) {
            out.push_back({faces_[i], *at});
        }
    });
    std::sort(out.begin(), out.end(), [](const FacePoint& a, const FacePoint& b) { return a.face < b.face; });
}

} // namespace foldless::verification
