/// \file
/// What the allocator does with large blocks of memory.
#pragma once

namespace foldless {

/// From now on, large blocks that are freed go back to the system at once. glibc would else keep blocks of up to 32 MB
/// for later, once it has seen one freed, between others that cannot grow into them: a sixth of the peak of a run.
void return_large_blocks();

} // namespace foldless
