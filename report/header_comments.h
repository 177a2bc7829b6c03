/// \file
/// What the header of a file says of its making.
#pragma once

#include <foldless/report/run_record.h>

#include <string>
#include <vector>

namespace foldless {

/// The version, the preset, and each option that changes the result, one a line. Nothing else: neither paths, times nor
/// threads, so that the same input and options give the same bytes.
[[nodiscard]] std::vector<std::string> header_comments(Preset preset, const DecimateOptions& options);

/// The same for a repaired scan.
[[nodiscard]] std::vector<std::string> header_comments(const RepairOptions& options);

} // namespace foldless
