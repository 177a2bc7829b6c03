#include <foldless/tools/standard_streams.h>

#include <foldless/io/errors.h>

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>

namespace foldless {

void open_closed_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) < 0 && errno == EBADF) {
            // The lowest free number is this one. What cannot be written to still reports an error when a result is.
            ::open("/dev/null", O_RDONLY);
        }
    }
}

void write_result(std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(STDOUT_FILENO, text.data(), text.size());
        if (written >= 0) {
            text.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno == EPIPE) {
            std::signal(SIGPIPE, SIG_DFL);
            std::raise(SIGPIPE);
        } else if (errno != EINTR) {
            throw UnwritableFile(
                fmt::format("standard output: cannot be written: {}", std::generic_category().message(errno)));
        }
    }
}

} // namespace foldless
