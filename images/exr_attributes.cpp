#include <foldless/images/exr_attributes.h>

#include <algorithm>

namespace foldless {

namespace {

constexpr std::string_view reserved[] = {
    "channels",
    "chunkCount",
    "compression",
    "dataWindow",
    "displayWindow",
    "dwaCompressionLevel",
    "lineOrder",
    "maxSamplesPerPixel",
    "name",
    "pixelAspectRatio",
    "preview",
    "screenWindowCenter",
    "screenWindowWidth",
    "tiles",
    "type",
    "version",
    "view",
};

} // namespace

bool is_reserved_attribute(std::string_view name) {
    return std::ranges::find(reserved, name) != std::end(reserved);
}

} // namespace foldless
