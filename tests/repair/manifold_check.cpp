#include "manifold_check.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace foldless::test {

namespace {

bool has(const Triangle& face, std::int32_t vertex) {
    return std::ranges::find(face, vertex) != face.end();
}

std::string flaw_of_face(const Scan& scan, const Triangle& face) {
    for (const std::int32_t vertex : face) {
        if (vertex < 0 || static_cast<std::size_t>(vertex) >= scan.positions.size()) {
            return "index out of range";
        }
        if (!scan.positions[vertex].allFinite()) {
            return "not finite";
        }
    }
    if (std::set<std::int32_t>(face.begin(), face.end()).size() < 3) {
        return "repeated index";
    }
    const Vec3 e1 = scan.positions[face[1]] - scan.positions[face[0]];
    const Vec3 e2 = scan.positions[face[2]] - scan.positions[face[0]];
    return e1.cross(e2) == Vec3::Zero() ? "zero area" : "";
}

/// Each directed edge once: at most two faces an edge, and these run along it in opposite directions.
std::string flaw_of_edges(const Scan& scan) {
    std::set<std::pair<std::int32_t, std::int32_t>> seen;
    for (const Triangle& face : scan.faces) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (!seen.emplace(face[i], face[(i + 1) % 3]).second) {
                return "an edge with two faces in one direction";
            }
        }
    }
    return "";
}

/// Whether the faces at the vertex are all reached from one of them over edges at the vertex.
bool is_one_fan(const Scan& scan, std::int32_t vertex) {
    std::vector<Triangle> open;
    std::ranges::copy_if(scan.faces, std::back_inserter(open), [=](const Triangle& face) { return has(face, vertex); });
    if (open.empty()) {
        return false;
    }
    std::vector<Triangle> reached{open.back()};
    open.pop_back();
    for (std::size_t i = 0; i < reached.size(); ++i) {
        const Triangle from = reached[i];
        const auto beside = [&](const Triangle& face) {
            return std::ranges::count_if(face, [&](std::int32_t v) { return has(from, v); }) == 2;
        };
        std::ranges::copy_if(open, std::back_inserter(reached), beside);
        std::erase_if(open, beside);
    }
    return open.empty();
}

std::string flaw_of_faces(const Scan& scan) {
    std::set<std::set<std::int32_t>> seen;
    for (const Triangle& face : scan.faces) {
        if (const std::string flaw = flaw_of_face(scan, face); !flaw.empty()) {
            return flaw;
        }
        if (!seen.emplace(face.begin(), face.end()).second) {
            return "a face twice";
        }
    }
    return scan.faces.empty() ? "no faces" : "";
}

} // namespace

std::string flaw_of(const Scan& scan) {
    if (const std::string flaw = flaw_of_faces(scan); !flaw.empty()) {
        return flaw;
    }
    if (const std::string flaw = flaw_of_edges(scan); !flaw.empty()) {
        return flaw;
    }
    for (std::size_t vertex = 0; vertex < scan.positions.size(); ++vertex) {
        if (!is_one_fan(scan, static_cast<std::int32_t>(vertex))) {
            return "a vertex without exactly one fan";
        }
    }
    return "";
}

} // namespace foldless::test
