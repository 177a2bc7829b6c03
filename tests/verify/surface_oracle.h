/// \file
/// Does a base mesh represent a scan? An answer in rational arithmetic that shares no code with the library and takes
/// another way than verify() does, to be compared with it. For closed scans and locked borders; slow.
///
/// - Places: all roots of every vertex's cubic in every prismoid, by Sturm's theorem.
/// - Scan edges: in each prismoid s is a function of t, so the roots of all walls, of both ends and of w cut its range
///   into intervals; one rational sample of each says whether the lift is there. The pieces of all prismoids are linked
///   into a graph, and the piece of it that holds the place of one end must be a path to a place of the other. Nothing
///   is followed step by step. m > 0 is asked all along.
/// - Choice of places: one vertex of a part of the scan fixes all others.
/// - Insides: for every scan triangle and every base edge, the parts of the base edge whose displaced points lie in the
///   triangle are intervals of its own coordinate lambda. Those that hang together with the lifted border are its
///   image. Every base edge must be tiled by them: each end meets exactly one other, and nothing is left over. This
///   replaces both the parities of theorem B and the count of the degree.
#pragma once

#include <foldless/io/base_mesh.h>
#include <foldless/io/scan.h>

#include <string>

namespace foldless::oracle {

struct Judgement {
    enum class Kind {
        represents,
        refused,
        tie, ///< something lies exactly on a wall or pillar, or in a slice, where this oracle has no opinion
    };
    Kind kind;
    std::string reason; ///< of refusal: what failed first
};

/// \pre both meshes are manifold and oriented; the base mesh has directions per vertex, ranges and scan vertices
[[nodiscard]] Judgement judge(const BaseMesh& base, const Scan& scan);

} // namespace foldless::oracle
