#include <foldless/verify/locate.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace foldless::verification {
namespace {

/// Whether two places in neighbouring faces are one point of their common wall: rounding leaves it open on which side
/// of the wall the point lies, for one of them at least. Off the wall the two faces lie on different sides of it.
bool are_one(const BaseFaces& base, const FacePlace& a, const FacePlace& b) {
    const MovingFace& face = base.face(a.face);
    for (int k = 0; k < 3; ++k) {
        if (face.across[k] != b.face) {
            continue;
        }
        const bool open = (a.walls & wall_bit(k)) != 0 || (b.walls & wall_bit(wall_across(base, a.face, k))) != 0;
        if (open && std::abs(a.at.t - b.at.t) <= a.at.t_error + b.at.t_error) {
            return true;
        }
    }
    return false;
}

/// Groups places that are one point; group[i] is the lowest index in the group of i.
std::vector<std::size_t> groups(const BaseFaces& base, const std::vector<FacePlace>& places) {
    std::vector<std::size_t> group(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        group[i] = i;
        for (std::size_t j = 0; j < i; ++j) {
            if (group[j] == group[i] || !are_one(base, places[i], places[j])) {
                continue;
            }
            const auto [low, high] = std::minmax(group[i], group[j]);
            std::replace(group.begin(), group.begin() + static_cast<std::ptrdiff_t>(i) + 1, high, low);
        }
    }
    return group;
}

/// The point of a group as seen from the face that decides most; the lowest such face.
const FacePlace& representative(const std::vector<FacePlace>& places, const std::vector<std::size_t>& group,
                                std::size_t which) {
    const FacePlace* best = nullptr;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (group[i] == which && (best == nullptr || std::popcount(places[i].walls) < std::popcount(best->walls))) {
            best = &places[i];
        }
    }
    return *best;
}

/// Whether the point on wall k of the place's face is on the base mesh whichever side of the wall it lies on: the face
/// across holds it too, or is certain that it does not.
bool is_settled_across(const BaseFaces& base, const FacePlace& place, int k, const Vec3& q) {
    const std::int32_t across = base.face(place.face).across[k];
    if (across < 0) {
        return false;
    }
    const Enclosure there = coordinates_in(base, {.in = place}, across, q);
    const int wall = wall_across(base, place.face, k);
    return sign_within(there.alpha[wall], there.alpha_error) == Sign::negative ||
           within(base.face(across).range, there.t, there.t_error) != Sign::negative;
}

bool is_decided(const BaseFaces& base, const FacePlace& place, const Vec3& q) {
    if (!place.decided) {
        return false;
    }
    for (int k = 0; k < 3; ++k) {
        if ((place.walls & wall_bit(k)) != 0 && !is_settled_across(base, place, k, q)) {
            return false;
        }
    }
    return true;
}

} // namespace

bool are_adjacent(const BaseFaces& base, std::int32_t a, std::int32_t b) {
    const Triangle& corners = base.face(a).corners;
    return std::any_of(corners.begin(), corners.end(),
                       [&](std::int32_t vertex) { return corner_of(base.face(b).corners, vertex) >= 0; });
}

Located locate(const BaseFaces& base, const PrismoidIndex& index, const Vec3& q) {
    thread_local std::vector<FacePlace> found;
    index.places(q, found);
    Located result;
    std::vector<Place> open;
    const std::vector<std::size_t> group = groups(base, found);
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (group[i] == i) {
            const FacePlace& place = representative(found, group, i);
            (is_decided(base, place, q) ? result.places : open).push_back({.in = place});
        }
    }
    const bool is_open = std::any_of(open.begin(), open.end(), [&](const Place& place) {
        return result.places.empty() ||
               std::any_of(result.places.begin(), result.places.end(),
                           [&](const Place& certain) { return are_adjacent(base, place.in.face, certain.in.face); });
    });
    if (is_open) {
        result.places.insert(result.places.end(), open.begin(), open.end());
        result.multiplicity = Multiplicity::undecided;
    } else if (!result.places.empty()) {
        result.multiplicity = result.places.size() == 1 ? Multiplicity::one : Multiplicity::several;
    }
    return result;
}

} // namespace foldless::verification
