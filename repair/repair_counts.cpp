#include <foldless/repair/repair_counts.h>

#include <foldless/io/printable.h>

#include <algorithm>

namespace foldless {

bool RepairCounts::any() const {
    return std::ranges::any_of(repair_count_names,
                               [this](const RepairCountName& name) { return this->*name.count > 0; });
}

std::string RepairCounts::text() const {
    std::string text;
    for (const RepairCountName& name : repair_count_names) {
        if (this->*name.count > 0) {
            text += (text.empty() ? "" : ", ") + counted(this->*name.count, name.one, name.many);
        }
    }
    return text;
}

} // namespace foldless
