#include <foldless/verify/prismoid_index.h>

#include <foldless/predicates/rounding.h>

#include <algorithm>
#include <cmath>

namespace foldless::verification {
namespace {

/// The bounding box of the six corners of a prismoid, which is in their convex hull: every point is a combination of
/// a_i(lo) and a_i(hi). Rounding moves a corner by less than four units of its terms.
Box box_of(const MovingFace& face) {
    Box box;
    double size = 0;
    for (int k = 0; k < 3; ++k) {
        if (!(face.range.lo <= face.range.hi)) {
            return Box();
        }
        for (const double t : {face.range.lo, face.range.hi}) {
            box.extend(face.triangle.corner(k, t));
            size = std::max(size, max_norm(face.triangle.v[k]) + std::abs(t) * max_norm(face.triangle.d[k]));
        }
    }
    const Vec3 margin = Vec3::Constant(4 * unit_roundoff * size);
    return Box(box.min() - margin, box.max() + margin);
}

} // namespace

PrismoidIndex::PrismoidIndex(const BaseFaces& base) : base_(base) {
    std::vector<Box> boxes;
    for (const std::int32_t face : base.moving()) {
        boxes.push_back(box_of(base.face(face)));
    }
    tree_ = BoxTree(std::move(boxes));
}

void PrismoidIndex::places(const Vec3& q, std::vector<FacePlace>& out) const {
    out.clear();
    tree_.visit(Box(q), [&](std::int32_t i) {
        if (const std::optional<FacePlace> place = place_in(base_, base_.moving()[i], q, 0.0)) {
            out.push_back(*place);
        }
    });
    std::sort(out.begin(), out.end(), [](const FacePlace& a, const FacePlace& b) { return a.face < b.face; });
}

} // namespace foldless::verification
