#include "mesh_check.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace foldless {

namespace {

using HalfEdges = std::map<std::pair<std::int32_t, std::int32_t>, std::size_t>; // from, to -> face

/// Sets that merge, by representative.
class Partition {
public:
    explicit Partition(std::size_t size) {
        parent_.reserve(size);
        for (std::size_t i = 0; i < size; ++i) {
            parent_.push_back(i);
        }
    }
    std::size_t find(std::size_t x) {
        while (parent_[x] != x) {
            x = parent_[x] = parent_[parent_[x]];
        }
        return x;
    }
    void merge(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }

private:
    std::vector<std::size_t> parent_;
};

Vec3 area_vector(const Scan& scan, const Triangle& f) {
    const Vec3& a = scan.positions[f[0]];
    return (scan.positions[f[1]] - a).cross(scan.positions[f[2]] - a);
}

bool is_bad(const Scan& scan, const Triangle& f) {
    const auto count = static_cast<std::int64_t>(scan.positions.size());
    const bool in_range = std::all_of(f.begin(), f.end(), [count](auto i) { return i >= 0 && i < count; });
    return !in_range || f[0] == f[1] || f[1] == f[2] || f[2] == f[0];
}

/// Two faces at a vertex belong to one fan if they share an edge that ends there: merges the corners (face, corner).
std::size_t count_pinched(const Scan& scan, const HalfEdges& half_edges) {
    Partition corners(3 * scan.faces.size());
    const auto corner_of = [&](std::size_t face, std::int32_t vertex) {
        const auto& f = scan.faces[face];
        return 3 * face + static_cast<std::size_t>(std::find(f.begin(), f.end(), vertex) - f.begin());
    };
    for (const auto& [ends, face] : half_edges) {
        if (const auto twin = half_edges.find({ends.second, ends.first}); twin != half_edges.end()) {
            for (const std::int32_t vertex : {ends.first, ends.second}) {
                corners.merge(corner_of(face, vertex), corner_of(twin->second, vertex));
            }
        }
    }
    std::vector<std::set<std::size_t>> fans(scan.positions.size());
    for (std::size_t face = 0; face < scan.faces.size(); ++face) {
        for (std::size_t i = 0; i < 3; ++i) {
            fans[scan.faces[face][i]].insert(corners.find(3 * face + i));
        }
    }
    return static_cast<std::size_t>(std::count_if(fans.begin(), fans.end(), [](auto& fan) { return fan.size() > 1; }));
}

void measure_boundary(const HalfEdges& half_edges, MeshCheck& check) {
    std::map<std::int32_t, std::int32_t> next;
    for (const auto& [ends, face] : half_edges) {
        if (!half_edges.contains({ends.second, ends.first})) {
            next[ends.first] = ends.second;
        }
    }
    check.boundary_edges = next.size();
    while (!next.empty()) {
        ++check.boundary_loops;
        for (auto at = next.begin(); at != next.end();) {
            const std::int32_t to = at->second;
            next.erase(at);
            at = next.find(to);
        }
    }
}

void measure_parts(const Scan& scan, MeshCheck& check) {
    Partition parts(scan.positions.size());
    std::vector<bool> used(scan.positions.size());
    for (const Triangle& f : scan.faces) {
        for (const std::int32_t vertex : f) {
            used[vertex] = true;
            parts.merge(f[0], vertex);
        }
    }
    for (std::size_t vertex = 0; vertex < used.size(); ++vertex) {
        check.unused_vertices += used[vertex] ? 0 : 1;
        check.components += used[vertex] && parts.find(vertex) == vertex ? 1 : 0;
    }
}

std::size_t count_equal(const Scan& scan) {
    std::set<std::tuple<double, double, double>> distinct;
    for (const Vec3& p : scan.positions) {
        distinct.emplace(p.x(), p.y(), p.z());
    }
    return scan.positions.size() - distinct.size();
}

bool share_a_vertex(const Triangle& f, const Triangle& g) {
    return std::any_of(f.begin(), f.end(), [&](auto v) { return std::find(g.begin(), g.end(), v) != g.end(); });
}

/// Less than this from a plane a point counts as on it: float32 rounding of shapes of size 3 makes 4e-7.
constexpr double on_plane = 1e-6;

bool passes_through(const Vec3& from, const Vec3& to, const std::array<Vec3, 3>& triangle) {
    const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).normalized();
    const double start = normal.dot(from - triangle[0]);
    const double end = normal.dot(to - triangle[0]);
    if (std::min(start, end) > -on_plane || std::max(start, end) < on_plane) {
        return false;
    }
    const Vec3 crossing = from + start / (start - end) * (to - from);
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& corner = triangle[i];
        if (normal.dot((triangle[(i + 1) % 3] - corner).cross(crossing - corner)) < 0) {
            return false;
        }
    }
    return true;
}

