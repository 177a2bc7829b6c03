/// \file
/// Reads a text file line by line and token by token, and knows the line for its messages.
#pragma once

#include <foldless/io/errors.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace foldless {

/// A line ends at LF, CR LF or CR. A byte order mark at the start of the file is passed over. Tokens are separated by
/// blanks and tabs. A token that is missing, or is not what was asked for, throws UnreadableFile with the file, the
/// line and the reason. Every byte is visited a bounded number of times.
class TextCursor {
public:
    struct Options {
        bool comments = false;      ///< a `#` starts a comment, to the end of the line
        bool continuations = false; ///< a backslash at the end of a line joins it with the next, save in comments
        std::size_t first_line = 1; ///< the number of the first line of the text in its file
    };

    /// `text` must outlive the cursor. `name` is the name of the file in messages.
    TextCursor(std::string_view text, std::string name, const Options& options);

    /// Goes to the next line that has a token; false at the end of the text.
    bool next_line();
    /// The next token of the line, empty at its end.
    [[nodiscard]] std::string_view token();
    /// The next token of the line without taking it.
    [[nodiscard]] std::string_view peek();
    /// The next token of the line or of those that follow, empty at the end of the text.
    [[nodiscard]] std::string_view token_of_any_line();

    /// What is left of the line as a name: without blanks at its ends, and without a comment, which here starts behind
    /// a blank only, for names of files may have a `#`. It is not taken, and no continuation belongs to it.
    [[nodiscard]] std::string_view rest_of_line() const;

    /// Numbers; `what` names them in messages, e.g. "x", and may come from the file.
    [[nodiscard]] double real(std::string_view what);
    [[nodiscard]] float real32(std::string_view what);
    [[nodiscard]] std::int64_t integer(std::string_view what);

    /// Leaves the rest of the line unread, its end included.
    void skip_line();
    /// \throws UnreadableFile if the line has another token.
    void require_end_of_line();

    [[nodiscard]] std::size_t line() const { return line_; }
    /// Bytes that are not read yet.
    [[nodiscard]] std::size_t bytes_left() const { return text_.size() - position_; }
    /// Throws UnreadableFile: file, line, reason.
    [[noreturn]] void fail(std::string_view reason) const;
    [[noreturn]] void fail_at(std::size_t line, std::string_view reason) const;

private:
    void skip_blanks();
    bool take_line_end();
    [[nodiscard]] bool starts_comment(std::size_t position) const;
    [[nodiscard]] bool joins_lines(std::size_t position) const;

    std::string_view text_;
    std::string name_;
    Options options_;
    std::size_t position_ = 0;
    std::size_t line_ = 1;
    bool started_ = false;
};

} // namespace foldless
