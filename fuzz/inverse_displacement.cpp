// Inverse displacements: solutions that are solutions, the same in every unit of length, and enclosures that hold a
// root of the exact cubic.

#include "drawn_prismoid.h"
#include "prismoid_oracle.h"
#include "require.h"

#include <foldless/predicates/batch_inversion.h>
#include <foldless/predicates/enclosure.h>
#include <foldless/predicates/inverse_displacement.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

namespace foldless::fuzz {
namespace {

/// Any triangle, folded or not, or one of a base mesh.
BaseTriangle drawn_any_triangle(ByteSource& bytes, Grain grain) {
    if (bytes.flag()) {
        return drawn_triangle(bytes, grain);
    }
    BaseTriangle triangle{};
    for (std::size_t i = 0; i < 3; ++i) {
        triangle.v[i] = drawn_vector(bytes, grain);
        triangle.d[i] = drawn_vector(bytes, grain);
    }
    return triangle;
}

/// The list is in order, and what it holds is finite. (Different t may underflow to one double.)
void require_sound(const Preimages& preimages) {
    require(preimages.size() <= 3, "at most three solutions");
    require(preimages.kind != Preimages::Kind::none || preimages.empty(), "none is none");
    require(preimages.kind != Preimages::Kind::finite || !preimages.empty(), "a finite list is not empty");
    for (const Preimage& preimage : preimages) {
        require(std::isfinite(preimage.t) && preimage.alpha.allFinite(), "solutions are finite");
    }
    const auto is_unordered = [](const Preimage& a, const Preimage& b) { return !(a.t <= b.t); };
    require(std::adjacent_find(preimages.begin(), preimages.end(), is_unordered) == preimages.end(),
            "solutions are in ascending order");
}

void require_same(const Preimages& a, const Preimages& b, double t_unit) {
    require(a.kind == b.kind && a.size() == b.size(), "as many solutions in every unit");
    for (int i = 0; i < a.size(); ++i) {
        require(a[i].alpha == b[i].alpha && a[i].t * t_unit == b[i].t, "the same solutions in every unit");
    }
}

/// Whether no unit is extreme: next to zero, quotients such as t have no room.
bool is_ordinary(const BaseTriangle& triangle, const Vec3& q) {
    const auto has_room = [](const Vec3& v) {
        return std::all_of(v.begin(), v.end(),
                           [](double x) { return x == 0 || (std::abs(x) > 0x1p-300 && std::abs(x) < 0x1p300); });
    };
    return has_room(q) && std::all_of(triangle.v.begin(), triangle.v.end(), has_room) &&
           std::all_of(triangle.d.begin(), triangle.d.end(), has_room);
}

/// The unit of length is a power of two, far from where doubles end.
void require_same_in_other_units(const BaseTriangle& triangle, const Vec3& q, ByteSource& bytes) {
    const double length = std::ldexp(1.0, bytes.bits<std::int8_t>());
    const double direction = std::ldexp(1.0, bytes.bits<std::int8_t>());
    BaseTriangle scaled = triangle;
    for (std::size_t i = 0; i < 3; ++i) {
        scaled.v[i] *= length;
        scaled.d[i] *= direction;
    }
    require_same(InverseDisplacement(triangle).preimages(q), InverseDisplacement(scaled).preimages(q * length),
                 length / direction);
}

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same_bits(const Preimage& a, const Preimage& b) {
    return same_bits(a.t, b.t) && same_bits(a.slope, b.slope) && same_bits(a.alpha[0], b.alpha[0]) &&
           same_bits(a.alpha[1], b.alpha[1]) && same_bits(a.alpha[2], b.alpha[2]);
}

/// In every instruction set, a batch has the solutions that its points have alone.
void require_same_in_a_batch(const InverseDisplacement& inverse, const PointBatch& batch) {
    for (const InstructionSet set : {InstructionSet::scalar, InstructionSet::avx2, InstructionSet::avx512}) {
        if (!is_available(set)) {
            continue;
        }
        const BatchInversion inversion(inverse, batch, set);
        for (int k = 0; k < batch.size; ++k) {
            const Preimages alone = inverse.preimages(batch.point(k), batch.range(k));
            const Preimages together = inversion.preimages(k);
            require(alone.kind == together.kind, "as many solutions in a batch");
            require(std::equal(alone.begin(), alone.end(), together.begin(), together.end(),
                               [](const Preimage& a, const Preimage& b) { return same_bits(a, b); }),
                    "the same solutions in a batch");
        }
    }
}

bool has_solution(const BaseTriangle& triangle, const Vec3& q, const Enclosure& enclosure) {
    using oracle::Rational;
    const oracle::Polynomial cubic = oracle::cubic(triangle, q);
    const Rational t(enclosure.t);
    const Rational error(enclosure.t_error);
    return cubic.empty() || !oracle::roots_in(cubic, t - error, t + error).empty();
}

void require_true_enclosures(const BaseTriangle& triangle, const Vec3& q, const Preimages& preimages) {
    for (const Preimage& preimage : preimages) {
        if (const auto enclosure = enclose(triangle, q, preimage.alpha, preimage.t)) {
            require(std::isfinite(enclosure->t_error) && std::isfinite(enclosure->alpha_error), "an error is finite");
            require(has_solution(triangle, q, *enclosure), "an enclosure holds a solution");
        }
    }
}

void require_nearest(const InverseDisplacement& inverse, const Vec3& q, const Preimages& preimages) {
    const std::optional<Preimage> nearest = inverse.nearest(q);
    const auto is_inside = [](const Preimage& preimage) { return inside(preimage); };
    require(nearest.has_value() == std::any_of(preimages.begin(), preimages.end(), is_inside),
            "one of the solutions inside is the nearest");
    for (const Preimage& preimage : preimages) {
        require(!inside(preimage) || std::abs(nearest->t) <= std::abs(preimage.t), "no other is nearer");
    }
}

} // namespace
} // namespace foldless::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace foldless;
    using namespace foldless::fuzz;
    ByteSource bytes(data, size);
    const auto grain = static_cast<Grain>(bytes.below(grains));
    const BaseTriangle triangle = drawn_any_triangle(bytes, grain);
    const InverseDisplacement inverse(triangle);
    PointBatch batch;
    do {
        const Vec3 q = bytes.flag() ? drawn_point(bytes, triangle, grain) : drawn_vector(bytes, grain);
        const Preimages preimages = inverse.preimages(q);
        fuzz::require_sound(preimages);
        require_nearest(inverse, q, preimages);
        const double end = drawn_number(bytes, grain);
        const Range range{std::min(end, 0.0), std::max(end, 0.0)};
        for (const Preimage& preimage : inverse.preimages(q, range)) {
            require(range.lo <= preimage.t && preimage.t <= range.hi, "a range is kept to");
        }
        batch.push_back(q, range);
        if (batch.size == PointBatch::capacity) {
            require_same_in_a_batch(inverse, batch);
            batch.size = 0;
        }
        if (grain != Grain::any) {
            if (is_ordinary(triangle, q)) {
                require_same_in_other_units(triangle, q, bytes);
            }
            require_true_enclosures(triangle, q, preimages);
        }
    } while (!bytes.is_empty());
    require_same_in_a_batch(inverse, batch);
    return 0;
}
