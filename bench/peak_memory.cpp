#include <foldless/bench/peak_memory.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

namespace foldless {
namespace {

constexpr std::size_t bytes_per_kibibyte = 1024;

[[noreturn]] void do_and_leave(const std::function<void()>& work) noexcept {
    work();
    // Neither the streams nor the static objects of the parent are the child's to end.
    _exit(EXIT_SUCCESS);
}

} // namespace

std::size_t peak_memory_of(const std::function<void()>& work) {
    const pid_t child = fork();
    if (child < 0) {
        throw std::runtime_error("cannot start a child process");
    }
    if (child == 0) {
        do_and_leave(work);
    }
    int status = 0;
    rusage usage{};
    if (wait4(child, &status, 0, &usage) != child || !WIFEXITED(status) || WEXITSTATUS(status) != EXIT_SUCCESS) {
        throw std::runtime_error("the child process has failed");
    }
    return static_cast<std::size_t>(usage.ru_maxrss) * bytes_per_kibibyte;
}

} // namespace foldless
