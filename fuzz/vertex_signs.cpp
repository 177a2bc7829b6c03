// Signs at a vertex of the base mesh and its pillar: those of rational arithmetic, with filters and without, for all
// finite numbers; and no answer for others.

#include "byte_source.h"
#include "prismoid_oracle.h"
#include "prismoid_samples.h"
#include "require.h"

#include <foldless/predicates/jacobian.h>
#include <foldless/predicates/pillar.h>
#include <foldless/predicates/scan_normal.h>
#include <foldless/predicates/scan_orientation.h>
#include <foldless/predicates/view_along.h>
#include <foldless/predicates/wall.h>

#include <algorithm>
#include <array>

namespace foldless::fuzz {
namespace {

namespace truth = foldless::oracle;

/// All that the questions are about.
struct World {
    DisplacedVertex vertex;
    DisplacedVertex next;
    DisplacedVertex after;
    ScanTriangle scan;
    double t;

    World(ByteSource& bytes, Grain grain) {
        for (DisplacedVertex* each : {&vertex, &next, &after}) {
            each->v = drawn_vector(bytes, grain);
            each->d = drawn_vector(bytes, grain);
        }
        for (Vec3& corner : scan) {
            corner = drawn_vector(bytes, grain);
        }
        t = drawn_number(bytes, grain);
    }

