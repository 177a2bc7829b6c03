// Any bytes as an OFF file: read soundly, or refused in one line.

#include "reading.h"

#include <foldless/io/read_off.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace foldless;
    for (const Content content : {Content::scan, Content::coloured_scan}) {
        fuzz::require_read_or_refused([&] { return read_off(fuzz::text_of(data, size), "f", content); });
    }
    return 0;
}
