/// \file
/// What must hold for the base mesh alone: the displacement map is locally injective within the ranges.
#pragma once

#include <foldless/verify/base_faces.h>
#include <foldless/verify/findings.h>
#include <foldless/verify/stages.h>

namespace foldless::verification {

/// J > 0 on the prismoid of every moving face over its range (C0): `jacobian` or `undecided`.
void check_jacobians(const BaseFaces& base, Stages& stages, double share, Findings& findings);

/// The prismoids around a vertex go round its pillar once, those of an open fan at a kept vertex less than once (C1):
/// `jacobian`. Each turns by less than half a turn where J > 0, so a closed fan turns a whole number of times, the same
/// at every displacement in all its ranges: it is asked at 0, or at the one nearest to it, and not where the ranges
/// have none in common. An open fan at the free border of a trimmed base mesh may overlap itself beside the scan. Not
/// asked with constant face directions, where the prismoids of neighbours share no wall.
void check_base_windings(const BaseFaces& base, Stages& stages, double share, Findings& findings);

} // namespace foldless::verification
