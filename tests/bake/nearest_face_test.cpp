#include <foldless/bake/nearest_face.h>

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <random>

namespace foldless::distances {
namespace {

/// Triangles with corners near each other, in a cube with the sides `extent` around `centre`.
class Soup {
public:
    explicit Soup(double extent, const Vec3& centre = Vec3::Zero()) : extent_(extent), centre_(centre) {
        for (int i = 0; i < 600; ++i) {
            const Vec3 middle = place();
            for (int corner = 0; corner < 3; ++corner) {
                surface.positions.push_back(middle + extent_ / 10 * vector());
            }
            faces_.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        }
        faces_.push_back(faces_[7]); // as near as its double, and later
    }

    Vec3 place() { return centre_ + extent_ * vector(); }

    /// The first of the nearest faces.
    [[nodiscard]] NearestOnFace by_search_of_all(const Vec3& query) const {
        NearestOnFace best{0, nearest_point(query, surface.corners(0))};
        for (std::int32_t face = 1; face < static_cast<std::int32_t>(faces_.size()); ++face) {
            const NearestPoint nearest = nearest_point(query, surface.corners(face));
            if (nearest.squared_distance < best.nearest.squared_distance) {
                best = {face, nearest};
            }
        }
        return best;
    }

private:
    Vec3 vector() { return {number_(random_), number_(random_), number_(random_)}; }

    double extent_;
    Vec3 centre_;
    std::mt19937 random_{5};
    std::uniform_real_distribution<double> number_{-0.5, 0.5};
    std::vector<Triangle> faces_;

public:
    Surface surface{{}, faces_};
};

void expect_the_answers_of_a_search_of_all(Soup& soup) {
    const NearestFace nearest_face(soup.surface);
    for (int i = 0; i < 300; ++i) {
        const Vec3 query = i == 0 ? soup.surface.positions[21] : soup.place();
        const NearestOnFace wanted = soup.by_search_of_all(query);
        for (const std::int32_t guess : {0, 600, wanted.face}) {
            const NearestOnFace found = nearest_face.nearest(query, guess);
            EXPECT_EQ(found.face, wanted.face);
            EXPECT_EQ(found.nearest.squared_distance, wanted.nearest.squared_distance);
        }
    }
}

TEST(NearestFace, IsTheOneThatASearchOfAllFinds) {
    Soup soup(1.0);
    expect_the_answers_of_a_search_of_all(soup);
}

TEST(NearestFace, IsFoundWhereFloat32TellsNoPointsApart) {
    Soup soup(1e-9, Vec3(0.7, -0.3, 0.1));
    expect_the_answers_of_a_search_of_all(soup);
}

TEST(NearestFace, IsFoundAmongDenormalFloat32Coordinates) {
    Soup soup(1e-40);
    expect_the_answers_of_a_search_of_all(soup);
}

TEST(NearestFace, LeavesTheArithmeticOfTheThreadAsItIs) {
    Soup soup(1.0);
    std::fenv_t before;
    std::fegetenv(&before);
    const NearestFace nearest_face(soup.surface);
    EXPECT_EQ(nearest_face.nearest(Vec3::Zero(), 0).face, soup.by_search_of_all(Vec3::Zero()).face);
    std::fenv_t after;
    std::fegetenv(&after);
    constexpr unsigned flags = 0x3f; // of exceptions, which any arithmetic may raise
    EXPECT_EQ(before.__mxcsr | flags, after.__mxcsr | flags);
    volatile double smallest_normal = 0x1p-1022;
    EXPECT_GT(smallest_normal / 2, 0.0);
}

} // namespace
} // namespace foldless::distances
