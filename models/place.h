/// \file
/// Where on a parametrised surface a vertex lies.
#pragma once

#include <foldless/predicates/vector.h>

#include <functional>

namespace foldless {

/// A point of the parameter domain: a patch, and u, v in [0, 1] across it. A slope is taken between points up to a
/// quarter of a cell apart from a vertex, so a surface must be defined that far outside [0, 1] too.
struct SurfacePlace {
    int patch;
    double u;
    double v;
};

/// The size of a cell in u and in v.
struct CellSize {
    double u;
    double v;
};

/// The point in space of a place, model units. dP/du x dP/dv points outward.
using Surface = std::function<Vec3(const SurfacePlace&)>;

} // namespace foldless
