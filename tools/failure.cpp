#include <foldless/tools/failure.h>

#include <foldless/io/atomic_file.h>
#include <foldless/io/errors.h>
#include <foldless/tools/console.h>
#include <foldless/tools/wrong_usage.h>

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace foldless {

namespace {

ExitCode fail(std::string_view message, ExitCode code) {
    print_message(message);
    return code;
}

ExitCode fail_internally(std::string_view reason) {
    return fail("internal error: " + std::string(reason) +
                    "; this is a bug in foldless: please report it with the command and the mesh",
                ExitCode::internal_error);
}

ExitCode fail_without_memory() {
    return fail("out of memory", ExitCode::out_of_memory);
}

/// oneTBB tells by its text alone that the system has no room for another thread.
bool is_refused_thread(const std::runtime_error& error) {
    const std::string_view text = error.what();
    return text.ends_with(std::generic_category().message(EAGAIN)) ||
           text.ends_with(std::generic_category().message(ENOMEM));
}

ExitCode describe_system_error(const std::system_error& error) {
    const bool exhausted = error.code() == std::errc::not_enough_memory ||
                           error.code() == std::errc::resource_unavailable_try_again; // threads need memory
    return exhausted ? fail_without_memory() : fail_internally(error.what());
}

ExitCode describe_current_exception() {
    try {
        throw;
    } catch (const WrongUsage& error) {
        return fail(error.what(), ExitCode::wrong_usage);
    } catch (const UnreadableFile& error) {
        return fail(error.what(), ExitCode::unreadable);
    } catch (const RefusedMesh& error) {
        return fail(error.what(), ExitCode::refused);
    } catch (const UnwritableFile& error) {
        return fail(error.what(), ExitCode::unwritable);
    } catch (const std::bad_alloc&) {
        return fail_without_memory();
    } catch (const std::system_error& error) {
        return describe_system_error(error);
    } catch (const std::runtime_error& error) {
        return is_refused_thread(error) ? fail_without_memory() : fail_internally(error.what());
    } catch (const std::exception& error) {
        return fail_internally(error.what());
    } catch (...) {
        return fail_internally("unknown exception");
    }
}

/// Ends the program from where it is, in whatever thread. The first thread that comes here tells why; others only wait.
[[noreturn]] void end_at_once(ExitCode (*tell)()) {
    static std::atomic_flag ending;
    while (ending.test_and_set()) {
        ::pause();
    }
    const ExitCode code = tell();
    remove_temporary_files();
    ::_exit(static_cast<int>(code));
}

[[noreturn]] void terminate() {
    end_at_once([] { return std::current_exception() ? describe_failure() : fail_internally("terminated"); });
}

[[noreturn]] void end_without_memory() {
    end_at_once(fail_without_memory);
}

} // namespace

ExitCode describe_failure() noexcept {
    try {
        return describe_current_exception();
    } catch (...) {
        return fail_without_memory(); // the message found no room
    }
}

void handle_termination() {
    std::set_terminate(terminate);
    std::set_new_handler(end_without_memory);
}

} // namespace foldless
