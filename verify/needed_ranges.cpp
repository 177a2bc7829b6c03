#include <foldless/verify/needed_ranges.h>

#include <foldless/verify/scan_image.h>

#include <foldless/predicates/jacobian.h>

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
        faces.set_range(f, {std::max(fold_free.lo, -t), std::min(fold_free.hi, t)});
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
            const bool nearer = !places[vertex].exists() ||
                                std::abs(displacement(faces, place)) < std::abs(displacement(faces, places[vertex]));
            places[vertex] = nearer ? place : places[vertex];
        }
    });
}

/// The hull of the displacements needed in each face, gathered from many threads: its order does not matter.
class Hulls {
public:
    explicit Hulls(std::size_t faces) : local_(std::vector<Range>(faces, nothing)) {}

    void add(std::int32_t face, double t, double t_error) {
        Range& range = local_.local()[face];
        range = {std::min(range.lo, t - t_error), std::max(range.hi, t + t_error)};
    }

    /// The hull rounded outwards to float32; [0, 0] where nothing was added.
    [[nodiscard]] Range of(std::int32_t face) const {
        Range hull = nothing;
        for (const std::vector<Range>& some : local_) {
            hull = {std::min(hull.lo, some[face].lo), std::max(hull.hi, some[face].hi)};
        }
        return hull.lo <= hull.hi ? Range{-rounded_up(-hull.lo), rounded_up(hull.hi)} : Range{0.0, 0.0};
    }

private:
    static constexpr Range nothing{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

    static double rounded_up(double x) {
        const float rounded = static_cast<float>(x);
        return rounded >= x ? rounded : std::nextafter(rounded, std::numeric_limits<float>::infinity());
    }

    tbb::enumerable_thread_specific<std::vector<Range>> local_;
};

/// Adds what one scan face needs.
class FaceNeeds {
public:
    FaceNeeds(const Correspondents& all, std::int32_t scan_face, Hulls& hulls)
        : all_(all), scan_face_(scan_face), hulls_(hulls) {}

    void add() {
        for (int k = 0; k < 3; ++k) {
            footholds(all_.base, all_.place(scan_face_, k), corners_[k]);
            for (const Foothold& foothold : corners_[k]) {
                need(foothold.face, foothold.t, foothold.t_error);
            }
        }
        for (int k = 0; k < 3 && !all_.base.constant_directions(); ++k) {
            add_edge(k, (k + 1) % 3);
        }
        if (spans_faces_) {
            add_pillars();
        }
    }

private:
    void need(std::int32_t face, double t, double t_error) {
        hulls_.add(face, t, t_error);
        if (std::find(met_.begin(), met_.end(), face) == met_.end()) {
            met_.push_back(face);
        }
    }

    void add_edge(int a, int b) {
        if (is_base_edge(all_.base, all_.place(scan_face_, a), all_.place(scan_face_, b))) {
            return;
        }
        const ScanTriangle triangle = all_.triangle(scan_face_);
        const Trace traced = trace(all_.base, {triangle[a], triangle[b]}, corners_[a], corners_[b]);
        for (const WallCrossing& crossing : traced.crossings) {
            spans_faces_ = true;
            need(crossing.face, crossing.t, crossing.t_error);
            need(crossing.next_face, crossing.t, crossing.t_error);
        }
    }

    /// The pillars inside the triangle, found by going on from face to face.
    void add_pillars() {
        std::vector<std::int32_t> asked;
        for (std::size_t i = 0; i < met_.size(); ++i) {
            for (const std::int32_t vertex : all_.base.face(met_[i]).corners) {
                if (std::find(asked.begin(), asked.end(), vertex) == asked.end()) {
                    asked.push_back(vertex);
                    add_pillar(vertex);
                }
            }
        }
    }

    void add_pillar(std::int32_t vertex) {
        const std::optional<ScanPoint> point = pierced_at(
            all_.base.mesh().positions[vertex], all_.base.mesh().directions[vertex], all_.triangle(scan_face_));
        if (!point) {
            return;
        }
        const Lifted lifted = lift(all_, scan_face_, spans_faces, *point);
        if (!lifted.place || corner_of(all_.base.face(lifted.place->face).corners, vertex) < 0) {
            return; // another sheet
        }
        std::vector<Foothold> around;
        footholds_at(all_.base, vertex, around);
        for (const Foothold& foothold : around) {
            need(foothold.face, lifted.place->at.t, lifted.place->at.t_error);
        }
    }

    const Correspondents& all_;
    std::int32_t scan_face_;
    Hulls& hulls_;
    std::array<std::vector<Foothold>, 3> corners_;
    std::vector<std::int32_t> met_;
    bool spans_faces_ = false;
};

/// The used vertices, kept ones placed already and the others to be placed.
std::vector<std::int32_t> place_kept(const BaseFaces& faces, const Meshes& meshes, std::vector<Place>& places) {
    std::vector<std::int32_t> open;
    std::vector<bool> used(meshes.scan.positions.size(), false);
    for (std::size_t f = 0; f < meshes.scan.faces.size(); ++f) {
        for (const std::int32_t vertex : meshes.scan.faces[f]) {
            used[vertex] = used[vertex] || !faces.scan_face_is_frozen(static_cast<std::int32_t>(f));
        }
    }
    for (std::size_t v = 0; v < used.size(); ++v) {
        places[v].kept = used[v] ? meshes.kept.base_of[v] : -1;
        if (used[v] && places[v].kept < 0) {
            open.push_back(static_cast<std::int32_t>(v));
        }
    }
    return open;
}

} // namespace

void set_needed_ranges(BaseFaces& faces, const Meshes& meshes, Stages& stages, double share) {
    if (faces.moving().empty()) {
        return;
    }
    Association association{std::vector<Place>(meshes.scan.positions.size())};
    std::vector<std::int32_t> open = place_kept(faces, meshes, association.places);
    const double longest = longest_displacement(meshes);
    double reach = mean_edge_length(faces);
    set_search_ranges(faces, std::min(reach, longest));
    while (!open.empty() && !stages.cancelled()) {
        locate_nearest(faces, meshes, open, association.places);
        std::erase_if(open, [&](std::int32_t vertex) { return association.places[vertex].exists(); });
        if (open.empty() || reach >= longest) {
            break;
        }
        reach *= growth_of_reach;
        set_search_ranges(faces, std::min(reach, longest));
    }
    const Correspondents all{faces, meshes.scan, association};
    Hulls hulls(meshes.base.faces.size());
    stages.for_each(meshes.scan.faces.size(), share, [&](std::size_t f) {
        const auto face = static_cast<std::int32_t>(f);
        if (!faces.scan_face_is_frozen(face) && all.has_places(face)) {
            FaceNeeds(all, face, hulls).add();
        }
    });
    for (const std::int32_t face : faces.moving()) {
        faces.set_range(face, hulls.of(face));
    }
}

} // namespace foldless::verification
