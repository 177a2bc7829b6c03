/// \file
/// Messages for a person, on standard error.
#pragma once

#include <foldless/report/progress_bar.h>

#include <string_view>
#include <vector>

namespace foldless {

/// Prints an error, a warning, or anything that must be said with `--quiet` too: one line, `foldless: text`.
/// Takes no memory.
void print_message(std::string_view text) noexcept;

/// What is said unless `--quiet`. Takes no memory.
class Console {
public:
    explicit Console(bool quiet) : quiet_(quiet) {}

    /// Prints each line as it is.
    void print(const std::vector<std::string>& lines) const noexcept;
    /// Prints `foldless: text`.
    void note(std::string_view text) const noexcept;
    /// A bar, which shows only on a terminal.
    [[nodiscard]] ProgressBar::Write bar_output() const;

private:
    bool quiet_;
};

} // namespace foldless
