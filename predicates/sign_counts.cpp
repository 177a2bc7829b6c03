#include <foldless/predicates/sign_counts.h>

#include <foldless/predicates/filtered.h>

#include <atomic>

namespace foldless {
namespace {

std::atomic<bool> enabled{true};
thread_local SignCounts counts;

} // namespace

const SignCounts& sign_counts() {
    return counts;
}

void set_filters_enabled(bool on) {
    enabled.store(on, std::memory_order_relaxed);
}

bool filters_enabled() {
    return enabled.load(std::memory_order_relaxed);
}

void count_filtered() {
    ++counts.filtered;
}

void count_exact() {
    ++counts.exact;
}

} // namespace foldless
