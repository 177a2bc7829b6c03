/// \file
/// What must hold for the scan around kept vertices.
#pragma once

#include <foldless/verify/scan_image.h>

namespace foldless::verification {

/// Around every kept vertex the moving scan faces go round once, or less than once in an open fan, seen along its
/// direction (K): `orientation`.
void check_scan_windings(const Correspondents& all, const Adjacency& scan_adjacency, Stages& stages,
                         Findings& findings);

} // namespace foldless::verification
