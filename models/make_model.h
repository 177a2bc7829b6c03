/// \file
/// A shape of about so many faces.
#pragma once

#include <foldless/models/model.h>
#include <foldless/models/shape.h>

#include <cstdint>

namespace foldless {

struct ModelRequest {
    Shape shape = Shape::sphere;
    std::int64_t faces = 1000; ///< at most so many, and as many as the shape can have: see models/README.md
    Finish finish;
};

/// The most faces that can be asked for: about twice as many as there are vertices, whose indices are int32.
constexpr std::int64_t most_faces = 4'000'000'000;

/// The fewest faces that the shape can have.
[[nodiscard]] std::int64_t least_faces(Shape shape);

/// \throws std::invalid_argument if faces is below least_faces(shape) or above most_faces, or the noise is negative or
/// not finite. Time and memory O(1).
[[nodiscard]] Model make_model(const ModelRequest& request);

/// The vertex of Shape::spike, at any size, that sees no direction: none has a positive dot product with the normals of
/// all its faces.
[[nodiscard]] std::int32_t spike_vertex();

} // namespace foldless
