/// \file
/// A hierarchy of boxes: which of many boxes meet a given one?
#pragma once

#include <foldless/predicates/vector.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace foldless::verification {

using Box = Eigen::AlignedBox3d;

/// A balanced binary tree over boxes, split at the median of their centres along the widest axis. The same boxes give
/// the same tree, and boxes are visited in the order of the tree. Empty boxes are left out.
class BoxTree {
public:
    BoxTree() = default;
    /// Time O(n log n).
    explicit BoxTree(std::vector<Box> boxes);

    /// Calls visit(i) for every box i that meets `query`, borders included.
    template <class Visit>
    void visit(const Box& query, Visit visit) const;

private:
    struct Node {
        Box box;
        std::int32_t second = -1; ///< the second child; the first follows its parent. -1: a leaf
        std::int32_t begin = 0;   ///< of the leaf's boxes in order_
        std::int32_t end = 0;
    };
    /// Boxes in a leaf: a few tests cost less than a node.
    static constexpr std::int32_t leaf_size = 4;

    void build(std::int32_t begin, std::int32_t end);

    std::vector<Box> boxes_;
    std::vector<std::int32_t> order_;
    std::vector<Node> nodes_;
};

template <class Visit>
void BoxTree::visit(const Box& query, Visit visit) const {
    if (nodes_.empty()) {
        return;
    }
    std::int32_t stack[64]; // a balanced tree over 2^31 boxes is less deep
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const std::int32_t at = stack[--depth];
        const Node& node = nodes_[at];
        if (!node.box.intersects(query)) {
            continue;
        }
        if (node.second >= 0) {
            stack[depth++] = node.second;
            stack[depth++] = at + 1;
            continue;
        }
        for (std::int32_t k = node.begin; k < node.end; ++k) {
            if (boxes_[order_[k]].intersects(query)) {
                visit(order_[k]);
            }
        }
    }
}

} // namespace foldless::verification
