/// \file
/// Which prismoids hold a point?
#pragma once

#include <foldless/verify/box_tree.h>
#include <foldless/verify/place.h>

#include <vector>

namespace foldless::verification {

/// Finds the moving faces whose prismoids over their ranges may hold a point.
class PrismoidIndex {
public:
    explicit PrismoidIndex(const BaseFaces& base);

    /// The places of the point, one or none for each face, in ascending order of faces.
    void places(const Vec3& q, std::vector<FacePlace>& out) const;

private:
    const BaseFaces& base_;
    BoxTree tree_;
};

} // namespace foldless::verification
