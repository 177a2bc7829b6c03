#include <foldless/verify/needed_ranges.h>

#include <foldless/verify/face_checks.h>
#include <foldless/verify/scan_image.h>

#include <foldless/io/float32.h>
#include <foldless/predicates/jacobian.h>
#include <foldless/predicates/pillar.h>

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foldless::verification {
namespace {

/// How much farther each search goes than the one before: few searches, none of which reaches much too far.
constexpr double growth_of_reach = 4.0;

double mean_edge_length(const BaseFaces& faces) {
    double sum = 0.0;
    for (const std::int32_t face : faces.moving()) {
        const auto& v = faces.face(face).triangle.v;
        sum += (v[1] - v[0]).norm() + (v[2] - v[1]).norm() + (v[0] - v[2]).norm();
    }
    return sum / (3.0 * static_cast<double>(faces.moving().size()));
}

/// No displacement is longer than the diagonal of the box around both meshes.
double longest_displacement(const Meshes& meshes) {
    Box box;
    for (const auto* positions : {&meshes.base.positions, &meshes.scan.positions}) {
        std::for_each(positions->begin(), positions->end(), [&](const Vec3& p) { box.extend(p); });
    }
    return box.diagonal().norm();
}

/// Gives every moving face its fold-free range, as far as displacements of the length `reach` go.
void set_search_ranges(BaseFaces& faces, double reach) {
    for (const std::int32_t f : faces.moving()) {
        const BaseTriangle& triangle = faces.face(f).triangle;
        const double longest = std::max({triangle.d[0].norm(), triangle.d[1].norm(), triangle.d[2].norm()});
        const Range fold_free = fold_free_range(triangle);
        const double t = longest > 0 ? reach / longest : 0.0;
        // The ends of the fold-free range are rounded: a little less, so that it is one.
        constexpr double part = 0.999;
        faces.set_range(f, {std::max(part * fold_free.lo, -t), std::min(part * fold_free.hi, t)});
    }
}

/// The nearest of all places that are found, for every vertex that has none yet.
void locate_nearest(const BaseFaces& faces, const Meshes& meshes, const std::vector<std::int32_t>& vertices,
                    std::vector<Place>& places) {
    const PrismoidIndex index(faces);
    tbb::parallel_for(std::size_t(0), vertices.size(), [&](std::size_t i) {
        const std::int32_t vertex = vertices[i];
        const Located located = locate(faces, index, meshes.scan.positions[vertex]);
        for (const Place& place : located.places) {
            const Vec3& q = meshes.scan.positions[vertex];
            const bool nearer = !places[vertex].exists() || std::abs(displacement(faces, place, q)) <
                                                                std::abs(displacement(faces, places[vertex], q));
            places[vertex] = nearer ? place : places[vertex];
        }
    });
}

/// The hull of the displacements needed in each face, gathered from many threads: its order does not matter.
class Hulls {
public:
    explicit Hulls(std::size_t faces) : local_(std::vector<Range>(faces, nothing)) {}

    void add(std::int32_t face, Range t) {
        Range& range = local_.local()[face];
        range = {std::min(range.lo, t.lo), std::max(range.hi, t.hi)};
    }

    /// The hull rounded outwards to float32; [0, 0] where nothing was added.
    [[nodiscard]] Range of(std::int32_t face) const {
        Range hull = nothing;
        for (const std::vector<Range>& some : local_) {
            hull = {std::min(hull.lo, some[face].lo), std::max(hull.hi, some[face].hi)};
        }
        return hull.lo <= hull.hi ? Range{float32_below(hull.lo), float32_above(hull.hi)} : Range{0.0, 0.0};
    }

private:
    static constexpr Range nothing{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

    tbb::enumerable_thread_specific<std::vector<Range>> local_;
};

/// Adds what one scan face needs.
void add_needs(const Correspondents& all, std::int32_t scan_face, Hulls& hulls) {
    for (const std::int32_t vertex : all.scan.faces[scan_face]) {
        const Place& place = all.association.place(vertex);
        for (const std::int32_t face : faces_of(all.base, place)) {
            hulls.add(face, place.at.t.bounds());
        }
    }
    if (all.base.constant_directions()) {
        return;
    }
    const ScanImage image = image_of(all, scan_face);
    for (const WallCrossing& crossing : image.crossings) {
        hulls.add(crossing.face, crossing.t.bounds());
        hulls.add(crossing.next_face, crossing.t.bounds());
    }
    if (!image.inside) {
        return;
    }
    const BaseMesh& mesh = all.base.mesh();
    for (const std::int32_t vertex : *image.inside) {
        const Range t =
            displacement_at_plane({mesh.positions[vertex], mesh.directions[vertex]}, all.triangle(scan_face));
        for (const std::int32_t face : all.base.adjacency().faces_around(vertex)) {
            hulls.add(face, t);
        }
    }
}

/// The used vertices that are not kept, to be placed.
std::vector<std::int32_t> open_vertices(const BaseFaces& faces, const Meshes& meshes) {
    std::vector<std::uint8_t> used(meshes.scan.positions.size(), 0);
    for (std::size_t f = 0; f < meshes.scan.faces.size(); ++f) {
        for (const std::int32_t vertex : meshes.scan.faces[f]) {
            const bool moves = !faces.scan_face_is_frozen(static_cast<std::int32_t>(f));
            used[vertex] = moves || used[vertex] != 0 ? 1 : 0;
        }
    }
    std::vector<std::int32_t> open;
    for (std::size_t v = 0; v < used.size(); ++v) {
        if (used[v] != 0 && meshes.kept.base_of[v] < 0) {
            open.push_back(static_cast<std::int32_t>(v));
        }
    }
    return open;
}

/// Kept vertices at t = 0, and the others where they were found.
Association association_of(const BaseFaces& faces, const Meshes& meshes, const std::vector<Place>& places) {
    Association association(faces, meshes);
    for (std::size_t b = 0; b < meshes.kept.scan_of.size(); ++b) {
        const auto vertex = static_cast<std::int32_t>(b);
        const auto around = meshes.base_adjacency.faces_around(vertex);
        const auto moving =
            std::find_if(around.begin(), around.end(), [&](std::int32_t f) { return faces.is_moving(f); });
        if (faces.is_kept(vertex) && moving != around.end()) {
            const PrismoidPoint at = on_pillar(faces, *moving, vertex, Displacement());
            static_cast<void>(association.set(meshes.kept.scan_of[b], {*moving, at, vertex}));
        }
    }
    for (std::size_t v = 0; v < places.size(); ++v) {
        if (places[v].exists()) {
            static_cast<void>(association.set(static_cast<std::int32_t>(v), places[v]));
        }
    }
    return association;
}

} // namespace

void set_needed_ranges(BaseFaces& faces, const Meshes& meshes, Stages& stages, double share) {
    if (faces.moving().empty()) {
        return;
    }
    std::vector<Place> places(meshes.scan.positions.size());
    std::vector<std::int32_t> open = open_vertices(faces, meshes);
    const double longest = longest_displacement(meshes);
    double reach = mean_edge_length(faces);
    set_search_ranges(faces, std::min(reach, longest));
    while (!open.empty() && !stages.cancelled()) {
        locate_nearest(faces, meshes, open, places);
        std::erase_if(open, [&](std::int32_t vertex) { return places[vertex].exists(); });
        if (open.empty() || reach >= longest) {
            break;
        }
        reach *= growth_of_reach;
        set_search_ranges(faces, std::min(reach, longest));
    }
    const Association association = association_of(faces, meshes, places);
    const Correspondents all{faces, meshes.scan, association};
    Hulls hulls(meshes.base.faces.size());
    stages.for_each(meshes.scan.faces.size(), share, [&](std::size_t f) {
        const auto face = static_cast<std::int32_t>(f);
        if (!faces.scan_face_is_frozen(face) && all.has_places(face)) {
            add_needs(all, face, hulls);
        }
    });
    for (const std::int32_t face : faces.moving()) {
        faces.set_range(face, hulls.of(face));
    }
}

} // namespace foldless::verification
