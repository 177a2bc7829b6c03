/// \file
/// Reading displacements from the map of an atlas.
#pragma once

#include <foldless/bake/atlas.h>
#include <foldless/bake/reconstruct.h>

#include <foldless/images/image.h>
#include <foldless/predicates/vector.h>

#include <cstdint>

namespace foldless {

/// The displacement map with its mask, interpolated between the four texels around a point of a chart, as a renderer
/// does. Refers to all three.
class AtlasSampler {
public:
    /// \param mask empty: everything is covered
    AtlasSampler(const Atlas& atlas, const Image& displacement, const Image& mask);

    /// t and the mask at a point of a base face.
    [[nodiscard]] MapValue value(std::int32_t face, const Vec3& alpha) const;

private:
    /// The texel to the lower left of a point in the lattice, and the shares of the next column and row.
    struct Cell {
        int i, j;
        double along, up;
    };
    [[nodiscard]] static Cell cell_of(const Chart& chart, const Vec3& alpha);
    [[nodiscard]] double interpolated(const Image& image, const Chart& chart, const Cell& cell) const;

    const Atlas& atlas_;
    const Image& displacement_;
    const Image& mask_;
};

} // namespace foldless
