/// \file
/// Which prismoids hold a point?
#pragma once

#include <foldless/verify/base_faces.h>
#include <foldless/verify/box_tree.h>

#include <foldless/predicates/prismoid_point.h>

#include <cstdint>

#include <vector>

namespace foldless::verification {

/// A point in the prismoid of a moving face.
struct FacePoint {
    std::int32_t face;
    PrismoidPoint at;
};

/// Finds the moving faces whose prismoids over their ranges hold a point. Faces that fold there hold nothing.
class PrismoidIndex {
public:
    /// The ranges must not change later.
    explicit PrismoidIndex(const BaseFaces& base);

    /// The point in every face that holds it, in ascending order of faces. Exact; refers to q.
    void points(const Vec3& q, std::vector<FacePoint>& out) const;

private:
    std::vector<std::int32_t> faces_;
    std::vector<PointFinder> finders_; ///< for each of the faces
    BoxTree tree_;
};

} // namespace foldless::verification
