#include "mutations.h"

#include "cgal_base.h"
#include "openmesh_base.h"

#include <foldless/decimate/decimate.h>
#include <foldless/io/bounding_box.h>
#include <foldless/io/float32.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace foldless::test {
namespace {

/// A vertex that some face uses.
std::int32_t used_vertex(const std::vector<Triangle>& faces, Random& random) {
    const Triangle& face = faces[index(random, faces.size())];
    return face[index(random, 3)];
}

Vec3 direction(Random& random) {
    for (;;) {
        const double x = uniform(random, -1, 1);
        const double y = uniform(random, -1, 1);
        const Vec3 v(x, y, uniform(random, -1, 1));
        if (v.norm() < 1 && v.norm() > 0.1) {
            return v.normalized();
        }
    }
}

/// Moves a base vertex, which is no scan vertex any more.
void move_base_vertex(BaseMesh& base, std::int32_t vertex, const Vec3& to) {
    base.positions[vertex] = to_float32(to);
    base.scan_vertex[vertex] = -1;
}

std::set<std::int32_t> neighbours(const std::vector<Triangle>& faces, std::int32_t vertex) {
    std::set<std::int32_t> result;
    for (const Triangle& face : faces) {
        if (std::find(face.begin(), face.end(), vertex) != face.end()) {
            result.insert(face.begin(), face.end());
        }
    }
    result.erase(vertex);
    return result;
}

/// Collapses edges to their midpoints or to an end, with the mean direction of both ends and ranges wide enough for
/// both: all that keeps it a manifold is the link condition. No border vertex takes part.
void collapse_unguarded(BaseMesh& base, Random& random) {
    std::set<std::pair<std::int32_t, std::int32_t>> sides;
    for (const Triangle& face : base.faces) {
        for (int k = 0; k < 3; ++k) {
            sides.insert({face[k], face[(k + 1) % 3]});
        }
    }
    std::set<std::int32_t> border;
    for (const auto& [a, b] : sides) {
        if (!sides.contains({b, a})) {
            border.insert({a, b});
        }
    }
    for (int attempt = 0; attempt < 50; ++attempt) {
        const Triangle& face = base.faces[index(random, base.faces.size())];
        const int k = index(random, 3);
        const std::int32_t a = face[k];
        const std::int32_t b = face[(k + 1) % 3];
        const std::set<std::int32_t> around_a = neighbours(base.faces, a);
        const std::set<std::int32_t> around_b = neighbours(base.faces, b);
        const auto common =
            std::count_if(around_a.begin(), around_a.end(), [&](std::int32_t v) { return around_b.contains(v); });
        if (common != 2 || border.contains(a) || border.contains(b) || base.faces.size() <= 6) {
            continue;
        }
        if (index(random, 2) == 0) {
            move_base_vertex(base, a, 0.5 * (base.positions[a] + base.positions[b]));
            base.directions[a] = to_float32(0.5 * (base.directions[a] + base.directions[b]));
        }
        Range widest{0, 0};
        for (std::size_t f = 0; f < base.faces.size(); ++f) {
            const Triangle& at = base.faces[f];
            if (std::find(at.begin(), at.end(), a) != at.end() || std::find(at.begin(), at.end(), b) != at.end()) {
                widest = {std::min(widest.lo, base.ranges[f].lo), std::max(widest.hi, base.ranges[f].hi)};
            }
        }
        const double room = uniform(random, 0, 0.1) * (1 + widest.hi - widest.lo);
        std::vector<Triangle> faces;
        std::vector<Range> ranges;
        for (std::size_t f = 0; f < base.faces.size(); ++f) {
            Triangle at = base.faces[f];
            std::replace(at.begin(), at.end(), b, a);
            const auto count = std::count(at.begin(), at.end(), a);
            if (count < 2) {
                faces.push_back(at);
                ranges.push_back(count == 1 ? Range{widest.lo - room, widest.hi + room} : base.ranges[f]);
            }
        }
        base.faces = std::move(faces);
        base.ranges = std::move(ranges);
        return;
    }
}

/// The scan vertex beyond a neighbour, if share > 1, or on the way to it.
void push(Scan& scan, std::pair<double, double> share, Random& random) {
    const std::int32_t vertex = used_vertex(scan.faces, random);
    const std::set<std::int32_t> around = neighbours(scan.faces, vertex);
    const std::int32_t towards = *std::next(around.begin(), index(random, around.size()));
    const Vec3 step = scan.positions[towards] - scan.positions[vertex];
    scan.positions[vertex] = to_float32(scan.positions[vertex] + uniform(random, share.first, share.second) * step);
}

void cut(Range& range, Random& random) {
    const double size = range.hi - range.lo;
    const double share = uniform(random, 0.02, 0.4) * size;
    (index(random, 2) == 0 ? range.lo : range.hi) += range.hi > range.lo ? share : 0.0;
    if (range.lo > range.hi) {
        range.hi = range.lo;
    }
    range = {to_float32(Vec3(range.lo, 0, 0)).x(), to_float32(Vec3(range.hi, 0, 0)).x()};
}

void widen(Range& range, Random& random) {
    const double size = std::max(range.hi - range.lo, 0.01);
    range.lo -= uniform(random, 0, 3) * size;
    range.hi += uniform(random, 0, 3) * size;
}

void spoil_scan(Scan& scan, Mutation mutation, Random& random) {
    if (mutation == Mutation::scan_vertex_pushed) {
        push(scan, {1.05, 2.0}, random);
    } else if (mutation == Mutation::scan_vertex_half_pushed) {
        push(scan, {0.3, 0.9}, random);
    } else if (mutation == Mutation::scan_vertex_moved) {
        const std::int32_t vertex = used_vertex(scan.faces, random);
        scan.positions[vertex] =
            to_float32(scan.positions[vertex] + 0.05 * bounding_box_diagonal(scan) * direction(random));
    } else if (mutation == Mutation::scan_vertices_swapped) {
        const Triangle& face = scan.faces[index(random, scan.faces.size())];
        std::swap(scan.positions[face[0]], scan.positions[face[1]]);
    }
}

void leave_out(Pair& pair, Random& random) {
    const int kind = index(random, 3);
    if (kind == 0) {
        pair.scan = without_star(pair.scan, used_vertex(pair.scan.faces, random));
    } else if (kind == 1) {
        pair.scan.faces.erase(pair.scan.faces.begin() + index(random, pair.scan.faces.size()));
    } else {
        const int face = index(random, pair.base.faces.size());
        pair.base.faces.erase(pair.base.faces.begin() + face);
        pair.base.ranges.erase(pair.base.ranges.begin() + face);
    }
}

/// A kept vertex whose scan vertex moved goes with it half of the time, so that more than equality is tried.
void follow_kept_vertices(Pair& pair, Random& random) {
    for (std::size_t b = 0; b < pair.base.positions.size(); ++b) {
        const std::int32_t s = pair.base.scan_vertex[b];
        if (s >= 0 && pair.base.positions[b] != pair.scan.positions[s]) {
            if (index(random, 4) > 0) {
                pair.base.positions[b] = pair.scan.positions[s];
            } else {
                pair.base.scan_vertex[b] = -1;
            }
        }
    }
}

void spoil_base(Pair& pair, Mutation mutation, Random& random) {
    BaseMesh& base = pair.base;
    const std::int32_t vertex = used_vertex(base.faces, random);
    switch (mutation) {
    case Mutation::direction_flipped: base.directions[vertex] = -base.directions[vertex]; break;
    case Mutation::direction_bent:
        base.directions[vertex] = to_float32(
            base.directions[vertex] + uniform(random, 0.1, 1.2) * base.directions[vertex].norm() * direction(random));
        break;
    case Mutation::base_vertices_swapped: {
        const Triangle& face = base.faces[index(random, base.faces.size())];
        std::swap(base.positions[face[0]], base.positions[face[1]]);
        std::swap(base.scan_vertex[face[0]], base.scan_vertex[face[1]]);
        break;
    }
    case Mutation::base_vertex_moved:
        move_base_vertex(base, vertex,
                         base.positions[vertex] + 0.05 * bounding_box_diagonal(pair.scan) * direction(random));
        break;
    case Mutation::range_cut: cut(base.ranges[index(random, base.ranges.size())], random); break;
    case Mutation::range_widened: widen(base.ranges[index(random, base.ranges.size())], random); break;
    case Mutation::hole: leave_out(pair, random); break;
    case Mutation::unguarded:
        for (int n = 1 + index(random, 3); n > 0; --n) {
            collapse_unguarded(base, random);
        }
        break;
    case Mutation::by_openmesh: base = openmesh_base(pair.scan, base.faces.size(), random); break;
    case Mutation::by_cgal: base = cgal_base(pair.scan, base.faces.size(), random); break;
    default: break;
    }
}

} // namespace

