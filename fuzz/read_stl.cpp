// Any bytes as an STL file: read soundly, or refused in one line.

#include "reading.h"

#include <foldless/io/read_stl.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace foldless;
    fuzz::require_read_or_refused([&] { return read_stl(fuzz::text_of(data, size), "f"); });
    return 0;
}
