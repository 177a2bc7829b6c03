/// \file
/// Carrying out a collapse: all that is ever written to a base surface.
#pragma once

#include <foldless/decimate/collapse.h>
#include <foldless/decimate/validator.h>

namespace foldless {

/// Carries out the collapse whose patch was accepted, with what the trial says of its faces and of the places on them.
/// Every face of the patch must take over one that goes.
void commit_collapse(BaseSurface& base, const Collapse& collapse, const Patch& patch, const Trial& trial);

} // namespace foldless
