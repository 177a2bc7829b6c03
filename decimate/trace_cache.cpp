#include <foldless/decimate/trace_cache.h>

#include <algorithm>

namespace foldless {
namespace {

constexpr std::size_t smallest_table = 64;

} // namespace

void TraceCache::clear() {
    ++trial_;
    table_.resize(std::max(smallest_table, table_.size()));
    entries_.clear();
    pool_.clear();
}

std::size_t TraceCache::slot(std::int32_t a, std::int32_t b) const {
    const std::size_t mask = table_.size() - 1;
    // Two odd multipliers spread neighbouring indices; the high bits are folded down because the mask keeps low ones.
    std::uint64_t hash =
        static_cast<std::uint64_t>(a) * 0x9E3779B97F4A7C15ULL ^ static_cast<std::uint64_t>(b) * 0xC2B2AE3D27D4EB4FULL;
    hash ^= hash >> 32;
    std::size_t at = hash & mask;
    while (!is_free(table_[at]) && (entries_[table_[at].entry].a != a || entries_[table_[at].entry].b != b)) {
        at = (at + 1) & mask;
    }
    return at;
}

void TraceCache::insert(std::size_t at, const Entry& entry) {
    table_[at] = {trial_, static_cast<std::int32_t>(entries_.size())};
    entries_.push_back(entry);
    if (2 * entries_.size() <= table_.size()) {
        return;
    }
    table_.assign(2 * table_.size(), {});
    for (std::size_t n = 0; n < entries_.size(); ++n) {
        table_[slot(entries_[n].a, entries_[n].b)] = {trial_, static_cast<std::int32_t>(n)};
    }
}

} // namespace foldless
