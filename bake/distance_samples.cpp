#include <foldless/bake/distance_samples.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace foldless::distances {
namespace {

/// The rule of surface_distance.h for a triangle: exact for quadratic polynomials.
constexpr double weight_of_centroid = 3.0 / 4;
constexpr double weight_of_corner = 1.0 / 12;

/// A triangle of the rule has no more than this share of the area, so that large faces are sampled as densely as small
/// ones. n^2 is at most 2 s + 2 for a face of s such shares: a surface has at most 100,000 triangles and two for each
/// of its faces.
constexpr double largest_share_of_area = 1.0 / 50'000;

/// Of the work: vertices, then faces.
constexpr double share_of_vertices = 0.4;

double area(const ScanTriangle& triangle) {
    return (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).norm() / 2;
}

const Sample& further(const Sample& first, const Sample& second) {
    return second.distance > first.distance ? second : first;
}

double square(double x) {
    return x * x;
}

/// What a block of faces adds to the sums.
struct BlockSums {
    Sample furthest;
    double integral = 0.0;
};

/// Samples the faces of a surface whose vertices are sampled.
class FaceSampler {
public:
    FaceSampler(const Surface& surface, const NearestFace& other, SampledSurface& result)
        : surface_(surface), other_(other), result_(result) {}

    /// The area first, which says how faces are split; then the samples.
    void sample_all(BlockLoop& loop, double share) {
        result_.area = total_area(loop);
        result_.upper.resize(surface_.faces.size());
        std::vector<BlockSums> sums(BlockLoop::blocks(surface_.faces.size()));
        loop.for_each_block(surface_.faces.size(), share, [&](std::size_t b, std::size_t first, std::size_t last) {
            for (std::size_t face = first; face < last; ++face) {
                sample_face(static_cast<std::int32_t>(face), sums[b]);
            }
        });
        for (const BlockSums& block : sums) {
            result_.furthest = further(result_.furthest, block.furthest);
            result_.integral += block.integral;
        }
    }

private:
    double total_area(BlockLoop& loop) const {
        std::vector<double> areas(BlockLoop::blocks(surface_.faces.size()));
        loop.for_each_block(surface_.faces.size(), 0.0, [&](std::size_t b, std::size_t first, std::size_t last) {
            for (std::size_t face = first; face < last; ++face) {
                areas[b] += area(surface_.corners(static_cast<std::int32_t>(face)));
            }
        });
        double sum = 0.0;
        for (const double block : areas) {
            sum += block;
        }
        return sum;
    }

    void sample_face(std::int32_t face, BlockSums& sums) {
        const SampledTriangle corners = result_.corners(surface_.faces[face]);
        const double face_area = area(surface_.corners(face));
        const double shares = face_area > 0.0 ? face_area / (largest_share_of_area * result_.area) : 0.0;
        const int n = std::max(1, static_cast<int>(std::ceil(std::sqrt(shares))));
        double upper = upper_bound(corners, other_);
        if (n == 1) {
            const Sample centre = centroid(corners, sums);
            upper = std::min(upper, distance_to_face(corners, other_, centre.face, upper));
            sums.integral += face_area * mean_square(corners, centre);
        } else {
            sums.integral += face_area * mean_square_of_split_face(corners, n, sums);
        }
        result_.upper[face] = upper;
    }

    Sample centroid(const SampledTriangle& corners, BlockSums& sums) const {
        const Vec3 position = (corners[0].position + corners[1].position + corners[2].position) / 3;
        const Sample centre = sample(other_, position, corners[0].face);
        sums.furthest = further(sums.furthest, centre);
        return centre;
    }

    static double mean_square(const SampledTriangle& corners, const Sample& centre) {
        return weight_of_centroid * square(centre.distance) +
               weight_of_corner *
                   (square(corners[0].distance) + square(corners[1].distance) + square(corners[2].distance));
    }

