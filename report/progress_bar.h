/// \file
/// A bar for a terminal that shows how far a run has come.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

namespace foldless {

/// "decimating [#####.....]  50 %  3000 faces": one line of text, no control characters. `share` is cut to [0, 1].
[[nodiscard]] std::string bar_text(std::string_view label, double share, std::string_view detail);

/// Redraws one line of a terminal, some ten times a second however often it is called. What it draws goes to `write`,
/// with the control characters that move within the line; nothing is left on the line when the bar ends.
class ProgressBar {
public:
    using Write = std::function<void(std::string_view)>;

    /// A bar without `write` draws nothing.
    explicit ProgressBar(Write write) : write_(std::move(write)) {}
    ~ProgressBar() { clear(); }
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void show(std::string_view label, double share, std::string_view detail);
    /// Empties the line, so that something else may be written there.
    void clear();

private:
    Write write_;
    bool drawn_ = false;
    std::chrono::steady_clock::time_point next_{}; ///< nothing is drawn before
};

} // namespace foldless
