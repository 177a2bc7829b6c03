/// \file
/// Reports for other programs: JSON, the keys of which are described in docs/cli.md.
#pragma once

#include <foldless/report/run_record.h>

#include <string>

namespace foldless {

/// Each report is a JSON object in UTF-8 with a line feed at its end. A number that is not finite is null; bytes of a
/// path that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string json_report(const SimplifyRecord& record);
[[nodiscard]] std::string json_report(const VerifyRecord& record);
[[nodiscard]] std::string json_report(const RepairRecord& record);
[[nodiscard]] std::string json_report(const BakeRecord& record);
[[nodiscard]] std::string json_report(const ReconstructRecord& record);
[[nodiscard]] std::string json_report(const InfoRecord& record);

} // namespace foldless
