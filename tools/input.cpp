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

Input read_input(const std::filesystem::path& path, const Console& console) {
    ReadScan read = read_scan(path);
    const Inspection inspection = inspect(read.scan);
    if (inspection.defects.any()) {
        throw RefusedMesh(fmt::format("{}: {}", printable(path), inspection.defects.text()));
    }
    note_ignored(path, read.notes, console);
    InputRecord record{path.string(), read.scan.positions.size(), read.scan.faces.size(), inspection.topology};
    return {std::move(read.scan), std::move(record)};
}

} // namespace foldless
