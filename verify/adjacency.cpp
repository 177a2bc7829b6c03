#include <foldless/verify/adjacency.h>

namespace foldless::verification {

Adjacency::Adjacency(std::size_t vertices, const std::vector<Triangle>& faces)
    : faces_(faces), first_(vertices + 1, 0), around_(3 * faces.size()), neighbours_(faces.size()) {
    for (const Triangle& face : faces) {
        for (const std::int32_t vertex : face) {
            ++first_[vertex + 1];
        }
    }
    for (std::size_t v = 0; v < vertices; ++v) {
        first_[v + 1] += first_[v];
    }
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        for (const std::int32_t vertex : faces[f]) {
            around_[next[vertex]++] = static_cast<std::int32_t>(f);
        }
    }
    for (std::size_t f = 0; f < faces.size(); ++f) {
        for (int k = 0; k < 3; ++k) {
            neighbours_[f][k] = face_with(faces[f][(k + 2) % 3], faces[f][(k + 1) % 3]);
        }
    }
}

std::int32_t Adjacency::face_with(std::int32_t from, std::int32_t to) const {
    // Around the end that has fewer faces, so that one vertex of high valence costs nothing.
    const auto at_from = faces_around(from);
    const auto at_to = faces_around(to);
    for (const std::int32_t face : at_from.size() <= at_to.size() ? at_from : at_to) {
        const int k = corner_of(faces_[face], from);
        if (k >= 0 && faces_[face][(k + 1) % 3] == to) {
            return face;
        }
    }
    return -1;
}

// At corner c of a face (v = c):     c + 2
//                                     | \        the next face counter-clockwise lies across the edge (c, c + 2), which
//                                     |   \      is opposite corner c + 1, the one before it across (c, c + 1).
//                                     c --- c + 1
std::int32_t Adjacency::next_around(std::int32_t vertex, std::int32_t face, int step) const {
    const int corner = corner_of(faces_[face], vertex);
    return neighbours_[face][(corner + step) % 3];
}

std::vector<std::int32_t> Adjacency::spokes(std::int32_t vertex, const Fan& fan) const {
    std::vector<std::int32_t> result;
    for (const std::int32_t face : fan.faces) {
        result.push_back(faces_[face][(corner_of(faces_[face], vertex) + 1) % 3]);
    }
    if (!fan.closed) {
        const std::int32_t last = fan.faces.back();
        result.push_back(faces_[last][(corner_of(faces_[last], vertex) + 2) % 3]);
    }
    return result;
}

} // namespace foldless::verification
