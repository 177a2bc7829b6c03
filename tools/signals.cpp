#include <foldless/tools/signals.h>

#include <foldless/io/atomic_file.h>

#include <csignal>

namespace foldless {

namespace {

/// Those by which people and systems end a program, and SIGBUS, which comes when a mapped input file is shortened.
constexpr int ending_signals[]{SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU, SIGUSR1, SIGUSR2, SIGALRM, SIGBUS};

/// The handler is gone by now (SA_RESETHAND), so that the signal, raised again, ends the program as it always does.
void clean_up_and_end(int number) {
    remove_temporary_files();
    std::raise(number);
}

} // namespace

void handle_signals() {
    struct sigaction ending {};
    ending.sa_handler = clean_up_and_end;
    ending.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&ending.sa_mask);
    for (const int number : ending_signals) {
        struct sigaction found {};
        if (sigaction(number, nullptr, &found) == 0 && found.sa_handler != SIG_IGN) {
            sigaction(number, &ending, nullptr);
        }
    }
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

} // namespace foldless
