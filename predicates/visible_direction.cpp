#include <foldless/predicates/visible_direction.h>

#include <algorithm>
#include <array>
#include <vector>

namespace foldless {
namespace {

/// Up to three normals on the rim of a cap, and its centre.
struct Cap {
    std::array<Vec3, 3> rim;
    int count = 0;
    Vec3 centre = Vec3::Zero();
    double closest = -2; ///< smallest dot product of the centre with the candidates it was chosen among
};

double smallest_dot(const Vec3& x, std::span<const Vec3> normals) {
    double smallest = 2;
    for (const Vec3& n : normals) {
        smallest = std::min(smallest, n.dot(x));
    }
    return smallest;
}

void keep_better(Cap& best, std::initializer_list<Vec3> rim, const Vec3& centre, std::span<const Vec3> all) {
    const double norm = centre.norm();
    if (!(norm > 0)) {
        return;
    }
    const Vec3 unit = centre / norm;
    const double closest = smallest_dot(unit, all);
    if (closest > best.closest) {
        best.count = 0;
        for (const Vec3& n : rim) {
            best.rim[best.count++] = n;
        }
        best.centre = unit;
        best.closest = closest;
    }
}

/// The smallest cap of at most four normals, the last of which is on its rim: among all caps through one, two or three
/// of them the one that reaches the furthest normal best.
Cap smallest_cap(std::span<const Vec3> normals) {
    Cap best;
    const Vec3& last = normals.back();
    const std::size_t n = normals.size() - 1;
    keep_better(best, {last}, last, normals);
    for (std::size_t i = 0; i < n; ++i) {
        keep_better(best, {normals[i], last}, normals[i] + last, normals);
        for (std::size_t j = i + 1; j < n; ++j) {
            Vec3 axis = (normals[i] - last).cross(normals[j] - last);
            if (axis.dot(last) < 0) {
                axis = -axis;
            }
            keep_better(best, {normals[i], normals[j], last}, axis, normals);
        }
    }
    return best;
}

/// Far more steps than any input needs; rounding could otherwise let two caps of the same size take turns.
constexpr int most_steps = 100;

} // namespace

std::optional<Vec3> most_visible_direction(std::span<const Vec3> unit_normals) {
    if (unit_normals.empty()) {
        return std::nullopt;
    }
    Cap cap;
    cap.rim[0] = unit_normals.front();
    cap.count = 1;
    cap.centre = unit_normals.front();
    cap.closest = 1;
    for (int step = 0; step < most_steps; ++step) {
        const auto furthest =
            std::min_element(unit_normals.begin(), unit_normals.end(),
                             [&](const Vec3& a, const Vec3& b) { return a.dot(cap.centre) < b.dot(cap.centre); });
        const double reach = furthest->dot(cap.centre);
        if (reach >= cap.closest) {
            break;
        }
        std::array<Vec3, 4> candidates;
        std::copy_n(cap.rim.begin(), cap.count, candidates.begin());
        candidates[cap.count] = *furthest;
        const Cap next = smallest_cap({candidates.data(), static_cast<std::size_t>(cap.count + 1)});
        if (!(next.closest < cap.closest)) {
            break; // the cap must grow
        }
        cap = next;
    }
    if (!(smallest_dot(cap.centre, unit_normals) > 0)) {
        return std::nullopt;
    }
    return cap.centre;
}

} // namespace foldless
