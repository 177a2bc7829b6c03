/// \file
/// The scan that a command works on.
#pragma once

#include <foldless/io/scan.h>
#include <foldless/io/scan_appearance.h>
#include <foldless/report/run_record.h>
#include <foldless/tools/console.h>

#include <filesystem>

namespace foldless {

struct Input {
    Scan scan;
    InputRecord record;
};

/// Says what a reader ignored of a file, if anything. Once it is clear that the file is not refused: that is one line.
void note_ignored(const std::filesystem::path& path, const ReadNotes& notes, const Console& console);

/// Reads a scan, inspects it, and says what was ignored of it.
/// \throws UnreadableFile, RefusedMesh with each defect counted by name
[[nodiscard]] Input read_input(const std::filesystem::path& path, const Console& console);

struct ColouredInput {
    Input input;
    ScanAppearance appearance;
};

/// The same with what the scan looks like.
/// \throws UnreadableFile, RefusedMesh
[[nodiscard]] ColouredInput read_coloured_input(const std::filesystem::path& path, const Console& console);

} // namespace foldless
