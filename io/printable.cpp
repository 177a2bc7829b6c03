#include <foldless/io/printable.h>

#include <fmt/format.h>

#include <algorithm>

namespace foldless {

namespace {

// Enough to recognise a token in the file; a message stays on one line of a terminal.
constexpr std::size_t longest_quote = 40;

constexpr unsigned char first_printable = 0x20;
constexpr unsigned char delete_character = 0x7f;

} // namespace

std::string printable(const std::filesystem::path& path) {
    std::string text = path.string();
    std::ranges::replace_if(
        text, [](unsigned char c) { return c < first_printable || c == delete_character; }, '?');
    return text;
}

std::string legible(std::string_view token) {
    std::string text(token.substr(0, longest_quote));
    std::ranges::replace_if(
        text, [](unsigned char c) { return c < first_printable || c >= delete_character; }, '?');
    return token.size() > longest_quote ? text + "..." : text;
}

std::string in_quotes(std::string_view token) {
    return fmt::format("'{}'", legible(token));
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

} // namespace foldless