/// A face with its bounding box.
struct BoxedFace {
    Triangle face;
    std::array<Vec3, 3> corners;
    std::array<double, 3> low, high;
};

BoxedFace boxed(const Scan& scan, const Triangle& f) {
    BoxedFace result{f, {scan.positions[f[0]], scan.positions[f[1]], scan.positions[f[2]]}, {}, {}};
    for (int axis = 0; axis < 3; ++axis) {
        const auto [low, high] =
            std::minmax({result.corners[0][axis], result.corners[1][axis], result.corners[2][axis]});
        result.low[axis] = low;
        result.high[axis] = high;
    }
    return result;
}

bool an_edge_passes_through(const BoxedFace& f, const BoxedFace& g) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (passes_through(f.corners[i], f.corners[(i + 1) % 3], g.corners)) {
            return true;
        }
    }
    return false;
}

bool cross(const BoxedFace& f, const BoxedFace& g) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (f.high[axis] < g.low[axis] || g.high[axis] < f.low[axis]) {
            return false;
        }
    }
    return !share_a_vertex(f.face, g.face) && (an_edge_passes_through(f, g) || an_edge_passes_through(g, f));
}

} // namespace

MeshCheck check_mesh(const Scan& scan) {
    MeshCheck check;
    for (const Triangle& f : scan.faces) {
        check.bad_faces += is_bad(scan, f) ? 1 : 0;
    }
    if (check.bad_faces > 0) {
        return check;
    }
    HalfEdges half_edges;
    for (std::size_t face = 0; face < scan.faces.size(); ++face) {
        const Triangle& f = scan.faces[face];
        for (std::size_t i = 0; i < 3; ++i) {
            check.repeated_half_edges += half_edges.emplace(std::pair(f[i], f[(i + 1) % 3]), face).second ? 0 : 1;
        }
        check.flat_faces += area_vector(scan, f).squaredNorm() > 0 ? 0 : 1;
        check.volume += scan.positions[f[0]].cross(scan.positions[f[1]]).dot(scan.positions[f[2]]) / 6;
    }
    measure_boundary(half_edges, check);
    measure_parts(scan, check);
    check.pinched_vertices = count_pinched(scan, half_edges);
    check.equal_positions = count_equal(scan);
    const auto edges = static_cast<long long>((half_edges.size() + check.boundary_edges) / 2);
    check.euler_characteristic = static_cast<long long>(scan.positions.size() - check.unused_vertices) - edges +
                                 static_cast<long long>(scan.faces.size());
    return check;
}

std::vector<Vec3> normals_at(const Scan& scan, std::int32_t vertex) {
    std::vector<Vec3> normals;
    for (const Triangle& f : scan.faces) {
        if (std::find(f.begin(), f.end(), vertex) != f.end()) {
            normals.push_back(area_vector(scan, f).normalized());
        }
    }
    return normals;
}

bool crosses_itself(const Scan& scan) {
    std::vector<BoxedFace> faces;
    for (const Triangle& f : scan.faces) {
        faces.push_back(boxed(scan, f));
    }
    std::sort(faces.begin(), faces.end(), [](const auto& f, const auto& g) { return f.low[0] < g.low[0]; });
    for (std::size_t f = 0; f < faces.size(); ++f) {
        for (std::size_t g = f + 1; g < faces.size() && faces[g].low[0] <= faces[f].high[0]; ++g) {
            if (cross(faces[f], faces[g])) {
                return true;
            }
        }
    }
    return false;
}

} // namespace foldless
