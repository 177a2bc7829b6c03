/// \file
/// The words of the command line, of the report and of file headers for the options of a decimation.
#pragma once

#include <foldless/decimate/decimate.h>
#include <foldless/report/preset.h>

#include <array>
#include <optional>
#include <string_view>

namespace foldless {

/// The words for the values of an enumeration, in the order of its values.
template <class Option>
struct OptionNames;

template <>
struct OptionNames<Preset> {
    static constexpr std::array<std::string_view, 2> words{"default", "paper"};
};

template <>
struct OptionNames<Directions> {
    static constexpr std::array<std::string_view, 4> words{"visible", "area", "angle", "face"};
};

template <>
struct OptionNames<Placement> {
    static constexpr std::array<std::string_view, 4> words{"best", "endpoint", "midpoint", "quadric"};
};

template <>
struct OptionNames<Boundary> {
    static constexpr std::array<std::string_view, 2> words{"lock", "trim"};
};

template <>
struct OptionNames<StopReason> {
    static constexpr std::array<std::string_view, 4> words{"target_reached", "every_edge_refused", "time_limit",
                                                           "cancelled"};
};

/// The word for a value.
template <class Option>
[[nodiscard]] constexpr std::string_view option_name(Option value) {
    return OptionNames<Option>::words[static_cast<std::size_t>(value)];
}

/// The value that a word names, if it names one.
template <class Option>
[[nodiscard]] constexpr std::optional<Option> option_named(std::string_view word) {
    const auto& words = OptionNames<Option>::words;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == word) {
            return static_cast<Option>(i);
        }
    }
    return std::nullopt;
}

} // namespace foldless
