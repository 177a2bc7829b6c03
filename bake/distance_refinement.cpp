#include <foldless/bake/distance_refinement.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace foldless::distances {
namespace {

/// A part of a face.
struct Part {
    SampledTriangle corners;
    double upper; ///< no point of it is further from the other surface
};

/// The halves of a part, and the furthest of the points that were looked at.
struct Halves {
    Part first;
    Part second;
    Sample furthest;
};

bool has_lower_bound(const Part& first, const Part& second) {
    return first.upper < second.upper;
}

/// Splits parts.
///
/// Where the ends of an edge are nearest to different faces, and far from each other's, neither face gives a good bound
/// for the whole edge. It is then split where both are equally far, so that each face serves one side: if the two are
/// neighbours, both halves are done at once, however small the bound, where midpoints would have to close in on the
/// place. A split keeps away from both ends, since the distance to a face changes no faster than the point moves: the
/// parts become shorter than the bound in the end, and then need no splitting.
class Splitter {
public:
    Splitter(const NearestFace& other, double bound) : other_(other), bound_(bound) {}

    /// `reached` is the largest known distance.
    [[nodiscard]] Halves split(const Part& part, double reached) const {
        const int worst = worst_edge(part.corners);
        const bool needs_both_faces = edge_bound(part.corners, worst) > reached + bound_;
        const int edge = needs_both_faces ? worst : longest_edge(part.corners);
        const Sample& a = part.corners[edge];
        const Sample& b = part.corners[(edge + 1) % 3];
        const Sample& c = part.corners[(edge + 2) % 3];
        const Vec3 at = needs_both_faces ? equally_far(a, b) : Vec3((a.position + b.position) / 2);
        const Sample middle = sample(other_, at, a.face);
        // What holds of the whole holds of a half.
        Halves halves{{{a, middle, c}, part.upper}, {{middle, b, c}, part.upper}, middle};
        lower_bound_of(halves.first, reached, halves.furthest);
        lower_bound_of(halves.second, reached, halves.furthest);
        return halves;
    }

private:
    /// By the faces nearest to the corners; if that is not enough, by the one nearest to the centroid too. Where
    /// surfaces coincide, the latter is the face that the part lies in, while corners may be just as near to others.
    void lower_bound_of(Part& part, double reached, Sample& furthest) const {
        const auto& [a, b, c] = part.corners;
        part.upper = std::min(part.upper, upper_bound(part.corners, other_));
        if (part.upper > std::max(reached, furthest.distance) + bound_) {
            const Sample centroid = sample(other_, (a.position + b.position + c.position) / 3, a.face);
            part.upper = std::min(part.upper, distance_to_face(part.corners, other_, centroid.face, part.upper));
            furthest = centroid.distance > furthest.distance ? centroid : furthest;
        }
    }

    [[nodiscard]] double distance(const Vec3& position, std::int32_t face) const {
        return std::sqrt(other_.nearest_on(face, position).squared_distance);
    }

    /// No point of the edge is further from the other surface.
    [[nodiscard]] double edge_bound(const SampledTriangle& corners, int edge) const {
        const Sample& a = corners[edge];
        const Sample& b = corners[(edge + 1) % 3];
        if (a.face == b.face) {
            return std::max(a.distance, b.distance);
        }
        return std::min(std::max(a.distance, distance(b.position, a.face)),
                        std::max(b.distance, distance(a.position, b.face)));
    }

    [[nodiscard]] int worst_edge(const SampledTriangle& corners) const {
        const double bounds[] = {edge_bound(corners, 0), edge_bound(corners, 1), edge_bound(corners, 2)};
        return static_cast<int>(std::max_element(bounds, bounds + 3) - bounds);
    }

    [[nodiscard]] static int longest_edge(const SampledTriangle& corners) {
        const auto length = [&](int edge) {
            return (corners[(edge + 1) % 3].position - corners[edge].position).squaredNorm();
        };
        const double lengths[] = {length(0), length(1), length(2)};
        return static_cast<int>(std::max_element(lengths, lengths + 3) - lengths);
    }

    /// A point between a and b that is as far from the face of a as from that of b, to a fraction of the bound.
    [[nodiscard]] Vec3 equally_far(const Sample& a, const Sample& b) const {
        constexpr int most_halvings = 48; // of [0, 1] in doubles
        double low = 0.0;                 // the face of a is nearer
        double high = 1.0;                // the face of b is
        Vec3 at;
        for (int i = 0; i < most_halvings; ++i) {
            const double t = (low + high) / 2;
            at = a.position + t * (b.position - a.position);
            const double difference = distance(at, a.face) - distance(at, b.face);
            if (std::abs(difference) <= bound_ / 4) {
                break;
            }
            (difference < 0.0 ? low : high) = t;
        }
        return at;
    }

