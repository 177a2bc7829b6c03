/// \file
/// The values of options as they are spelled on the command line, the same in every locale.
#pragma once

#include <foldless/report/option_names.h>
#include <foldless/tools/command.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace foldless {

/// The text after an option, and the option for messages.
struct OptionText {
    const char* option;
    std::string text;
};

// Each throws WrongUsage with the option, what it takes, and what it was given.

[[nodiscard]] std::size_t face_count(const OptionText& text); ///< a whole number of at least 1
[[nodiscard]] int whole_number(const OptionText& text, const std::pair<int, int>& bounds); ///< within the bounds
[[nodiscard]] int thread_count(const OptionText& text);                ///< a whole number from 1 to 1024
[[nodiscard]] double ratio(const OptionText& text);                    ///< above 0, at most 1
[[nodiscard]] double seconds(const OptionText& text);                  ///< finite, at least 0
[[nodiscard]] Length length(const OptionText& text);                   ///< finite, at least 0, or the same with `%`
[[nodiscard]] std::filesystem::path file_name(const OptionText& text); ///< not empty

[[nodiscard]] bool yes_or_no(const OptionText& text);

/// \throws WrongUsage: the text is none of the words
[[noreturn]] void refuse_word(const OptionText& text, std::span<const std::string_view> words);

/// The value that a word names.
template <class Option>
[[nodiscard]] Option choice(const OptionText& text) {
    const std::optional<Option> value = option_named<Option>(text.text);
    if (!value) {
        refuse_word(text, OptionNames<Option>::words);
    }
    return *value;
}

} // namespace foldless
