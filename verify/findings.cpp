#include <foldless/verify/findings.h>

#include <algorithm>
#include <tuple>

namespace foldless::verification {
namespace {

auto key(const LocatedViolation& v) {
    return std::tuple(v.scan_vertex, v.scan_face, v.base_face, v.position.x(), v.position.y(), v.position.z());
}

std::size_t index(Violation violation) {
    return static_cast<std::size_t>(violation);
}

} // namespace

void Findings::Local::keep(const LocatedViolation& violation) {
    std::vector<LocatedViolation>& list = first[index(violation.violation)];
    const auto before = [](const LocatedViolation& a, const LocatedViolation& b) { return key(a) < key(b); };
    list.insert(std::upper_bound(list.begin(), list.end(), violation, before), violation);
    if (list.size() > located_of_each_kind) {
        list.pop_back();
    }
}

void Findings::add(const LocatedViolation& violation) {
    Local& local = local_.local();
    ++local.counts[index(violation.violation)];
    local.keep(violation);
}

void Findings::write(VerifyResult& result) const {
    Local all;
    for (const Local& local : local_) {
        for (std::size_t kind = 0; kind < violation_count; ++kind) {
            all.counts[kind] += local.counts[kind];
            for (const LocatedViolation& violation : local.first[kind]) {
                all.keep(violation);
            }
        }
    }
    result.violations = all.counts;
    for (const std::vector<LocatedViolation>& list : all.first) {
        result.located.insert(result.located.end(), list.begin(), list.end());
    }
}

} // namespace foldless::verification
