#include <foldless/io/defects.h>
#include <foldless/models/make_model.h>

#include "mesh_check.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace foldless {
namespace {

/// What models/README.md states of a shape, in n, the subdivision of each patch.
struct QuiltNumbers {
    std::int64_t faces;           ///< times n^2
    std::int64_t vertices;        ///< times n^2
    std::int64_t linear_vertices; ///< times n
    std::int64_t constant_vertices;
    std::int64_t boundary_edges; ///< times n
};

const std::map<Shape, QuiltNumbers> quilt_numbers = {
    {Shape::sphere, {12, 6, 0, 2, 0}},    {Shape::bumpy_sphere, {12, 6, 0, 2, 0}},  {Shape::cube, {12, 6, 0, 2, 0}},
    {Shape::genus2, {132, 66, 0, -2, 0}}, {Shape::cylinder, {112, 56, 20, -4, 40}}, {Shape::ears, {548, 274, 0, 2, 0}},
    {Shape::spike, {44, 22, 0, 2, 0}}};

ModelRequest request_of(Shape shape, std::int64_t faces) {
    ModelRequest request;
    request.shape = shape;
    request.faces = faces;
    return request;
}

class EveryShape : public testing::TestWithParam<Shape> {
protected:
    [[nodiscard]] static std::vector<std::int64_t> sizes() { return {least_faces(GetParam()), 3000, 4999, 20'000}; }
};

INSTANTIATE_TEST_SUITE_P(Models, EveryShape, testing::ValuesIn(all_shapes), [](const auto& shape) {
    std::string name(name_of(shape.param));
    std::erase_if(name, [](unsigned char c) { return std::isalnum(c) == 0; });
    return name;
});

void expect_clean(const MeshCheck& check) {
    EXPECT_EQ(check.bad_faces, 0U);
    EXPECT_EQ(check.flat_faces, 0U);
    EXPECT_EQ(check.repeated_half_edges, 0U);
    EXPECT_EQ(check.pinched_vertices, 0U);
    EXPECT_EQ(check.unused_vertices, 0U);
    EXPECT_EQ(check.equal_positions, 0U);
    EXPECT_EQ(check.components, 1U);
}

TEST_P(EveryShape, IsACleanManifoldWithThePromisedTopology) {
    const Known known = known_of(GetParam());
    for (const std::int64_t faces : sizes()) {
        SCOPED_TRACE(faces);
        const MeshCheck check = check_mesh(to_scan(make_model(request_of(GetParam(), faces))));
        expect_clean(check);
        EXPECT_EQ(check.euler_characteristic, known.euler_characteristic);
        EXPECT_EQ(check.boundary_loops, static_cast<std::size_t>(known.boundary_loops));
        if (known.boundary_loops == 0) {
            EXPECT_EQ(check.boundary_edges, 0U);
        }
    }
}

TEST_P(EveryShape, HasNoDefectInTheEyesOfTheLibrary) {
    const Inspection inspection = inspect(to_scan(make_model(request_of(GetParam(), 5000))));
    EXPECT_EQ(inspection.defects.text(), "");
    EXPECT_EQ(inspection.topology.components, 1U);
    EXPECT_EQ(inspection.topology.euler_characteristic, known_of(GetParam()).euler_characteristic);
    EXPECT_EQ(inspection.topology.boundary_loops, static_cast<std::size_t>(known_of(GetParam()).boundary_loops));
}

TEST(MakeModel, ClosedShapesFaceOutward) {
    for (const Shape shape : all_shapes) {
        const double volume = check_mesh(to_scan(make_model(request_of(shape, 1000)))).volume;
        EXPECT_TRUE(known_of(shape).boundary_loops > 0 || volume > 0) << name_of(shape) << ": " << volume;
    }
}

TEST_P(EveryShape, IsStillCleanWithNoise) {
    ModelRequest request = request_of(GetParam(), 5000);
    request.finish = {0.1, 42, true};
    expect_clean(check_mesh(to_scan(make_model(request))));
}

/// The rule of models/README.md: at most N, and within the step to the next size that the shape can have.
TEST_P(EveryShape, HasAlmostAsManyFacesAsAskedFor) {
    for (const std::int64_t faces : {least_faces(GetParam()), std::int64_t{12'345}, std::int64_t{1'000'000}}) {
        const std::int64_t made = make_model(request_of(GetParam(), faces)).faces();
        EXPECT_LE(made, faces);
        if (quilt_numbers.contains(GetParam())) {
            const auto unit = quilt_numbers.at(GetParam()).faces;
            const auto n = std::llround(std::sqrt(static_cast<double>(made) / static_cast<double>(unit)));
            EXPECT_EQ(made, unit * n * n);
            EXPECT_GT(unit * (n + 1) * (n + 1), faces);
        } else {
            const double rows = std::max(3.0, std::sqrt(static_cast<double>(faces) / 2));
            EXPECT_GT(static_cast<double>(made), static_cast<double>(faces) - 2 * rows);
        }
    }
}

void expect_numbers(const Model& model, const QuiltNumbers& numbers, std::int64_t n) {
    EXPECT_EQ(model.faces(), numbers.faces * n * n);
    EXPECT_EQ(model.vertices(), numbers.vertices * n * n + numbers.linear_vertices * n + numbers.constant_vertices);
    EXPECT_EQ(check_mesh(to_scan(model)).boundary_edges, static_cast<std::size_t>(numbers.boundary_edges * n));
}

TEST(Patchworks, HaveTheNumbersOfTheTable) {
    for (const auto& [shape, numbers] : quilt_numbers) {
        EXPECT_EQ(least_faces(shape), numbers.faces);
        for (const std::int64_t n : {1, 2, 3, 7}) {
            SCOPED_TRACE(fmt::format("{} {}", name_of(shape), n));
            expect_numbers(make_model(request_of(shape, numbers.faces * n * n)), numbers, n);
        }
    }
}

TEST(Sheets, HaveTheNumbersOfTheTable) {
    // 20,000 faces: the rows are the root of 10,000 / aspect, and the columns what is left.
    const Model terrain = make_model(request_of(Shape::terrain, 20'000));
    EXPECT_EQ(terrain.faces(), 2 * 100 * 100);
    EXPECT_EQ(terrain.vertices(), 101 * 101);
    EXPECT_EQ(check_mesh(to_scan(terrain)).boundary_edges, 400U);
    const Model torus = make_model(request_of(Shape::torus, 20'000)); // aspect 2.5
    EXPECT_EQ(torus.faces(), 2 * 63 * 158);
    EXPECT_EQ(torus.vertices(), 63 * 158);
    for (const Shape shape : {Shape::torus, Shape::knot}) {
        const Model model = make_model(request_of(shape, 7777));
        EXPECT_EQ(2 * model.vertices(), model.faces());
    }
}

TEST(MakeModel, RefusesNumbersOutOfRange) {
    for (const Shape shape : all_shapes) {
        EXPECT_THROW(static_cast<void>(make_model(request_of(shape, least_faces(shape) - 1))), std::invalid_argument);
        EXPECT_THROW(static_cast<void>(make_model(request_of(shape, most_faces + 1))), std::invalid_argument);
    }
    for (const double noise : {-0.1, std::nan(""), std::numeric_limits<double>::infinity()}) {
        ModelRequest request;
        request.finish.noise = noise;
        EXPECT_THROW(static_cast<void>(make_model(request)), std::invalid_argument);
    }
}

TEST(MakeModel, IndicesStayInRangeAtTheGreatestSize) {
    for (const Shape shape : all_shapes) {
        const Model model = make_model(request_of(shape, most_faces));
        EXPECT_LE(model.vertices(), std::numeric_limits<std::int32_t>::max());
        for (const std::int32_t vertex : model.triangle(model.faces() - 1)) {
            EXPECT_GE(vertex, 0);
            EXPECT_LT(vertex, model.vertices());
        }
    }
}

TEST(MakeModel, RoundsToFloat32UnlessTold) {
    ModelRequest request = request_of(Shape::knot, 1000);
    const Model single = make_model(request);
    request.finish.float32 = false;
    const Model exact = make_model(request);
    for (std::int64_t vertex = 0; vertex < single.vertices(); ++vertex) {
        for (int axis = 0; axis < 3; ++axis) {
            const volatile auto rounded = static_cast<float>(exact.position(vertex)[axis]); // see models/model.cpp
            EXPECT_EQ(single.position(vertex)[axis], static_cast<double>(rounded));
        }
    }
    EXPECT_NE(single.position(77), exact.position(77));
}

TEST(MakeModel, NoiseIsOfTheSizeAskedFor) {
    ModelRequest request = request_of(Shape::sphere, 100'000);
    const Model smooth = make_model(request);
    request.finish.noise = 0.2;
    const Model noisy = make_model(request);
    double radial = 0;
    double tangential = 0;
    for (std::int64_t vertex = 0; vertex < smooth.vertices(); ++vertex) {
        const Vec3 shift = noisy.position(vertex) - smooth.position(vertex);
        const double out = shift.dot(smooth.position(vertex));
        radial += out * out;
        tangential += shift.squaredNorm() - out * out;
    }
    const double expected = 0.2 * smooth.mean_edge_length();
    const auto count = static_cast<double>(smooth.vertices());
    EXPECT_NEAR(std::sqrt(radial / count), expected, 0.02 * expected);
    EXPECT_NEAR(std::sqrt(tangential / count), std::sqrt(2.0) / 4 * expected, 0.02 * expected);
}

TEST(MakeModel, SampledEdgeLengthIsTheMean) {
    for (const Shape shape : all_shapes) {
        const Model model = make_model(request_of(shape, 30'000));
        const Scan scan = to_scan(model);
        double sum = 0;
        for (const auto& [a, b, c] : scan.faces) {
            sum += (scan.positions[a] - scan.positions[b]).norm() + (scan.positions[b] - scan.positions[c]).norm() +
                   (scan.positions[c] - scan.positions[a]).norm();
        }
        const double mean = sum / (3.0 * static_cast<double>(scan.faces.size()));
        EXPECT_NEAR(model.mean_edge_length(), mean, 0.05 * mean) << name_of(shape);
    }
}

} // namespace
} // namespace foldless
