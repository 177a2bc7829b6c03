/// \file
/// JPEG files.
#pragma once

#include <foldless/images/image.h>

#include <string>

namespace foldless {

struct SampleJpeg {
    bool progressive = false;
    bool inks = false; ///< four of them, instead of colours
};

/// The image with one, three or, for inks, four channels in best quality and full resolution.
[[nodiscard]] std::string jpeg_bytes(const Image& image, const SampleJpeg& kind);

} // namespace foldless
