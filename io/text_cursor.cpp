#include <foldless/io/text_cursor.h>

#include <foldless/io/numbers.h>
#include <foldless/io/printable.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace foldless {

namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}

// No printable character and no byte of UTF-8 is at or below the blank.
bool ends_token(char c) {
    return static_cast<unsigned char>(c) <= ' ';
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && is_blank(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

template <class Number>
Number checked(const TextCursor& cursor, std::string_view token, std::string_view what, const Parsed<Number>& parsed) {
    if (parsed.ok()) {
        return parsed.value;
    }
    if (token.empty()) {
        cursor.fail(fmt::format("{} is missing", legible(what)));
    }
    const bool range = parsed.error == std::errc::result_out_of_range;
    cursor.fail(
        fmt::format("{} for {} {}", in_quotes(token), legible(what), range ? "is too large" : "is not a number"));
}

} // namespace

TextCursor::TextCursor(std::string_view text, std::string name, const Options& options)
    : text_(text), name_(std::move(name)), options_(options), line_(options.first_line) {
    if (options.first_line == 1 && text.starts_with(byte_order_mark)) {
        position_ = byte_order_mark.size();
    }
}

bool TextCursor::next_line() {
    if (started_) {
        skip_line();
    }
    started_ = true;
    while (position_ < text_.size() && peek().empty()) {
        skip_line();
    }
    return position_ < text_.size();
}

std::string_view TextCursor::token() {
    const std::string_view found = peek();
    position_ += found.size();
    return found;
}

std::string_view TextCursor::peek() {
    skip_blanks();
    if (position_ == text_.size() || is_line_end(text_[position_]) || starts_comment(position_)) {
        return {};
    }
    std::size_t end = position_;
    while (end < text_.size() && !ends_token(text_[end]) && !starts_comment(end) && !joins_lines(end)) {
        ++end;
    }
    if (end == position_) {
        fail(fmt::format("byte 0x{:02x} is not text", static_cast<unsigned char>(text_[position_])));
    }
    return text_.substr(position_, end - position_);
}

std::string_view TextCursor::token_of_any_line() {
    if (!peek().empty() || next_line()) {
        return token();
    }
    return {};
}

std::string_view TextCursor::rest_of_line() const {
    const std::size_t end = std::min(text_.find_first_of("\r\n", position_), text_.size());
    const auto starts_note = [this](std::size_t at) {
        return starts_comment(at) && (at == position_ || is_blank(text_[at - 1]));
    };
    std::size_t last = position_;
    while (last < end && !starts_note(last)) {
        ++last;
    }
    return trimmed(text_.substr(position_, last - position_));
}

double TextCursor::real(std::string_view what) {
    const std::string_view found = token();
    return checked(*this, found, what, parse_double(found));
}

float TextCursor::real32(std::string_view what) {
    const std::string_view found = token();
    return checked(*this, found, what, parse_float(found));
}

std::int64_t TextCursor::integer(std::string_view what) {
    const std::string_view found = token();
    const auto parsed = parse_integer(found);
    if (parsed.error == std::errc::invalid_argument && parse_double(found).ok()) {
        fail(fmt::format("{} for {} is not an integer", in_quotes(found), legible(what)));
    }
    return checked(*this, found, what, parsed);
}

void TextCursor::skip_line() {
    skip_blanks();
    const bool comment = position_ < text_.size() && starts_comment(position_);
    while (position_ < text_.size()) {
        const bool joined = !comment && position_ > 0 && joins_lines(position_ - 1);
        if (take_line_end() && !joined) {
            return;
        }
        while (position_ < text_.size() && !is_line_end(text_[position_])) {
            ++position_;
        }
    }
}

void TextCursor::require_end_of_line() {
    const std::string_view found = peek();
    if (!found.empty()) {
        fail(fmt::format("unexpected {} at the end of the line", in_quotes(found)));
    }
}

void TextCursor::fail(std::string_view reason) const {
    fail_at(line_, reason);
}

void TextCursor::fail_at(std::size_t line, std::string_view reason) const {
    throw UnreadableFile(fmt::format("{}: line {}: {}", name_, line, reason));
}

void TextCursor::skip_blanks() {
    while (position_ < text_.size()) {
        if (is_blank(text_[position_])) {
            ++position_;
        } else if (joins_lines(position_)) {
            ++position_;
            take_line_end();
        } else {
            return;
        }
    }
}

bool TextCursor::starts_comment(std::size_t position) const {
    return options_.comments && text_[position] == '#';
}

bool TextCursor::joins_lines(std::size_t position) const {
    return options_.continuations && text_[position] == '\\' && position + 1 < text_.size() &&
           is_line_end(text_[position + 1]);
}

bool TextCursor::take_line_end() {
    if (position_ == text_.size() || !is_line_end(text_[position_])) {
        return false;
    }
    const bool crlf = text_.substr(position_, 2) == "\r\n";
    position_ += crlf ? 2 : 1;
    ++line_;
    return true;
}

} // namespace foldless