std::string_view name(Mutation mutation) {
    static constexpr std::array<std::string_view, mutation_count> names{
        "none",
        "direction flipped",
        "direction bent",
        "base vertices swapped",
        "scan vertices swapped",
        "base vertex moved",
        "scan vertex moved",
        "range cut",
        "range widened",
        "scan vertex pushed",
        "scan vertex half pushed",
        "hole",
        "unguarded",
        "by OpenMesh",
        "by CGAL",
    };
    return names[static_cast<std::size_t>(mutation)];
}

Pair random_pair(Random& random) {
    const Scan scan = index(random, 3) == 0 ? random_open_scan(random) : random_closed_scan(random);
    DecimateOptions options;
    options.threads = 1;
    options.placement = index(random, 3) == 0 ? Placement::midpoint : Placement::best;
    options.directions = index(random, 3) == 0 ? Directions::area : Directions::visible;
    if (index(random, 2) == 0) {
        options.target_faces = 8 + index(random, scan.faces.size());
    }
    return {decimate(scan, options).base, scan};
}

Pair mutated(const Pair& pair, Mutation mutation, Random& random) {
    Pair result = pair;
    spoil_base(result, mutation, random);
    spoil_scan(result.scan, mutation, random);
    if (mutation != Mutation::hole) {
        follow_kept_vertices(result, random);
    }
    return result;
}

} // namespace foldless::test
