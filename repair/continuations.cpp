#include <foldless/repair/continuations.h>

#include <foldless/io/corner.h>
#include <foldless/predicates/scan_normal.h>

#include <algorithm>
#include <set>
#include <tuple>

namespace foldless {

namespace {

using Pair = std::pair<std::int32_t, std::int32_t>;

struct Candidate {
    double bend; ///< less the cosine of the angle between the normals
    Pair faces;
};

Vec3 unit_normal(const Scan& scan, std::int32_t number) {
    const Triangle& face = scan.faces[number];
    return ScanNormal({scan.positions[face[0]], scan.positions[face[1]], scan.positions[face[2]]}).normalised().value();
}

} // namespace

std::vector<Pair> continuations(const Scan& scan, std::span<const std::int32_t> faces, std::int32_t a, std::int32_t b) {
    if (faces.size() > most_faces_continued) {
        return {};
    }
    std::vector<Candidate> candidates;
    for (const std::int32_t forward : faces) {
        for (const std::int32_t backward : faces) {
            if (runs_along(scan.faces[forward], a, b) && runs_along(scan.faces[backward], b, a)) {
                candidates.push_back(
                    {-unit_normal(scan, forward).dot(unit_normal(scan, backward)), std::minmax(forward, backward)});
            }
        }
    }
    std::ranges::sort(candidates, [](const Candidate& one, const Candidate& other) {
        return std::tie(one.bend, one.faces) < std::tie(other.bend, other.faces);
    });
    std::vector<Pair> pairs;
    std::set<std::int32_t> taken;
    for (const Candidate& candidate : candidates) {
        if (!taken.contains(candidate.faces.first) && !taken.contains(candidate.faces.second)) {
            pairs.push_back(candidate.faces);
            taken.insert({candidate.faces.first, candidate.faces.second});
        }
    }
    return pairs;
}

} // namespace foldless
