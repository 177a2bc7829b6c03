#include <foldless/tools/option_values.h>

#include <foldless/io/numbers.h>
#include <foldless/io/printable.h>
#include <foldless/tools/wrong_usage.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace foldless {

namespace {

// More threads than any machine has cores for today, and few enough that the system can start them.
constexpr int most_threads = 1024;

[[noreturn]] void refuse(const OptionText& text, std::string_view wanted) {
    throw WrongUsage(fmt::format("{} takes {}, not {}", text.option, wanted, in_quotes(text.text)));
}

/// The finite number that the text spells, or NaN.
double finite_number(std::string_view text) {
    const Parsed<double> parsed = parse_double(text);
    return parsed.ok() && std::isfinite(parsed.value) ? parsed.value : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

std::size_t face_count(const OptionText& text) {
    const Parsed<std::int64_t> parsed = parse_integer(text.text);
    if (!parsed.ok() || parsed.value < 1) {
        refuse(text, "a whole number of faces, at least 1");
    }
    return static_cast<std::size_t>(parsed.value);
}

int whole_number(const OptionText& text, const std::pair<int, int>& bounds) {
    const Parsed<std::int64_t> parsed = parse_integer(text.text);
    if (!parsed.ok() || parsed.value < bounds.first || parsed.value > bounds.second) {
        refuse(text, fmt::format("a whole number from {} to {}", bounds.first, bounds.second));
    }
    return static_cast<int>(parsed.value);
}

int thread_count(const OptionText& text) {
    return whole_number(text, {1, most_threads});
}

double ratio(const OptionText& text) {
    const double value = finite_number(text.text);
    if (!(value > 0.0 && value <= 1.0)) {
        refuse(text, "a number above 0 and at most 1");
    }
    return value;
}

double seconds(const OptionText& text) {
    const double value = finite_number(text.text);
    if (!(value >= 0.0)) {
        refuse(text, "a number of seconds, at least 0");
    }
    return value;
}

Length length(const OptionText& text) {
    std::string_view number = text.text;
    const bool relative = number.ends_with('%');
    if (relative) {
        number.remove_suffix(1);
    }
    const double value = finite_number(number);
    if (!(value >= 0.0)) {
        refuse(text, "a length of at least 0 in model units, or a percentage of the diagonal such as 1%");
    }
    return {relative ? value / 100.0 : value, relative};
}

std::filesystem::path file_name(const OptionText& text) {
    if (text.text.empty()) {
        throw WrongUsage(fmt::format("{} takes the name of a file, not an empty text", text.option));
    }
    return text.text;
}

bool yes_or_no(const OptionText& text) {
    static constexpr std::array<std::string_view, 2> words{"no", "yes"};
    if (std::ranges::find(words, text.text) == words.end()) {
        refuse_word(text, words);
    }
    return text.text == "yes";
}

void refuse_word(const OptionText& text, std::span<const std::string_view> words) {
    refuse(text, fmt::format("one of {}", fmt::join(words, ", ")));
}

} // namespace foldless
