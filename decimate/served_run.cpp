#include <foldless/decimate/served_run.h>

#include <foldless/predicates/visible_direction.h>

#include <optional>
#include <vector>

namespace foldless {

ServedRun longest_served_run(std::span<const Vec3> unit_normals, bool closed) {
    // A part of what one direction sees is seen, too: so the longest run that ends at each face begins no earlier than
    // that of the face before.
    const std::size_t n = unit_normals.size();
    ServedRun best{0, 0, Vec3::UnitZ()};
    std::vector<Vec3> run;
    std::size_t first = 0;
    for (std::size_t last = 0; last < (closed ? 2 * n : n) && run.size() < n; ++last) {
        run.push_back(unit_normals[last % n]);
        std::optional<Vec3> direction = most_visible_direction(run);
        while (!direction && !run.empty()) { // empty after a face too small to have a normal
            run.erase(run.begin());
            ++first;
            direction = most_visible_direction(run);
        }
        if (run.size() > best.count) {
            best = {first % n, run.size(), *direction};
        }
    }
    return best;
}

} // namespace foldless
