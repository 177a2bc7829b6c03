#include <foldless/tools/input.h>

#include <foldless/io/defects.h>
#include <foldless/io/errors.h>
#include <foldless/io/printable.h>
#include <foldless/io/read_mesh.h>
#include <foldless/report/summary.h>

#include <fmt/format.h>

#include <utility>

namespace foldless {

void note_ignored(const std::filesystem::path& path, const ReadNotes& notes, const Console& console) {
    if (const std::string text = notes_text(notes); !text.empty()) {
        console.note(fmt::format("{}: {}", printable(path), text));
    }
}

namespace {

/// Inspects a scan that was read, and says what was ignored of it.
Input inspected(const std::filesystem::path& path, Scan scan, const ReadNotes& notes, const Console& console) {
    const Inspection inspection = inspect(scan);
    if (inspection.defects.any()) {
        throw RefusedMesh(fmt::format("{}: {}", printable(path), inspection.defects.text()));
    }
    note_ignored(path, notes, console);
    InputRecord record{path.string(), scan.positions.size(), scan.faces.size(), inspection.topology};
    return {std::move(scan), std::move(record)};
}

} // namespace

Input read_input(const std::filesystem::path& path, const Console& console) {
    ReadScan read = read_scan(path);
    return inspected(path, std::move(read.scan), read.notes, console);
}

ColouredInput read_coloured_input(const std::filesystem::path& path, const Console& console) {
    ReadColouredScan read = read_coloured_scan(path);
    return {inspected(path, std::move(read.scan), read.notes, console), std::move(read.appearance)};
}

} // namespace foldless
