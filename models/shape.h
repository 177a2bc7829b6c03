/// \file
/// The shapes by name, and what is known of them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace foldless {

enum class Shape { sphere, bumpy_sphere, torus, genus2, knot, terrain, cylinder, ears, fold, spike, cube };

inline constexpr std::array all_shapes = {Shape::sphere, Shape::bumpy_sphere, Shape::torus,    Shape::genus2,
                                          Shape::knot,   Shape::terrain,      Shape::cylinder, Shape::ears,
                                          Shape::fold,   Shape::spike,        Shape::cube};

/// "bumpy-sphere": the name on the command line.
[[nodiscard]] std::string_view name_of(Shape shape);

/// No value if there is no such shape.
[[nodiscard]] std::optional<Shape> shape_named(std::string_view name);

/// "sphere, bumpy-sphere, ...".
[[nodiscard]] std::string names_of_shapes();

/// What holds at every size. All shapes are connected, oriented outward (or upward) and have no defect.
struct Known {
    int euler_characteristic;
    int boundary_loops;
};

[[nodiscard]] Known known_of(Shape shape);

} // namespace foldless
