#include <foldless/verify/locate.h>

#include <algorithm>

namespace foldless::verification {
namespace {

bool holds(const std::vector<FacePoint>& found, std::int32_t face) {
    return std::any_of(found.begin(), found.end(), [&](const FacePoint& point) { return point.face == face; });
}

/// Whether every face around the point holds it too: the one across its wall, or all around its pillar.
bool is_whole(const BaseFaces& base, const std::vector<FacePoint>& found, const FacePoint& point) {
    const std::int32_t pillar = pillar_of(base, point.face, point.at.walls);
    if (pillar >= 0) {
        const auto around = base.adjacency().faces_around(pillar);
        return std::all_of(around.begin(), around.end(),
                           [&](std::int32_t face) { return !base.is_moving(face) || holds(found, face); });
    }
    for (int k = 0; k < 3; ++k) {
        const std::int32_t across = base.face(point.face).across[k];
        if ((point.at.walls & wall_bit(k)) != 0 && (across < 0 || !holds(found, across))) {
            return false;
        }
    }
    return true;
}

/// Whether the point has been met in a lower face, across its wall or around its pillar. Where J > 0 the two sides of a
/// wall lie on different sides of it (lemma L8), and those of a star all around its pillar, so what lies on the same
/// wall or pillar in both is one point.
bool is_repeated(const BaseFaces& base, const std::vector<FacePoint>& found, const FacePoint& point) {
    return std::any_of(found.begin(), found.end(), [&](const FacePoint& other) {
        if (other.face >= point.face) {
            return false;
        }
        const std::int32_t pillar = pillar_of(base, point.face, point.at.walls);
        if (pillar >= 0) {
            return pillar_of(base, other.face, other.at.walls) == pillar;
        }
        for (int k = 0; k < 3; ++k) {
            if ((point.at.walls & wall_bit(k)) != 0 && base.face(point.face).across[k] == other.face) {
                return (other.at.walls & wall_bit(wall_across(base, point.face, k))) != 0;
            }
        }
        return false;
    });
}

} // namespace

bool are_adjacent(const BaseFaces& base, std::int32_t a, std::int32_t b) {
    const Triangle& corners = base.face(a).corners;
    return std::any_of(corners.begin(), corners.end(),
                       [&](std::int32_t vertex) { return corner_of(base.face(b).corners, vertex) >= 0; });
}

Located locate(const BaseFaces& base, const PrismoidIndex& index, const Vec3& q) {
    // Not kept from call to call: glibc ends a program whose thread finds no memory to note that it has a destructor.
    std::vector<FacePoint> found;
    index.points(q, found);
    Located result;
    for (const FacePoint& point : found) {
        // With constant face directions two prismoids share no more than the foot of their wall.
        const bool is_alone = base.constant_directions() && compare(point.at.t, Displacement()) != Sign::zero;
        if (is_alone) {
            result.places.push_back({point.face, point.at, -1});
            continue;
        }
        if (is_repeated(base, found, point)) {
            continue;
        }
        if (is_whole(base, found, point)) {
            result.places.push_back({point.face, point.at, pillar_of(base, point.face, point.at.walls)});
        } else {
            result.on_open_wall = true;
        }
    }
    return result;
}

} // namespace foldless::verification
