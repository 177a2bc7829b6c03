#include <foldless/tools/large_blocks.h>

#include <malloc.h>

namespace foldless {
namespace {

/// In bytes: what glibc starts with. Setting it at all keeps glibc from raising it.
constexpr int smallest_large_block = 128 * 1024;

} // namespace

void return_large_blocks() {
    ::mallopt(M_MMAP_THRESHOLD, smallest_large_block);
}

} // namespace foldless
