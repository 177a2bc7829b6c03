/// \file
/// How large an image may be.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace foldless {

/// As a header claims it: nothing of it need be true.
struct ImageSize {
    std::uint64_t width = 0;
    std::uint64_t height = 0;
    std::size_t channels = 0;

    /// Of a size that is not refused.
    [[nodiscard]] std::size_t values() const { return width * height * channels; }
};

constexpr std::uint64_t longest_side = 65536; ///< pixels
/// 4 GiB in memory: a square of 16,384 with four channels, or of 32,768 with one.
constexpr std::uint64_t most_values = std::uint64_t{1} << 30;
constexpr std::size_t most_channels = 1024;

/// Why no image of this size is read or written; empty if there is no reason.
[[nodiscard]] std::string refused_size_text(const ImageSize& size);

/// Why a file of `file_size` bytes cannot hold `raw_size` bytes of pixels, when no byte of it stands for more than
/// `most_expansion` of them; empty if it can. A header that lies is found out before memory is taken for it.
[[nodiscard]] std::string refused_expansion_text(double raw_size, std::size_t file_size, double most_expansion);

} // namespace foldless
