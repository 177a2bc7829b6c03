/// \file
/// Re-derives from nothing what must hold for every result of decimate().
#pragma once

#include <foldless/decimate/decimate.h>

namespace foldless::test {

/// Adds a failure of the running test for each invariant that does not hold: the arrays fit each other; every stored
/// number is a float32 value; kept vertices are bit-equal and claimed once; the place of every scan vertex reproduces
/// it and lies within the range of its face; J > 0 on moving faces, in plain doubles; the topology is that of the scan;
/// a locked border is the same edge for edge; and verify() certifies the result.
void deep_check(const Scan& scan, const DecimateOptions& options, const DecimateResult& result);

} // namespace foldless::test
