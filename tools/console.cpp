#include <foldless/tools/console.h>

#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <string>

namespace foldless {

namespace {

/// In one call, so that lines of several programs do not mix. That a message is lost must not lose the result.
void write_to_standard_error(std::string_view text) {
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

/// In one call, as above, and without memory, of which there may be none to tell of.
void write_line(std::string_view start, std::string_view text) noexcept {
    constexpr std::string_view end = "\n";
    std::array<iovec, 3> parts{};
    std::ranges::transform(std::array{start, text, end}, parts.begin(), [](std::string_view part) {
        return iovec{const_cast<char*>(part.data()), part.size()};
    });
    [[maybe_unused]] const ssize_t written = ::writev(STDERR_FILENO, parts.data(), static_cast<int>(parts.size()));
}

} // namespace

void print_message(std::string_view text) noexcept {
    write_line("foldless: ", text);
}

void Console::print(const std::vector<std::string>& lines) const noexcept {
    if (quiet_) {
        return;
    }
    for (const std::string& line : lines) {
        write_line("", line);
    }
}

void Console::note(std::string_view text) const noexcept {
    if (!quiet_) {
        print_message(text);
    }
}

ProgressBar::Write Console::bar_output() const {
    return quiet_ || ::isatty(STDERR_FILENO) == 0 ? ProgressBar::Write{} : write_to_standard_error;
}

} // namespace foldless