    /// Row by row away from the first corner: row i has i triangles that stand on it and i - 1 that hang from the row
    /// before.
    double mean_square_of_split_face(const SampledTriangle& corners, int n, BlockSums& sums) const {
        double sum = 0.0;
        std::vector<Sample> before{corners[0]};
        std::vector<Sample> row;
        for (int i = 1; i <= n; ++i) {
            sample_row(corners, static_cast<double>(i) / n, i, row);
            for (int k = 0; k < i; ++k) {
                const SampledTriangle standing{before[k], row[k], row[k + 1]};
                sum += mean_square(standing, centroid(standing, sums));
                if (k > 0) {
                    const SampledTriangle hanging{before[k - 1], row[k], before[k]};
                    sum += mean_square(hanging, centroid(hanging, sums));
                }
            }
            for (const Sample& at : row) {
                sums.furthest = further(sums.furthest, at);
            }
            std::swap(before, row);
        }
        return sum / square(n);
    }

    /// i + 1 points on the line that is `down` of the way from the first corner to the edge opposite.
    void sample_row(const SampledTriangle& corners, double down, int i, std::vector<Sample>& row) const {
        const auto& [a, b, c] = corners;
        const Vec3 begin = a.position + down * (b.position - a.position);
        const Vec3 end = a.position + down * (c.position - a.position);
        row.resize(static_cast<std::size_t>(i) + 1);
        std::int32_t guess = b.face;
        for (int k = 0; k <= i; ++k) {
            row[k] = sample(other_, begin + static_cast<double>(k) / i * (end - begin), guess);
            guess = row[k].face;
        }
    }

    const Surface& surface_;
    const NearestFace& other_;
    SampledSurface& result_;
};

std::vector<bool> vertices_with_faces(const Surface& surface) {
    std::vector<bool> result(surface.positions.size());
    for (const Triangle& face : surface.faces) {
        for (const std::int32_t vertex : face) {
            result[vertex] = true;
        }
    }
    return result;
}

std::vector<Sample> sampled_vertices(const Surface& surface, const NearestFace& other, BlockLoop& loop, double share) {
    std::vector<Sample> samples(surface.positions.size());
    const std::vector<bool> has_faces = vertices_with_faces(surface);
    loop.for_each_block(samples.size(), share, [&](std::size_t, std::size_t first, std::size_t last) {
        std::int32_t guess = 0; // vertices in a row tend to be neighbours
        for (std::size_t vertex = first; vertex < last; ++vertex) {
            if (has_faces[vertex]) {
                samples[vertex] = sample(other, surface.positions[vertex], guess);
                guess = samples[vertex].face;
            }
        }
    });
    return samples;
}

} // namespace

Sample sample(const NearestFace& other, const Vec3& position, std::int32_t guess) {
    const NearestOnFace found = other.nearest(position, guess);
    return {position, std::sqrt(found.nearest.squared_distance), found.face};
}

double distance_to_face(const SampledTriangle& triangle, const NearestFace& other, std::int32_t face, double enough) {
    double distance = 0.0;
    for (const Sample& corner : triangle) {
        const double at_corner =
            corner.face == face ? corner.distance : std::sqrt(other.nearest_on(face, corner.position).squared_distance);
        distance = std::max(distance, at_corner);
        if (distance > enough) {
            break;
        }
    }
    return distance;
}

double upper_bound(const SampledTriangle& triangle, const NearestFace& other) {
    const auto& [a, b, c] = triangle;
    double upper = distance_to_face(triangle, other, a.face, std::numeric_limits<double>::infinity());
    if (b.face != a.face) {
        upper = std::min(upper, distance_to_face(triangle, other, b.face, upper));
    }
    if (c.face != a.face && c.face != b.face) {
        upper = std::min(upper, distance_to_face(triangle, other, c.face, upper));
    }
    return upper;
}

SampledSurface sampled(const Surface& surface, const NearestFace& other, BlockLoop& loop, double share) {
    SampledSurface result;
    result.vertices = sampled_vertices(surface, other, loop, share_of_vertices * share);
    if (!loop.cancelled()) {
        FaceSampler(surface, other, result).sample_all(loop, (1 - share_of_vertices) * share);
        for (const Sample& vertex : result.vertices) {
            result.furthest = further(result.furthest, vertex);
        }
    }
    return result;
}

} // namespace foldless::distances
