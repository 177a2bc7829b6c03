/// \file
/// As many doubles at a time as an instruction set takes, under the same names in each: a kernel is written once and
/// compiled in one source for each set, which defines FOLDLESS_AVX512, FOLDLESS_AVX2, or nothing before it includes
/// this.
///
/// What is selected and compared is as in the scalar expression beside it, for zeros of either sign and NaN too.
#pragma once

#if defined(FOLDLESS_AVX512) || defined(FOLDLESS_AVX2)
#include <immintrin.h>
#endif

#include <foldless/predicates/vector.h>

#include <cmath>

// The namespace of the kernels of a set keeps them apart from those of another. FOLDLESS_KERNEL is for the function
// that other sources call, FOLDLESS_INLINE for what it is made of.
#if defined(FOLDLESS_AVX512)
#define FOLDLESS_LANES avx512_lanes
#define FOLDLESS_KERNEL [[gnu::target("avx2,avx512f,avx512dq,avx512vl")]]
#define FOLDLESS_INLINE [[gnu::target("avx2,avx512f,avx512dq,avx512vl"), gnu::always_inline]] inline
#elif defined(FOLDLESS_AVX2)
#define FOLDLESS_LANES avx2_lanes
#define FOLDLESS_KERNEL [[gnu::target("avx2")]]
#define FOLDLESS_INLINE [[gnu::target("avx2"), gnu::always_inline]] inline
#else
#define FOLDLESS_LANES scalar_lanes
#define FOLDLESS_INLINE [[gnu::always_inline]] inline
#endif

