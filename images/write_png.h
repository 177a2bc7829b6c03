/// \file
/// Writes PNG.
#pragma once

#include <foldless/images/image.h>
#include <foldless/io/atomic_file.h>

#include <filesystem>
#include <string>

namespace foldless {

/// What a reader is told of the relation between values and light. Values are never converted.
enum class PngColour {
    unspecified, ///< nothing, as for data that are no colours
    srgb,        ///< a chunk `sRGB`
    linear,      ///< a chunk `gAMA` with an exponent of 1
};

struct PngFormat {
    int bits = 16; ///< of a value: 8 or 16
    PngColour colour = PngColour::unspecified;
};

/// Writes an image under a temporary name; the caller commits it. Its channels, whatever their names, become grey, grey
/// and alpha, RGB or RGBA by their number. Values are cut to [0, 1] and stored as the nearest multiple of
/// 1 / (2^bits - 1), NaN as 0. The metadata stand before the pixels, each as text: numbers in their shortest form that
/// reads back the same, texts as `tEXt` if they are ASCII and as `iTXt` otherwise. The bytes depend on the arguments
/// alone. Besides the image, takes memory for a row.
///
/// \throws std::invalid_argument if the image is not sound (see image.h) or has more than four channels, `bits` is
/// neither 8 nor 16, the key of an entry is not of 1 to 79 printable ASCII characters without blanks at its ends or
/// side by side, or a text holds a null.
/// \throws UnwritableFile
[[nodiscard]] AtomicFile stage_png(const std::filesystem::path& path, const Image& image, const PngFormat& format,
                                   const Metadata& metadata);

/// The same bytes in memory, to stand within another file.
/// \throws std::invalid_argument as stage_png().
[[nodiscard]] std::string png_bytes(const Image& image, const PngFormat& format, const Metadata& metadata);

} // namespace foldless
