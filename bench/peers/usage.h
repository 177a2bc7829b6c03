// What the process has used so far.
#pragma once

#include <cstddef>

struct Instant {
    double cpu_seconds; // of the processor, over all threads
    double seconds;
};

Instant now();

// The most memory that was resident at once, since the program was loaded; 0 where Linux does not tell.
std::size_t peak_memory_bytes();
