// Any bytes as a PLY file: read soundly, or refused in one line.

#include "reading.h"

#include <foldless/io/read_ply.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace foldless;
    for (const Content content : {Content::scan, Content::coloured_scan, Content::base_mesh}) {
        fuzz::require_read_or_refused([&] { return read_ply(fuzz::text_of(data, size), "f", content); });
    }
    return 0;
}
