/// \file
/// The scan that a command works on.
#pragma once

#include <foldless/io/scan.h>
#include <foldless/report/run_record.h>
#include <foldless/tools/console.h>

#include <filesystem>

namespace foldless {

struct Input {
    Scan scan;
    InputRecord record;
};

/// Reads a scan, which may have defects, and says what was ignored of it.
/// \throws UnreadableFile, RefusedMesh for polygons that are no triangles
[[nodiscard]] Scan read_noting(const std::filesystem::path& path, const Console& console);

/// The same with the inspection of a scan that must have no defects.
/// \throws UnreadableFile, RefusedMesh with each defect counted by name
[[nodiscard]] Input read_input(const std::filesystem::path& path, const Console& console);

/// The number of threads that a command uses: those asked for, or all cores.
[[nodiscard]] int threads_to_use(std::optional<int> asked_for);

} // namespace foldless
