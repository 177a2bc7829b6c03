#include <foldless/report/progress_bar.h>

#include <fmt/format.h>

#include <algorithm>

namespace foldless {

namespace {

constexpr int bar_width = 30; // characters; with label and detail the line stays below 80
constexpr std::chrono::milliseconds time_between_frames{100};

// ECMA-48: return to the start of the line, erase to its end.
constexpr std::string_view to_line_start = "\r";
constexpr std::string_view erase_line = "\r\x1b[K";

} // namespace

std::string bar_text(std::string_view label, double share, std::string_view detail) {
    const double part = share > 0.0 ? std::min(share, 1.0) : 0.0; // NaN draws an empty bar
    const int filled = static_cast<int>(part * bar_width);
    const int percents = static_cast<int>(part * 100.0);
    return fmt::format("{} [{:#<{}}{:.<{}}] {:3} %  {}", label, "", filled, "", bar_width - filled, percents, detail);
}

void ProgressBar::show(std::string_view label, double share, std::string_view detail) {
    const auto now = std::chrono::steady_clock::now();
    if (!write_ || now < next_) {
        return;
    }
    next_ = now + time_between_frames;
    drawn_ = true;
    write_(fmt::format("{}{}{}", erase_line, bar_text(label, share, detail), to_line_start));
}

void ProgressBar::clear() {
    if (drawn_) {
        write_(erase_line);
        drawn_ = false;
    }
}

} // namespace foldless
