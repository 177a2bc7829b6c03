// Any bytes as a material library: read, or refused in one line.

#include "reading.h"

#include <foldless/io/material_library.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace foldless;
    try {
        for (const Material& material : read_material_library(fuzz::text_of(data, size), "f")) {
            fuzz::require(material.name.find_first_of("\r\n") == std::string::npos, "a name is part of a line");
            fuzz::require(material.picture.find_first_of("\r\n") == std::string::npos, "a picture is part of a line");
        }
    } catch (const UnreadableFile& error) {
        fuzz::require_one_line(error.what());
    }
    return 0;
}
