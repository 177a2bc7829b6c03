/// \file
/// Which faces meet at a vertex and across an edge, from nothing but the list of faces.
#pragma once

#include <foldless/io/scan.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// The parts of the verifier. A namespace of their own keeps them apart from the decimator's, which have the same names
/// for the same things of the papers and are judged by these.
namespace foldless::verification {

/// The corner of a triangle that is the vertex, or -1.
[[nodiscard]] inline int corner_of(const Triangle& triangle, std::int32_t vertex) {
    for (int k = 0; k < 3; ++k) {
        if (triangle[k] == vertex) {
            return k;
        }
    }
    return -1;
}

/// Faces around a vertex, counter-clockwise, each sharing an edge with the next.
struct Fan {
    std::vector<std::int32_t> faces;
    bool closed = false; ///< the last shares an edge with the first
};

/// The incidences of a mesh without defects. Keeps a reference to the faces, which must outlive it.
class Adjacency {
public:
    /// Time O(n) for bounded valences; an edge costs the smaller valence of its ends. Memory: 24 bytes a face, 4 a
    /// vertex.
    Adjacency(std::size_t vertices, const std::vector<Triangle>& faces);

    /// The faces around a vertex in ascending order; empty for a vertex that no face uses.
    [[nodiscard]] std::span<const std::int32_t> faces_around(std::int32_t vertex) const {
        return {around_.data() + first_[vertex], around_.data() + first_[vertex + 1]};
    }
    /// The face across the edge opposite corner k, or -1.
    [[nodiscard]] std::int32_t neighbour(std::int32_t face, int k) const { return neighbours_[face][k]; }
    /// The face that runs along the edge in this direction, or -1.
    [[nodiscard]] std::int32_t face_with(std::int32_t from, std::int32_t to) const;

    /// The fans of those faces around the vertex for which `included` is true, by their lowest face or, where open, in
    /// the order of their first face.
    template <class Included>
    [[nodiscard]] std::vector<Fan> fans(std::int32_t vertex, Included included) const;

    /// The far ends of the edges that the faces of a fan have at the vertex: one more than faces if it is open.
    [[nodiscard]] std::vector<std::int32_t> spokes(std::int32_t vertex, const Fan& fan) const;

private:
    [[nodiscard]] std::int32_t next_around(std::int32_t vertex, std::int32_t face, int step) const;

    const std::vector<Triangle>& faces_;
    std::vector<std::uint32_t> first_;
    std::vector<std::int32_t> around_;
    std::vector<Triangle> neighbours_;
};

template <class Included>
std::vector<Fan> Adjacency::fans(std::int32_t vertex, Included included) const {
    std::vector<Fan> result;
    std::size_t met = 0;
    std::size_t wanted = 0;
    const auto walk = [&](std::int32_t start) {
        Fan fan;
        std::int32_t face = start;
        do {
            fan.faces.push_back(face);
            face = next_around(vertex, face, 1);
        } while (face >= 0 && face != start && included(face));
        fan.closed = face == start;
        met += fan.faces.size();
        result.push_back(std::move(fan));
    };
    std::int32_t any = -1;
    for (const std::int32_t face : faces_around(vertex)) {
        if (!included(face)) {
            continue;
        }
        ++wanted;
        any = any < 0 ? face : any;
        const std::int32_t before = next_around(vertex, face, 2);
        if (before < 0 || !included(before)) {
            walk(face);
        }
    }
    if (met < wanted) { // no face is the first of its fan: a full cycle
        walk(any);
    }
    return result;
}

} // namespace foldless::verification