namespace foldless::FOLDLESS_LANES {

#if defined(FOLDLESS_AVX512) || defined(FOLDLESS_AVX2)

/// Four doubles. Registers of eight, which AVX-512 has, were faster here and slower as part of a whole run.
struct Register {
    __m256d of;
};

FOLDLESS_INLINE Register broadcast(double x) {
    return {_mm256_set1_pd(x)};
}
FOLDLESS_INLINE Register load_register(const double* aligned) {
    return {_mm256_load_pd(aligned)};
}
FOLDLESS_INLINE void store_register(double* aligned, Register a) {
    _mm256_store_pd(aligned, a.of);
}
FOLDLESS_INLINE Register operator+(Register a, Register b) {
    return {a.of + b.of};
}
FOLDLESS_INLINE Register operator-(Register a, Register b) {
    return {a.of - b.of};
}
FOLDLESS_INLINE Register operator*(Register a, Register b) {
    return {a.of * b.of};
}
FOLDLESS_INLINE Register operator/(Register a, Register b) {
    return {a.of / b.of};
}
FOLDLESS_INLINE Register operator-(Register a) {
    return {-a.of};
}
FOLDLESS_INLINE Register absolute(Register a) {
    return {_mm256_andnot_pd(_mm256_set1_pd(-0.0), a.of)};
}
/// a < b ? b : a, as std::max
FOLDLESS_INLINE Register greater_of(Register a, Register b) {
    return {_mm256_max_pd(b.of, a.of)};
}
/// b < a ? b : a, as std::min
FOLDLESS_INLINE Register lesser_of(Register a, Register b) {
    return {_mm256_min_pd(b.of, a.of)};
}

#if defined(FOLDLESS_AVX512)
using MaskBits = __mmask8;
#else
using MaskBits = __m256d;
#endif

/// One truth value for each double.
struct RegisterMask {
    MaskBits of;
};

#if defined(FOLDLESS_AVX512)

FOLDLESS_INLINE RegisterMask less(Register a, Register b) {
    return {_mm256_cmp_pd_mask(a.of, b.of, _CMP_LT_OQ)};
}
FOLDLESS_INLINE RegisterMask at_most(Register a, Register b) {
    return {_mm256_cmp_pd_mask(a.of, b.of, _CMP_LE_OQ)};
}
FOLDLESS_INLINE RegisterMask both(RegisterMask m, RegisterMask n) {
    return {static_cast<__mmask8>(m.of & n.of)};
}
FOLDLESS_INLINE RegisterMask either(RegisterMask m, RegisterMask n) {
    return {static_cast<__mmask8>(m.of | n.of)};
}
/// m, and not n
FOLDLESS_INLINE RegisterMask but_not(RegisterMask m, RegisterMask n) {
    return {static_cast<__mmask8>(m.of & ~n.of)};
}
/// m ? a : b
FOLDLESS_INLINE Register select(RegisterMask m, Register a, Register b) {
    return {_mm256_mask_blend_pd(m.of, b.of, a.of)};
}
/// Bit k is that of double k.
FOLDLESS_INLINE unsigned bits(RegisterMask m) {
    return m.of;
}

#else

FOLDLESS_INLINE RegisterMask less(Register a, Register b) {
    return {_mm256_cmp_pd(a.of, b.of, _CMP_LT_OQ)};
}
FOLDLESS_INLINE RegisterMask at_most(Register a, Register b) {
    return {_mm256_cmp_pd(a.of, b.of, _CMP_LE_OQ)};
}
FOLDLESS_INLINE RegisterMask both(RegisterMask m, RegisterMask n) {
    return {_mm256_and_pd(m.of, n.of)};
}
FOLDLESS_INLINE RegisterMask either(RegisterMask m, RegisterMask n) {
    return {_mm256_or_pd(m.of, n.of)};
}
FOLDLESS_INLINE RegisterMask but_not(RegisterMask m, RegisterMask n) {
    return {_mm256_andnot_pd(n.of, m.of)};
}
FOLDLESS_INLINE Register select(RegisterMask m, Register a, Register b) {
    return {_mm256_blendv_pd(b.of, a.of, m.of)};
}
FOLDLESS_INLINE unsigned bits(RegisterMask m) {
    return static_cast<unsigned>(_mm256_movemask_pd(m.of));
}

#endif

/// Lanes side by side: while those of the one wait for a division, the others are worked on.
template <class Half>
struct Pair {
    Half first, second;
};
template <class Half>
Pair(Half, Half) -> Pair<Half>;

template <class Half>
FOLDLESS_INLINE Pair<Half> operator+(const Pair<Half>& a, const Pair<Half>& b) {
    return {a.first + b.first, a.second + b.second};
}
template <class Half>
FOLDLESS_INLINE Pair<Half> operator-(const Pair<Half>& a, const Pair<Half>& b) {
    return {a.first - b.first, a.second - b.second};
}
template <class Half>
FOLDLESS_INLINE Pair<Half> operator*(const Pair<Half>& a, const Pair<Half>& b) {
    return {a.first * b.first, a.second * b.second};
}
template <class Half>
FOLDLESS_INLINE Pair<Half> operator/(const Pair<Half>& a, const Pair<Half>& b) {
    return {a.first / b.first, a.second / b.second};
}
template <class Half>
FOLDLESS_INLINE Pair<Half> operator-(const Pair<Half>& a) {
    return {-a.first, -a.second};
}
template <class Half>
FOLDLESS_INLINE Pair<Half> absolute(const Pair<Half>& a) {
    return {absolute(a.first), absolute(a.second)};
}
/// a < b ? b : a, as std::max
template <class Half>
FOLDLESS_INLINE Pair<Half> greater_of(const Pair<Half>& a, const Pair<Half>& b) {
    return {greater_of(a.first, b.first), greater_of(a.second, b.second)};
}
/// b < a ? b : a, as std::min
template <class Half>
FOLDLESS_INLINE Pair<Half> lesser_of(const Pair<Half>& a, const Pair<Half>& b) {
    return {lesser_of(a.first, b.first), lesser_of(a.second, b.second)};
}
template <class Half>
FOLDLESS_INLINE auto less(const Pair<Half>& a, const Pair<Half>& b) {
    return Pair{less(a.first, b.first), less(a.second, b.second)};
}
template <class Half>
FOLDLESS_INLINE auto at_most(const Pair<Half>& a, const Pair<Half>& b) {
    return Pair{at_most(a.first, b.first), at_most(a.second, b.second)};
}
template <class Half>
FOLDLESS_INLINE Pair<Half> both(const Pair<Half>& m, const Pair<Half>& n) {
    return {both(m.first, n.first), both(m.second, n.second)};
}
template <class Half>
FOLDLESS_INLINE Pair<Half> either(const Pair<Half>& m, const Pair<Half>& n) {
    return {either(m.first, n.first), either(m.second, n.second)};
}
/// m, and not n
template <class Half>
FOLDLESS_INLINE Pair<Half> but_not(const Pair<Half>& m, const Pair<Half>& n) {
    return {but_not(m.first, n.first), but_not(m.second, n.second)};
}
/// m ? a : b
template <class Truth, class Half>
FOLDLESS_INLINE Pair<Half> select(const Pair<Truth>& m, const Pair<Half>& a, const Pair<Half>& b) {
    return {select(m.first, a.first, b.first), select(m.second, a.second, b.second)};
}

inline constexpr int register_lanes = sizeof(Register) / sizeof(double);

#if defined(FOLDLESS_AVX512)

using Real = Pair<Pair<Register>>;
using Mask = Pair<Pair<RegisterMask>>;

FOLDLESS_INLINE Real all(double x) {
    return {{broadcast(x), broadcast(x)}, {broadcast(x), broadcast(x)}};
}
FOLDLESS_INLINE Real load(const double* aligned) {
    return {{load_register(aligned), load_register(aligned + register_lanes)},
            {load_register(aligned + 2 * register_lanes), load_register(aligned + 3 * register_lanes)}};
}
FOLDLESS_INLINE void store(double* aligned, const Real& a) {
    store_register(aligned, a.first.first);
    store_register(aligned + register_lanes, a.first.second);
    store_register(aligned + 2 * register_lanes, a.second.first);
    store_register(aligned + 3 * register_lanes, a.second.second);
}
/// Bit k is that of lane k.
FOLDLESS_INLINE unsigned bits(const Mask& m) {
    return bits(m.first.first) | bits(m.first.second) << register_lanes | bits(m.second.first) << 2 * register_lanes |
           bits(m.second.second) << 3 * register_lanes;
}

#else

using Real = Pair<Register>;
using Mask = Pair<RegisterMask>;

FOLDLESS_INLINE Real all(double x) {
    return {broadcast(x), broadcast(x)};
}
FOLDLESS_INLINE Real load(const double* aligned) {
    return {load_register(aligned), load_register(aligned + register_lanes)};
}
FOLDLESS_INLINE void store(double* aligned, const Real& a) {
    store_register(aligned, a.first);
    store_register(aligned + register_lanes, a.second);
}
FOLDLESS_INLINE unsigned bits(const Mask& m) {
    return bits(m.first) | bits(m.second) << register_lanes;
}

#endif

inline constexpr int lanes = sizeof(Real) / sizeof(double);

#else

using Real = double;
using Mask = bool;
inline constexpr int lanes = 1;

FOLDLESS_INLINE Real all(double x) {
    return x;
}
FOLDLESS_INLINE Real load(const double* aligned) {
    return *aligned;
}
FOLDLESS_INLINE void store(double* aligned, Real a) {
    *aligned = a;
}
FOLDLESS_INLINE Real absolute(Real a) {
    return std::abs(a);
}
FOLDLESS_INLINE Real greater_of(Real a, Real b) {
    return a < b ? b : a;
}
FOLDLESS_INLINE Real lesser_of(Real a, Real b) {
    return b < a ? b : a;
}
FOLDLESS_INLINE Mask less(Real a, Real b) {
    return a < b;
}
FOLDLESS_INLINE Mask at_most(Real a, Real b) {
    return a <= b;
}
FOLDLESS_INLINE Mask both(Mask m, Mask n) {
    return m && n;
}
FOLDLESS_INLINE Mask either(Mask m, Mask n) {
    return m || n;
}
FOLDLESS_INLINE Mask but_not(Mask m, Mask n) {
    return m && !n;
}
FOLDLESS_INLINE Real select(Mask m, Real a, Real b) {
    return m ? a : b;
}
FOLDLESS_INLINE unsigned bits(Mask m) {
    return m ? 1U : 0U;
}

#endif

/// What bits() of a mask are where all lanes are set.
inline constexpr unsigned every_bit = (1U << lanes) - 1U;

/// A vector for each lane.
struct LaneVector {
    Real x, y, z;
};

/// The sum in the order x, y, z.
FOLDLESS_INLINE Real dot(const LaneVector& a, const Vec3& b) {
    return a.x * all(b[0]) + a.y * all(b[1]) + a.z * all(b[2]);
}

} // namespace foldless::FOLDLESS_LANES
