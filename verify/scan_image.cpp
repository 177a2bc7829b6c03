#include <foldless/verify/scan_image.h>

#include <foldless/predicates/pillar.h>

#include <algorithm>

namespace foldless::verification {
namespace {

using Edge = std::pair<std::int32_t, std::int32_t>;

Edge edge_between(std::int32_t a, std::int32_t b) {
    return {std::min(a, b), std::max(a, b)};
}

template <class T>
bool contains(const std::vector<T>& values, const T& value) {
    return std::find(values.begin(), values.end(), value) != values.end();
}

/// Follows the border of one scan triangle.
class Border {
public:
    Border(const Correspondents& all, std::int32_t scan_face, ScanImage& image)
        : all_(all), corners_(all.scan.faces[scan_face]), image_(image) {}

    void follow() {
        for (int k = 0; k < 3; ++k) {
            image_.edge_is_followed[k] = follow_edge(corners_[k], corners_[(k + 1) % 3]);
            pass_corner(k);
        }
        std::sort(image_.met.begin(), image_.met.end());
        image_.met.erase(std::unique(image_.met.begin(), image_.met.end()), image_.met.end());
    }

    /// The base edges crossed an odd number of times.
    [[nodiscard]] const std::vector<Edge>& odd() const { return odd_; }

private:
    bool follow_edge(std::int32_t a, std::int32_t b) {
        if (all_.association.is_base_edge(a, b)) {
            return true;
        }
        // Both faces of an edge follow it from the same end.
        const std::optional<std::vector<WallCrossing>> crossings =
            all_.association.follow(std::min(a, b), std::max(a, b));
        if (!crossings) {
            return false;
        }
        for (const WallCrossing& crossing : *crossings) {
            const Triangle& corners = all_.base.face(crossing.face).corners;
            toggle(corners[(crossing.wall + 1) % 3], corners[(crossing.wall + 2) % 3]);
            image_.met.push_back(crossing.face);
            image_.met.push_back(crossing.next_face);
            image_.crossings.push_back(crossing);
        }
        return true;
    }

    void pass_corner(int k) {
        const Place& place = all_.association.place(corners_[k]);
        const PillarStar* const star = all_.association.star(corners_[k]);
        if (star == nullptr) {
            image_.met.push_back(place.face);
            return;
        }
        std::vector<std::int32_t> spokes;
        star->between(corners_[(k + 1) % 3], corners_[(k + 2) % 3], spokes, image_.met);
        for (const std::int32_t spoke : spokes) {
            toggle(place.pillar, spoke);
        }
    }

    void toggle(std::int32_t a, std::int32_t b) {
        const Edge edge = edge_between(a, b);
        const auto found = std::find(odd_.begin(), odd_.end(), edge);
        if (found == odd_.end()) {
            odd_.push_back(edge);
        } else {
            odd_.erase(found);
        }
    }

    const Correspondents& all_;
    const Triangle& corners_;
    ScanImage& image_;
    std::vector<Edge> odd_;
};

/// Floods the base vertices inside one scan triangle.
class Inside {
public:
    Inside(const Correspondents& all, std::int32_t scan_face, const std::vector<Edge>& odd)
        : base_(all.base), triangle_(all.triangle(scan_face)), odd_(odd) {}

    std::optional<std::vector<std::int32_t>> find() {
        for (const Edge& edge : odd_) {
            for (const std::int32_t end : {edge.first, edge.second}) {
                if (!contains(inside_, end) && is_pierced(end)) {
                    inside_.push_back(end);
                }
            }
        }
        for (std::size_t i = 0; i < inside_.size(); ++i) {
            if (!spread(inside_[i])) {
                return std::nullopt;
            }
        }
        // Exactly one end of each odd edge; both or none of every other follows from the spreading.
        const bool fits = std::all_of(odd_.begin(), odd_.end(), [&](const Edge& edge) {
            return contains(inside_, edge.first) != contains(inside_, edge.second);
        });
        return fits ? std::optional(std::move(inside_)) : std::nullopt;
    }

private:
    [[nodiscard]] DisplacedVertex displaced(std::int32_t vertex) const {
        return {base_.mesh().positions[vertex], base_.mesh().directions[vertex]};
    }

    [[nodiscard]] bool is_pierced(std::int32_t vertex) const {
        return !base_.is_kept(vertex) && pierces(displaced(vertex), triangle_) == Sign::positive;
    }

    /// From a vertex inside over all its edges; false if it may not be inside, or one that must be inside is not
    /// pierced.
    bool spread(std::int32_t vertex) {
        const auto around = base_.adjacency().faces_around(vertex);
        for (const std::int32_t face : around) {
            if (!base_.is_moving(face) || !base_.face(face).is_fold_free() ||
                !meets_plane_within(displaced(vertex), triangle_, base_.face(face).range)) {
                return false;
            }
            const MovingFace& moving = base_.face(face);
            const int k = corner_of(moving.corners, vertex);
            if (moving.across[(k + 1) % 3] < 0 || moving.across[(k + 2) % 3] < 0) {
                return false; // on the border
            }
            const std::int32_t next = moving.corners[(k + 1) % 3]; // every edge is the first of one face
            if (contains(odd_, edge_between(vertex, next)) || contains(inside_, next)) {
                continue;
            }
            if (!is_pierced(next)) {
                return false;
            }
            inside_.push_back(next);
        }
        return true;
    }

    const BaseFaces& base_;
    ScanTriangle triangle_;
    const std::vector<Edge>& odd_;
    std::vector<std::int32_t> inside_;
};

} // namespace

ScanTriangle Correspondents::triangle(std::int32_t scan_face) const {
    const Triangle& face = scan.faces[scan_face];
    return {scan.positions[face[0]], scan.positions[face[1]], scan.positions[face[2]]};
}

bool Correspondents::has_places(std::int32_t scan_face) const {
    const Triangle& face = scan.faces[scan_face];
    return association.has_place(face[0]) && association.has_place(face[1]) && association.has_place(face[2]);
}

ScanImage image_of(const Correspondents& all, std::int32_t scan_face) {
    ScanImage image;
    Border border(all, scan_face, image);
    border.follow();
    const auto& followed = image.edge_is_followed;
    if (!followed[0] || !followed[1] || !followed[2]) {
        return image;
    }
    if (border.odd().empty()) {
        image.inside.emplace();
        return image;
    }
    image.inside = Inside(all, scan_face, border.odd()).find();
    if (image.inside) {
        for (const std::int32_t vertex : *image.inside) {
            const auto around = all.base.adjacency().faces_around(vertex);
            image.met.insert(image.met.end(), around.begin(), around.end());
        }
        std::sort(image.met.begin(), image.met.end());
        image.met.erase(std::unique(image.met.begin(), image.met.end()), image.met.end());
    }
    return image;
}

} // namespace foldless::verification
