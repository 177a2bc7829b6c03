#include <foldless/tools/input.h>

#include <foldless/io/defects.h>
#include <foldless/io/errors.h>
#include <foldless/io/printable.h>
#include <foldless/io/read_mesh.h>
#include <foldless/report/summary.h>

#include <fmt/format.h>

#include <algorithm>
#include <thread>
#include <utility>

namespace foldless {

Scan read_noting(const std::filesystem::path& path, const Console& console) {
    ReadScan read = read_scan(path);
    if (const std::string notes = notes_text(read.notes); !notes.empty()) {
        console.note(fmt::format("{}: {}", printable(path), notes));
    }
    return std::move(read.scan);
}

Input read_input(const std::filesystem::path& path, const Console& console) {
    Scan scan = read_noting(path, console);
    const Inspection inspection = inspect(scan);
    if (inspection.defects.any()) {
        throw RefusedMesh(fmt::format("{}: {}", printable(path), inspection.defects.text()));
    }
    InputRecord record{path.string(), scan.positions.size(), scan.faces.size(), inspection.topology};
    return {std::move(scan), std::move(record)};
}

int threads_to_use(std::optional<int> asked_for) {
    return asked_for.value_or(std::max(1, static_cast<int>(std::thread::hardware_concurrency())));
}

} // namespace foldless
