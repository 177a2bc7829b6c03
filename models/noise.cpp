#include <foldless/models/noise.h>

#include <cstddef>
#include <numbers>

namespace foldless {

namespace {

/// The finaliser of SplitMix64 (Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators"), whose
/// every output bit depends on every input bit.
std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31U);
}

/// The four 16-bit parts of the hash, each taken as the middle of its interval of [0, 1]: their sum has mean 2 and
/// variance 4/12 (but for the discretisation, 2^-32 of it), hence the factor sqrt(3).
double scaled_sum(std::uint64_t bits) {
    double sum = -2;
    for (unsigned shift = 0; shift < 64; shift += 16) {
        sum += (static_cast<double>((bits >> shift) & 0xffffU) + 0.5) / 0x1p16;
    }
    return sum * std::numbers::sqrt3;
}

} // namespace

std::array<double, 3> noise_at(std::uint64_t seed, std::uint64_t index) {
    std::uint64_t state = mixed(mixed(seed) ^ index);
    std::array<double, 3> numbers{};
    for (double& number : numbers) {
        number = scaled_sum(state);
        state = mixed(state);
    }
    return numbers;
}

} // namespace foldless
