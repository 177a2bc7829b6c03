/// \file
/// What a run did, in lines for a person.
#pragma once

#include <foldless/report/run_record.h>

#include <string>
#include <vector>

namespace foldless {

using Lines = std::vector<std::string>;

/// What a reader did that the user should know of, in one line; empty if there is nothing.
[[nodiscard]] std::string notes_text(const ReadNotes& notes);

/// "3 no_preimage, 1 orientation": each violation counted by name; empty if there is none.
[[nodiscard]] std::string violations_text(const VerifyResult& result);

/// One line for each located violation: its name, the indices that apply, the position.
[[nodiscard]] Lines located_lines(const VerifyResult& result);

/// "level vertices, 2 ambiguous vertices, 0 % of the base mesh uncovered": what a certificate without violations says.
[[nodiscard]] std::string certificate_text(const VerifyResult& result);

[[nodiscard]] Lines summary(const SimplifyRecord& record);
[[nodiscard]] Lines summary(const RepairRecord& record);
[[nodiscard]] Lines summary(const InfoRecord& record);

} // namespace foldless
