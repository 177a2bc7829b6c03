#include <foldless/images/image_size.h>

#include <fmt/format.h>

namespace foldless {

std::string refused_size_text(const ImageSize& size) {
    const auto& [width, height, channels] = size;
    if (width == 0 || height == 0 || channels == 0) {
        return "the image has no pixels";
    }
    if (width > longest_side || height > longest_side) {
        return fmt::format("{} x {} pixels; a side may have {} at most", width, height, longest_side);
    }
    // No product overflows: 2^16 * 2^16 * 2^10.
    if (channels > most_channels || width * height * channels > most_values) {
        return fmt::format("{} x {} pixels with {} channels; an image may have {} values at most", width, height,
                           channels, most_values);
    }
    return {};
}

std::string refused_expansion_text(double raw_size, std::size_t file_size, double most_expansion) {
    if (raw_size <= most_expansion * static_cast<double>(file_size)) {
        return {};
    }
    return fmt::format("the header claims {:.0f} bytes of pixels, more than a file of {} bytes can hold", raw_size,
                       file_size);
}

} // namespace foldless
