#include <foldless/models/shape.h>

#include <cstddef>

namespace foldless {

namespace {

struct Entry {
    std::string_view name;
    Known known;
};

/// In the order of Shape: name, Euler characteristic, boundary loops.
constexpr std::array<Entry, all_shapes.size()> entries = {{{"sphere", {2, 0}},
                                                           {"bumpy-sphere", {2, 0}},
                                                           {"torus", {0, 0}},
                                                           {"genus2", {-2, 0}},
                                                           {"knot", {0, 0}},
                                                           {"terrain", {1, 1}},
                                                           {"cylinder", {-4, 6}},
                                                           {"ears", {2, 0}},
                                                           {"fold", {1, 1}},
                                                           {"spike", {2, 0}},
                                                           {"cube", {2, 0}}}};

} // namespace

std::string_view name_of(Shape shape) {
    return entries[static_cast<std::size_t>(shape)].name;
}

std::optional<Shape> shape_named(std::string_view name) {
    for (const Shape shape : all_shapes) {
        if (name_of(shape) == name) {
            return shape;
        }
    }
    return std::nullopt;
}

std::string names_of_shapes() {
    std::string names;
    for (const Shape shape : all_shapes) {
        names += names.empty() ? "" : ", ";
        names += name_of(shape);
    }
    return names;
}

Known known_of(Shape shape) {
    return entries[static_cast<std::size_t>(shape)].known;
}

} // namespace foldless
