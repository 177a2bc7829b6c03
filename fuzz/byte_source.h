/// \file
/// Choices and numbers drawn from the bytes of a fuzzer's input.
#pragma once

#include <foldless/predicates/vector.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace foldless::fuzz {

/// Reads the bytes from the first to the last; zeros follow. What is drawn depends on the bytes alone, so that an input
/// that fails fails again.
class ByteSource {
public:
    ByteSource(const std::uint8_t* data, std::size_t size) : data_(data), end_(data + size) {}

    /// An integer or a floating-point number of these bits.
    template <class Number>
    [[nodiscard]] Number bits() {
        Number value{};
        const auto size = std::min(sizeof(Number), static_cast<std::size_t>(end_ - data_));
        if (size > 0) {
            std::memcpy(&value, data_, size);
            data_ += size;
        }
        return value;
    }

    /// A number of 0 to n - 1. \pre 0 < n <= 256
    [[nodiscard]] int below(int n) { return bits<std::uint8_t>() % n; }
    [[nodiscard]] bool flag() { return below(2) == 1; }
    /// A multiple of 1 / parts of at most 127 / parts, by absolute value.
    [[nodiscard]] double fraction(int parts) { return bits<std::int8_t>() / static_cast<double>(parts); }
    [[nodiscard]] bool is_empty() const { return data_ == end_; }

private:
    const std::uint8_t* data_;
    const std::uint8_t* end_;
};

/// How the numbers of one input are made.
enum class Grain {
    coarse, ///< few digits, so that ties happen
    fine,   ///< 16 bits
    ulps,   ///< coarse, or the next double up or down
    any,    ///< any finite double; of most inputs nothing but overflow remains
};
inline constexpr int grains = 4;

[[nodiscard]] inline double drawn_number(ByteSource& bytes, Grain grain) {
    switch (grain) {
    case Grain::coarse: return bytes.fraction(16);
    case Grain::fine: return bytes.bits<std::int16_t>() / 4096.0;
    case Grain::ulps: {
        const double value = bytes.fraction(16);
        return std::nextafter(value, value + bytes.below(3) - 1);
    }
    case Grain::any: {
        const auto value = bytes.bits<double>();
        return std::isfinite(value) ? value : 0.0;
    }
    }
    return 0.0;
}

[[nodiscard]] inline Vec3 drawn_vector(ByteSource& bytes, Grain grain) {
    const double x = drawn_number(bytes, grain);
    const double y = drawn_number(bytes, grain);
    return {x, y, drawn_number(bytes, grain)};
}

} // namespace foldless::fuzz
