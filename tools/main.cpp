/// \file
/// The program `foldless`.

#include <foldless/tools/bake.h>
#include <foldless/tools/command_line.h>
#include <foldless/tools/exit_code.h>
#include <foldless/tools/failure.h>
#include <foldless/tools/info.h>
#include <foldless/tools/large_blocks.h>
#include <foldless/tools/reconstruct.h>
#include <foldless/tools/repair.h>
#include <foldless/tools/signals.h>
#include <foldless/tools/simplify.h>
#include <foldless/tools/standard_streams.h>
#include <foldless/tools/verify.h>

#include <variant>

namespace foldless {

namespace {

ExitCode run(const PrintCommand& command) {
    write_result(command.text);
    return ExitCode::done;
}

ExitCode run_program(int argc, const char* const* argv) noexcept {
    try {
        return std::visit([](const auto& command) { return run(command); }, parse_command_line(argc, argv));
    } catch (...) {
        return describe_failure();
    }
}

} // namespace

} // namespace foldless

// Shared libraries have constructors that take memory. What stands in this section of the program runs before them.
[[gnu::section(".preinit_array"), gnu::used]] void (*const before_all_else)() = foldless::handle_termination;

int main(int argc, char** argv) {
    foldless::open_closed_streams();
    foldless::handle_signals();
    foldless::return_large_blocks();
    return static_cast<int>(foldless::run_program(argc, argv));
}
