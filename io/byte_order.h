/// \file
/// Numbers as bytes of a given order.
#pragma once

#include <algorithm>
#include <bit>
#include <concepts>
#include <cstring>
#include <string>

namespace foldless {

template <class Number>
concept Scalar = std::integral<Number> || std::floating_point<Number>;

/// The number that is stored at `bytes` in the given order, aligned or not.
template <Scalar Number>
[[nodiscard]] Number load(const char* bytes, std::endian order) {
    char swapped[sizeof(Number)];
    std::memcpy(swapped, bytes, sizeof(Number));
    if (order != std::endian::native) {
        std::reverse(swapped, swapped + sizeof(Number));
    }
    Number number;
    std::memcpy(&number, swapped, sizeof(Number));
    return number;
}

/// Appends the number, little endian.
template <Scalar Number>
void append_little_endian(std::string& bytes, Number number) {
    char stored[sizeof(Number)];
    std::memcpy(stored, &number, sizeof(Number));
    if (std::endian::native != std::endian::little) {
        std::reverse(stored, stored + sizeof(Number));
    }
    bytes.append(stored, sizeof(Number));
}

} // namespace foldless
