#include <foldless/verify/box_tree.h>

#include <algorithm>

namespace foldless::verification {

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        if (!boxes_[i].isEmpty()) {
            order_.push_back(static_cast<std::int32_t>(i));
        }
    }
    if (!order_.empty()) {
        build(0, static_cast<std::int32_t>(order_.size()));
    }
}

void BoxTree::build(std::int32_t begin, std::int32_t end) {
    const std::size_t at = nodes_.size();
    nodes_.emplace_back();
    Box box;
    for (std::int32_t k = begin; k < end; ++k) {
        box.extend(boxes_[order_[k]]);
    }
    nodes_[at].box = box;
    nodes_[at].begin = begin;
    nodes_[at].end = end;
    if (end - begin <= leaf_size) {
        return;
    }
    int axis = 0;
    box.sizes().maxCoeff(&axis);
    const auto before = [&](std::int32_t a, std::int32_t b) {
        const double centre_a = boxes_[a].min()[axis] + boxes_[a].max()[axis];
        const double centre_b = boxes_[b].min()[axis] + boxes_[b].max()[axis];
        return centre_a < centre_b || (centre_a == centre_b && a < b);
    };
    const std::int32_t middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, before);
    build(begin, middle);
    nodes_[at].second = static_cast<std::int32_t>(nodes_.size());
    build(middle, end);
}

} // namespace foldless::verification
