// How a line goes on in a prismoid: as rational arithmetic says, with filters and without; and images of lines that
// cross are never said to be apart.

#include "drawn_prismoid.h"
#include "passage_oracle.h"
#include "require.h"

#include <foldless/predicates/image_arc.h>
#include <foldless/predicates/jacobian.h>
#include <foldless/predicates/prismoid_line.h>

#include <optional>
#include <vector>

namespace foldless::fuzz {
namespace {

/// A place as both know it.
struct Known {
    PrismoidPoint at;
    oracle::Root t;
};

std::optional<Known> known_place(const Prismoid& prismoid, const Vec3& q) {
    const std::optional<PrismoidPoint> at = PointFinder(prismoid.triangle, prismoid.range).find(q);
    return at ? std::optional(Known{*at, oracle::places(prismoid.triangle, prismoid.range, q).at(0).t}) : std::nullopt;
}

Passage followed(const Prismoid& prismoid, const ScanLine& line, const Known& start, const std::optional<Known>& end) {
    return follow_line(prismoid.triangle, line, start.at, end ? &end->at : nullptr);
}

/// X at the wall through which the line leaves.
void require_true_condition(const Prismoid& prismoid, const ScanLine& line, const Passage& passage,
                            const oracle::Root& t) {
    const Vec3& p = *line.from;
    const Vec3& q = *line.to;
    const ScanTriangle scan{p, q, p + Vec3(q[1] - p[1] + 0.25, p[0] - q[0] - 0.125, 0.0625)};
    require(normal_condition_at_wall(prismoid.triangle, {passage.wall, passage.t, line}, scan) ==
                as_sign(oracle::normal_condition_at_wall(prismoid.triangle, passage.wall, p, q, t, scan)),
            "the normal condition at a wall has the sign of rational arithmetic");
}

void require_true_passage(const Prismoid& prismoid, const ScanLine& line, const Known& start) {
    const std::optional<Known> end = known_place(prismoid, *line.to);
    const TruePassage truth{
        prismoid.range,
        oracle::exit_of(prismoid.triangle, prismoid.range, *line.from, *line.to, {start.t, start.at.walls}),
        end ? std::optional(end->t) : std::nullopt};
    const auto check = [&] {
        const Passage passage = followed(prismoid, line, start, end);
        const std::string wrong = disagreement(passage, truth);
        require(wrong.empty(), wrong);
        if (passage.kind == Passage::Kind::leaves && truth.exit && truth.exit->past_end <= 0) {
            require_true_condition(prismoid, line, passage, truth.exit->t);
        }
    };
    check();
    const WithoutFilters exactly;
    check();
}

/// The image of a line through the middle of which the displaced point of alpha lies, if all of it is in the prismoid.
struct Through {
    Vec3 from;
    Vec3 to;
    std::optional<ImageArc> arc;

    Through(const Prismoid& prismoid, const Vec3& middle, const Vec3& half) : from(middle - half), to(middle + half) {
        const std::optional<Known> start = known_place(prismoid, from);
        const std::optional<Known> end = known_place(prismoid, to);
        const ScanLine line{&from, &to};
        if (start && end && followed(prismoid, line, *start, end).kind == Passage::Kind::ends) {
            arc.emplace(prismoid.triangle, line, ImageArc::End{start->at, true}, ImageArc::End{end->at, true});
        }
    }
};

/// Two lines over one another, exactly, since coarse numbers are not rounded.
void require_images_that_cross(const Prismoid& prismoid, ByteSource& bytes) {
    const Vec3 alpha = drawn_barycentric(bytes);
    const Vec3 low = displaced(prismoid.triangle, alpha, bytes.fraction(128));
    const Vec3 high = displaced(prismoid.triangle, alpha, bytes.fraction(128));
    const Vec3 half = 0.125 * drawn_vector(bytes, Grain::coarse);
    const Through a(prismoid, low, half);
    const Through b(prismoid, high, 0.125 * drawn_vector(bytes, Grain::coarse));
    if (!a.arc || !b.arc || half.isZero()) {
        return;
    }
    require(!are_apart(*a.arc, *b.arc, {}), "images that cross are not apart");
    const Range inside = a.arc->parameters();
    if (inside.lo < 0.5 && 0.5 < inside.hi) {
        const ScanTriangle over_it{high - Vec3(1, 1, 0), high + Vec3(1, 0, 0), high + Vec3(0, 1, 0)};
        require(!certainly_misses(*a.arc, 0.5, over_it, prismoid.range) ||
                    !PointFinder(prismoid.triangle, prismoid.range).find(high),
                "a ray that meets a triangle does not miss it");
    }
}

} // namespace
} // namespace foldless::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace foldless;
    using namespace foldless::fuzz;
    ByteSource bytes(data, size);
    const auto grain = static_cast<Grain>(bytes.below(grains - 1));
    const Prismoid prismoid{drawn_triangle(bytes, grain), drawn_range(bytes)};
    if (jacobian_on(prismoid.triangle, prismoid.range) != Sign::positive) {
        return 0;
    }
    do {
        const Vec3 p = drawn_point(bytes, prismoid.triangle, grain);
        const Vec3 q = drawn_point(bytes, prismoid.triangle, grain);
        const std::optional<Known> start = known_place(prismoid, p);
        if (start && p != q) {
            require_true_passage(prismoid, {&p, &q}, *start);
        }
        if (grain == Grain::coarse) {
            require_images_that_cross(prismoid, bytes);
        }
    } while (!bytes.is_empty());
    return 0;
}
