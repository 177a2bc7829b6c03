#include <foldless/repair/thin_walls.h>

#include <foldless/io/edge_table.h>
#include <foldless/io/union_find.h>
#include <foldless/repair/dropping.h>

#include <algorithm>
#include <cstddef>
#include <span>

namespace foldless {

namespace {

using Entries = std::span<const EdgeTable::Entry>;

/// The sheets of doubled faces, each named by its first face.
class Sheets {
public:
    Sheets(const Scan& scan, const std::vector<std::uint8_t>& doubled)
        : doubled_(doubled), sheets_(scan.faces.size()), leaves_border_(scan.faces.size(), 0),
          stands_on_others_(scan.faces.size(), 0) {
        const EdgeTable edges(scan.faces, scan.positions.size());
        edges.for_each_edge([this](std::int32_t, std::int32_t, Entries entries) { join(entries); });
        edges.for_each_edge([this](std::int32_t, std::int32_t, Entries entries) { judge(entries); });
    }

    [[nodiscard]] bool is_thin_wall(std::size_t face) {
        const std::uint32_t sheet = sheets_.find(static_cast<std::uint32_t>(face));
        return doubled_[face] != 0 && stands_on_others_[sheet] != 0 && leaves_border_[sheet] == 0;
    }

private:
    [[nodiscard]] bool is_doubled(const EdgeTable::Entry& entry) const { return doubled_[entry.face] != 0; }

    void join(Entries entries) {
        const auto first = std::ranges::find_if(entries, [this](const auto& entry) { return is_doubled(entry); });
        for (auto entry = first; entry != entries.end(); ++entry) {
            if (is_doubled(*entry)) {
                sheets_.join(static_cast<std::uint32_t>(first->face), static_cast<std::uint32_t>(entry->face));
            }
        }
    }

    /// All doubled faces at an edge are of one sheet.
    void judge(Entries entries) {
        const auto first = std::ranges::find_if(entries, [this](const auto& entry) { return is_doubled(entry); });
        if (first == entries.end()) {
            return;
        }
        const auto others = std::ranges::count_if(entries, [this](const auto& entry) { return !is_doubled(entry); });
        const std::uint32_t sheet = sheets_.find(static_cast<std::uint32_t>(first->face));
        stands_on_others_[sheet] = others > 0 ? 1 : stands_on_others_[sheet];
        leaves_border_[sheet] = others % 2 != 0 ? 1 : leaves_border_[sheet];
    }

    const std::vector<std::uint8_t>& doubled_;
    UnionFind sheets_;
    std::vector<std::uint8_t> leaves_border_;
    std::vector<std::uint8_t> stands_on_others_;
};

} // namespace

void drop_thin_walls(Scan& scan, const std::vector<std::uint8_t>& doubled, RepairCounts& counts) {
    Sheets sheets(scan, doubled);
    std::vector<std::uint8_t> dropped(scan.faces.size(), 0);
    for (std::size_t face = 0; face < dropped.size(); ++face) {
        dropped[face] = sheets.is_thin_wall(face) ? 1 : 0;
    }
    counts.thin_wall_faces += drop_marked_faces(scan, dropped);
}

} // namespace foldless