    const NearestFace& other_;
    double bound_;
};

/// What became of a part in a round.
struct Progress {
    Sample furthest;        ///< of the new samples
    double settled = 0.0;   ///< the largest bound of what needs no more splitting
    std::vector<Part> open; ///< what still does
};

/// The rounds.
class Refinement {
public:
    Refinement(const SampledSurface& surface, const std::vector<Triangle>& faces, const NearestFace& other,
               double bound)
        : surface_(surface), faces_(faces), splitter_(other, bound), bound_(bound), furthest_(surface.furthest) {
        for (std::size_t face = 0; face < faces.size(); ++face) {
            if (surface.upper[face] > enough()) {
                open_faces_.emplace_back(surface.upper[face], static_cast<std::int32_t>(face));
            } else {
                settled_ = std::max(settled_, surface.upper[face]);
            }
        }
        std::sort(open_faces_.begin(), open_faces_.end());
    }

    Maximum run(BlockLoop& loop, double share) {
        const std::size_t all = open_faces_.size();
        while (!loop.cancelled() && take_round()) {
            refine_round();
            loop.report_within(share, 1.0 - static_cast<double>(open_faces_.size()) / static_cast<double>(all));
        }
        loop.finish(share);
        return {furthest_, std::max(furthest_.distance, settled_)};
    }

private:
    /// Parts in a round: enough for many threads, few enough that the next round soon knows what this one has reached.
    static constexpr std::size_t parts_in_round = 256;

    /// Splits of a part in a round: some ten microseconds of work, and samples that the other parts do not need.
    static constexpr int splits_in_round = 32;

    /// A bound that need not be lowered.
    [[nodiscard]] double enough() const { return furthest_.distance + bound_; }

    /// Fills the round: parts of faces that were begun, the last ones first, then the next faces. False at the end.
    bool take_round() {
        round_.clear();
        while (round_.size() < parts_in_round && !open_parts_.empty()) {
            take(std::move(open_parts_.back()));
            open_parts_.pop_back();
        }
        while (round_.size() < parts_in_round && !open_faces_.empty()) {
            const auto [upper, face] = open_faces_.back();
            take({surface_.corners(faces_[face]), upper});
            open_faces_.pop_back();
        }
        return !round_.empty();
    }

    /// Other parts may have reached more since the part was found open.
    void take(Part part) {
        if (part.upper > enough()) {
            round_.push_back(std::move(part));
        } else {
            settled_ = std::max(settled_, part.upper);
        }
    }

    void refine_round() {
        std::vector<Progress> made(round_.size());
        tbb::parallel_for(std::size_t{0}, round_.size(), [&](std::size_t i) { made[i] = refine(round_[i]); });
        for (Progress& of_part : made) {
            settled_ = std::max(settled_, of_part.settled);
            if (of_part.furthest.distance > furthest_.distance) {
                furthest_ = of_part.furthest;
            }
            std::move(of_part.open.begin(), of_part.open.end(), std::back_inserter(open_parts_));
        }
    }

    /// Splits what has the largest bound, a number of times.
    [[nodiscard]] Progress refine(const Part& part) const {
        Progress result;
        result.furthest = furthest_;
        std::vector<Part>& heap = result.open;
        heap.push_back(part);
        for (int i = 0; i < splits_in_round && heap.front().upper > result.furthest.distance + bound_; ++i) {
            std::pop_heap(heap.begin(), heap.end(), has_lower_bound);
            const Halves halves = splitter_.split(heap.back(), result.furthest.distance);
            if (halves.furthest.distance > result.furthest.distance) {
                result.furthest = halves.furthest;
            }
            heap.back() = halves.first;
            std::push_heap(heap.begin(), heap.end(), has_lower_bound);
            heap.push_back(halves.second);
            std::push_heap(heap.begin(), heap.end(), has_lower_bound);
        }
        settle(result);
        return result;
    }

    void settle(Progress& result) const {
        const double enough = result.furthest.distance + bound_;
        const auto is_settled = [&](const Part& part) {
            if (part.upper <= enough) {
                result.settled = std::max(result.settled, part.upper);
            }
            return part.upper <= enough;
        };
        std::erase_if(result.open, is_settled);
    }

    const SampledSurface& surface_;
    const std::vector<Triangle>& faces_;
    Splitter splitter_;
    double bound_;
    Sample furthest_;
    double settled_ = 0.0;
    std::vector<std::pair<double, std::int32_t>> open_faces_; ///< by bound, the largest last
    std::vector<Part> open_parts_;
    std::vector<Part> round_;
};

} // namespace

Maximum refined_maximum(const SampledSurface& surface, const std::vector<Triangle>& faces, const NearestFace& other,
                        double bound, BlockLoop& loop, double share) {
    return Refinement(surface, faces, other, bound).run(loop, share);
}

} // namespace foldless::distances
