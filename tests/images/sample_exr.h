/// \file
/// OpenEXR files of kinds that foldless does not write.
#pragma once

#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfPixelType.h>

#include <string>
#include <string_view>

namespace foldless {

/// The file that OpenEXR makes of this header, all of whose channels are of one pixel type: the sample of the channel
/// number c (by name) at (x, y) of the data window, counted from its corner, is sample_at(x, y, c).
[[nodiscard]] std::string exr_bytes(const Imf::Header& header);
/// The same with all samples 0.
[[nodiscard]] std::string flat_exr_bytes(const Imf::Header& header);
[[nodiscard]] unsigned sample_at(int x, int y, int channel);

/// A header with a channel of this type for each letter of `channels`.
[[nodiscard]] Imf::Header exr_header(const Imath::Box2i& window, std::string_view channels, Imf::PixelType type);

/// The start of a file, up to its first attribute; an attribute; and what every header must have, for an image with one
/// channel of floats.
[[nodiscard]] std::string exr_start(unsigned flags = 0);
[[nodiscard]] std::string exr_attribute(const std::string& name, const std::string& type, const std::string& value);
[[nodiscard]] std::string required_exr_attributes(int width, int height, char compression);

} // namespace foldless
