#include <foldless/models/model.h>

#include <foldless/models/noise.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace foldless {

namespace {

/// Enough faces to know the mean edge length to a per cent, few enough to cost nothing.
constexpr std::int64_t sampled_faces = 4096;

/// A scanner errs mostly along its line of sight: share of the noise along each tangent.
constexpr double tangential_share = 0.25;

/// Slopes are taken over a quarter of a cell to either side: SurfacePlace says that a surface is defined that far.
constexpr double slope_step = 0.25;

/// GCC 12 vectorises double -> float -> double in pairs (-O2, SLP) and then drops both conversions as if they were
/// exact. It cannot drop a volatile float.
double rounded_to_float32(double coordinate) {
    const volatile auto rounded = static_cast<float>(coordinate);
    return static_cast<double>(rounded);
}

Vec3 rounded_to_float32(const Vec3& point) {
    return {rounded_to_float32(point.x()), rounded_to_float32(point.y()), rounded_to_float32(point.z())};
}

} // namespace

Model::Model(Grid grid, Surface surface, const Finish& finish)
    : grid_(std::move(grid)), surface_(std::move(surface)), finish_(finish), amplitude_(0) {
    if (finish_.noise > 0) {
        amplitude_ = finish_.noise * mean_edge_length();
    }
}

std::int64_t Model::vertices() const {
    return std::visit([](const auto& grid) { return grid.vertices(); }, grid_);
}

std::int64_t Model::faces() const {
    return std::visit([](const auto& grid) { return grid.faces(); }, grid_);
}

SurfacePlace Model::place(std::int64_t vertex) const {
    return std::visit([vertex](const auto& grid) { return grid.place(vertex); }, grid_);
}

Triangle Model::triangle(std::int64_t face) const {
    return std::visit([face](const auto& grid) { return grid.triangle(face); }, grid_);
}

double Model::mean_edge_length() const {
    const std::int64_t samples = std::min(faces(), sampled_faces);
    double sum = 0;
    for (std::int64_t sample = 0; sample < samples; ++sample) {
        const auto [a, b, c] = triangle(sample * faces() / samples);
        const std::array<Vec3, 3> corners = {surface_(place(a)), surface_(place(b)), surface_(place(c))};
        for (std::size_t i = 0; i < corners.size(); ++i) {
            sum += (corners[(i + 1) % corners.size()] - corners[i]).norm();
        }
    }
    return sum / (3.0 * static_cast<double>(samples));
}

Vec3 Model::displacement(const SurfacePlace& place, std::int64_t vertex) const {
    const CellSize cell = std::visit([&place](const auto& grid) { return grid.cell_size(place.patch); }, grid_);
    const double du = slope_step * cell.u;
    const double dv = slope_step * cell.v;
    const auto at = [&](double u, double v) { return surface_({place.patch, u, v}); };
    const Vec3 along_u = (at(place.u + du, place.v) - at(place.u - du, place.v)).normalized();
    const Vec3 along_v = (at(place.u, place.v + dv) - at(place.u, place.v - dv)).normalized();
    const Vec3 normal = along_u.cross(along_v).normalized();
    const auto [n, u, v] = noise_at(finish_.seed, static_cast<std::uint64_t>(vertex));
    return amplitude_ * (n * normal + tangential_share * (u * along_u + v * along_v));
}

Vec3 Model::position(std::int64_t vertex) const {
    const SurfacePlace where = place(vertex);
    Vec3 point = surface_(where);
    if (amplitude_ > 0) {
        point += displacement(where, vertex);
    }
    return finish_.float32 ? rounded_to_float32(point) : point;
}

Scan to_scan(const Model& model) {
    Scan scan;
    scan.float32 = model.float32();
    scan.positions.reserve(static_cast<std::size_t>(model.vertices()));
    scan.faces.reserve(static_cast<std::size_t>(model.faces()));
    for (std::int64_t vertex = 0; vertex < model.vertices(); ++vertex) {
        scan.positions.push_back(model.position(vertex));
    }
    for (std::int64_t face = 0; face < model.faces(); ++face) {
        scan.faces.push_back(model.triangle(face));
    }
    return scan;
}

} // namespace foldless