    [[nodiscard]] BaseTriangle triangle() const { return {{vertex.v, next.v, after.v}, {vertex.d, next.d, after.d}}; }
};

truth::Vector at(const DisplacedVertex& vertex, const truth::Rational& t) {
    truth::Vector result;
    for (int c = 0; c < 3; ++c) {
        result[c] = truth::Rational(vertex.v[c]) + t * truth::Rational(vertex.d[c]);
    }
    return result;
}

Sign sign(const truth::Rational& x) {
    return as_sign(sgn(x));
}

Sign true_pierces(const DisplacedVertex& vertex, const ScanTriangle& q) {
    if (truth::seen(vertex.d, q) <= 0) {
        return Sign::negative;
    }
    int least = 1;
    for (int k = 0; k < 3; ++k) {
        least = std::min(least, sgn(truth::seen(vertex.d, {q[k], q[(k + 1) % 3], vertex.v})));
    }
    return as_sign(least);
}

void require_true_pillar(const World& world) {
    const auto& [vertex, next, after, scan, t] = world;
    require(pierces(vertex, scan) == true_pierces(vertex, scan), "a pillar pierces what it pierces");
    const truth::Rational m = truth::seen(vertex.d, scan);
    require(seen_along(vertex.d, scan) == sign(m), "a triangle is seen along a direction from its side");
    if (m <= 0) {
        return;
    }
    const truth::Vector n =
        truth::cross(truth::vector(scan[1]) - truth::vector(scan[0]), truth::vector(scan[2]) - truth::vector(scan[0]));
    const truth::Rational met = truth::dot(truth::vector(scan[0]) - truth::vector(vertex.v), n) / m;
    const Range range{std::min(t, vertex.v[0]), std::max(t, vertex.v[0])};
    require(meets_plane_within(vertex, scan, range) ==
                (truth::Rational(range.lo) <= met && met <= truth::Rational(range.hi)),
            "a pillar meets a plane where it does");
    const Range bounds = displacement_at_plane(vertex, scan);
    require((std::isinf(bounds.lo) || truth::Rational(bounds.lo) <= met) &&
                (std::isinf(bounds.hi) || met <= truth::Rational(bounds.hi)),
            "bounds hold the displacement at a plane");
}

void require_true_turns(const World& world) {
    const auto& [vertex, next, after, scan, t] = world;
    const truth::Rational where(t);
    const truth::Vector d = truth::vector(vertex.d);
    const truth::Vector to_next = at(next, where) - at(vertex, where);
    require(turn_at(vertex, next, after, t) ==
                sign(truth::determinant(to_next, at(after, where) - at(vertex, where), d)),
            "b follows a around a pillar");
    const truth::Vector edge = truth::vector(scan[1]) - truth::vector(scan[0]);
    require(turn_from_base_edge(vertex, next, Displacement(t), {&scan[0], &scan[1]}) ==
                sign(truth::dot(d, truth::cross(to_next, edge))),
            "a scan edge follows a base edge around a pillar");
}

/// The predicates that may be undecided are right where they decide.
void require_no_wrong_sign(const World& world) {
    const auto& [vertex, next, after, scan, t] = world;
    const auto fits = [](Sign found, const truth::Rational& x) { return found == Sign::undecided || found == sign(x); };
    const ScanNormal normal(scan);
    require(fits(normal.seen_along(vertex.d), truth::seen(vertex.d, scan)), "a normal has an error bound");
    require(fits(normal.normalised().seen_along(vertex.d), truth::seen(vertex.d, scan)),
            "a normal of unit length has an error bound");
    const BarycentricTriangle alpha{vertex.v, next.v, after.v};
    const auto difference = [&](int corner, int k) {
        return truth::Rational(truth::Rational(alpha[corner][k]) - truth::Rational(alpha[0][k]));
    };
    const truth::Rational area = difference(1, 0) * difference(2, 1) - difference(1, 1) * difference(2, 0);
    require(fits(scan_orientation(alpha, {0.0, 0.0, 0.0}), area), "corners turn as they do");
    if (!vertex.d.isZero()) {
        const ViewAlong view(vertex.d);
        require(fits(turn(view.see(next.v), view.see(after.v)),
                     truth::determinant(truth::vector(next.v), truth::vector(after.v), truth::vector(vertex.d))),
                "seen along a direction, b follows a");
    }
}

/// A wall that is said to be passed one way has a normal with one sign along the edge at its four corners.
void require_true_wall(const World& world) {
    const Range range{std::min(world.t, 0.0), std::max(world.t, 0.0)};
    const Vec3& e = world.scan[0];
    if (!Wall(world.triangle(), 0).is_passed_one_way(e, range)) {
        return;
    }
    int first = 0;
    for (const double t : {range.lo, range.hi}) {
        const truth::Rational where(t);
        const truth::Vector side = at(world.after, where) - at(world.next, where);
        for (const Vec3& d : {world.next.d, world.after.d}) {
            const int here = sgn(truth::determinant(truth::vector(e), side, truth::vector(d)));
            first = first == 0 ? here : first;
            require(here != 0 && here == first, "a wall that is passed one way has one side");
        }
    }
}

/// Three rational displacements decide everything.
void require_same_orientation(const World& world) {
    const std::array<DisplacedPoint, 3> corners{{{world.vertex.v, {}}, {world.next.v, {}}, {world.after.v, {}}}};
    if (jacobian_on(world.triangle(), {0.0, 0.0}) == Sign::positive) {
        require(scan_orientation(world.triangle(), corners) == Sign::positive, "a triangle turns as itself");
    }
}

/// What is not finite has no answer, and does no harm.
void require_nothing(World world, ByteSource& bytes) {
    const double others[] = {HUGE_VAL, -HUGE_VAL, std::nan("")};
    world.vertex.d[bytes.below(3)] = others[bytes.below(3)];
    require(seen_along(world.vertex.d, world.scan) == Sign::undecided, "what is not finite is not seen");
    require(turn_at(world.vertex, world.next, world.after, world.t) == Sign::undecided, "nor followed around");
    require(jacobian_on(world.triangle(), {0.0, 0.0}) == Sign::negative, "nor invertible");
}

} // namespace
} // namespace foldless::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace foldless;
    using namespace foldless::fuzz;
    ByteSource bytes(data, size);
    do {
        const World world(bytes, static_cast<Grain>(bytes.below(grains)));
        const auto check = [&] {
            require_true_pillar(world);
            require_true_turns(world);
            require_same_orientation(world);
        };
        check();
        require_no_wrong_sign(world);
        require_true_wall(world);
        require_nothing(world, bytes);
        const WithoutFilters exactly;
        check();
    } while (!bytes.is_empty());
    return 0;
}
