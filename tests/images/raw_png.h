/// \file
/// PNG files put together by hand: any colour type and depth, interlaced or not, and lies.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace foldless {

/// A chunk with its length and check sum.
[[nodiscard]] std::string png_chunk(std::string_view kind, std::string_view body);

struct RawPng {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    int bits = 8;
    int colour_type = 0;
    std::vector<std::uint32_t> samples; ///< as many for each pixel as the colour type has, from 0 to 2^bits - 1
    bool interlaced = false;
    std::string chunks; ///< before the pixels: a palette, say
};

[[nodiscard]] std::string bytes_of(const RawPng& png);

} // namespace foldless
