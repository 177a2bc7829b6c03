#include <foldless/report/header_comments.h>

#include <foldless/report/option_names.h>
#include <foldless/report/version.h>

#include <fmt/format.h>

namespace foldless {

std::vector<std::string> header_comments(Preset preset, const DecimateOptions& options) {
    std::vector<std::string> lines{
        fmt::format("foldless {}", version()),
        fmt::format("preset {}", option_name(preset)),
        fmt::format("directions {}", option_name(options.directions)),
        fmt::format("store-directions {}", options.store_directions ? "yes" : "no"),
        fmt::format("placement {}", option_name(options.placement)),
        fmt::format("boundary {}", option_name(options.boundary)),
    };
    if (options.target_faces) {
        lines.push_back(fmt::format("faces {}", *options.target_faces));
    }
    if (options.max_displacement) {
        lines.push_back(fmt::format("max-displacement {}", *options.max_displacement));
    }
    return lines;
}

std::vector<std::string> header_comments(const RepairOptions& options) {
    return {
        fmt::format("foldless {}", version()),
        "repaired scan",
        fmt::format("min-component-faces {}", options.min_component_faces),
        fmt::format("drop-unserved {}", options.drop_unserved ? "yes" : "no"),
    };
}

} // namespace foldless
