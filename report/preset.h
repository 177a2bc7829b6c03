/// \file
/// The named sets of options.
#pragma once

namespace foldless {

/// Which set of options the explicit ones are laid over.
enum class Preset {
    standard, ///< `default`: DecimateOptions{}
    paper,    ///< paper_options()
};

} // namespace foldless
