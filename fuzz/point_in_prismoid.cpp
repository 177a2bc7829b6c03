// Where a point lies in a prismoid: as rational arithmetic says, with filters and without.

#include "drawn_prismoid.h"
#include "prismoid_samples.h"
#include "require.h"

#include <foldless/predicates/jacobian.h>
#include <foldless/predicates/prismoid_point.h>

#include <optional>
#include <vector>

namespace foldless::fuzz {
namespace {

bool has_positive_jacobian(const Prismoid& prismoid) {
    const Sign sign = jacobian_on(prismoid.triangle, prismoid.range);
    require(sign == as_sign(oracle::jacobian_is_positive(prismoid.triangle, prismoid.range) ? 1 : -1),
            "the Jacobian has the sign of rational arithmetic");
    const WithoutFilters exactly;
    require(sign == jacobian_on(prismoid.triangle, prismoid.range),
            "the Jacobian has one sign with filters and without");
    return sign == Sign::positive;
}

/// A question about one point; refers to it.
struct Question {
    const Prismoid& prismoid;
    const Vec3& q;
    const ScanTriangle& scan;
    const std::optional<oracle::Place>& truth;
};

/// J > 0, so that a point has one place at most, and its cubic, if it is zero, none.
std::optional<oracle::Place> true_place(const Prismoid& prismoid, const Vec3& q) {
    if (oracle::cubic(prismoid.triangle, q).empty()) {
        return std::nullopt;
    }
    const std::vector<oracle::Place> places = oracle::places(prismoid.triangle, prismoid.range, q);
    require(places.size() <= 1, "a prismoid with J > 0 holds a point once");
    return places.empty() ? std::nullopt : std::optional(places[0]);
}

void require_truth(const Question& question) {
    const auto& [prismoid, q, scan, truth] = question;
    const std::optional<PrismoidPoint> found = PointFinder(prismoid.triangle, prismoid.range).find(q);
    require(found.has_value() == truth.has_value(), "a point is found where it is");
    if (!found) {
        return;
    }
    require(found->walls == truth->walls, "a point is on the walls on which it is");
    require(is_root(found->t, truth->t), "a point is found at its displacement");
    for (int k = 0; k < 3; ++k) {
        const Sign expected = (truth->walls & wall_bit(k)) != 0 ? Sign::zero : Sign::positive;
        require(sign_of_coordinate(prismoid.triangle, k, q, found->t) == expected, "a coordinate has its sign");
    }
    require(normal_condition_at(prismoid.triangle, q, found->t, scan) ==
                as_sign(oracle::normal_condition(prismoid.triangle, q, truth->t, scan)),
            "the normal condition has the sign of rational arithmetic");
    const RoundedPlace rounded = rounded_place(prismoid.triangle, q, found->t);
    require(rounded.alpha.allFinite() && std::isfinite(rounded.t), "a place is rounded to numbers");
}

} // namespace
} // namespace foldless::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace foldless;
    using namespace foldless::fuzz;
    ByteSource bytes(data, size);
    const auto grain = static_cast<Grain>(bytes.below(grains - 1));
    const Prismoid prismoid{drawn_triangle(bytes, grain), drawn_range(bytes)};
    if (!has_positive_jacobian(prismoid)) {
        return 0;
    }
    do {
        const Vec3 q = drawn_point(bytes, prismoid.triangle, grain);
        const ScanTriangle scan{q, q + drawn_vector(bytes, grain), q + drawn_vector(bytes, grain)};
        const std::optional<oracle::Place> truth = true_place(prismoid, q);
        const Question question{prismoid, q, scan, truth};
        require_truth(question);
        const WithoutFilters exactly;
        require_truth(question);
    } while (!bytes.is_empty());
    return 0;
}
