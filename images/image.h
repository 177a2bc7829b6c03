/// \file
/// Images in memory: float32 values with named channels, and what a file says of them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace foldless {

/// Values stand interleaved, row by row from the top: channel c of the pixel (x, y) is
/// `values[(y * width + x) * channels.size() + c]`.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::string> channels; ///< e.g. R, G, B, A, or Y for a scalar
    std::vector<float> values;
};

/// Named numbers and texts that stand in a file beside its image. Texts are UTF-8.
using Metadata = std::map<std::string, std::variant<double, std::string>>;

/// The number of this name, whether the file holds it as a number or as text; none if it is absent or no number.
[[nodiscard]] std::optional<double> number(const Metadata& metadata, const std::string& key);

/// What is in an image file.
struct ReadImage {
    Image image;
    Metadata metadata;
};

/// \throws std::invalid_argument if these are not what a file can hold (see image_size.h), two channels have one name,
/// or `values` has another length.
void require_sound(const Image& image);

} // namespace foldless
