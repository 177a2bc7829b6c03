/// \file
/// Calls of C libraries that leave by longjmp() when they fail, made into exceptions.
#pragma once

#include <array>
#include <csetjmp>
#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>

namespace foldless {

/// What a C library says of its failure.
class LibraryFailure : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The place where a failing C library goes on. The library's handler of errors calls fail(); its callbacks, through
/// which no exception may pass, do their work in call().
class JumpBack {
public:
    /// Runs `steps`, which call the library and create nothing that has a destructor: a jump passes it by.
    /// \throws LibraryFailure with the words of fail(), std::bad_alloc after out_of_memory(), or what call() caught.
    template <class Steps>
    void run(const Steps& steps) {
        if (setjmp(place_) == 0) {
            steps();
            return;
        }
        if (thrown_) {
            std::rethrow_exception(thrown_);
        }
        if (out_of_memory_) {
            throw std::bad_alloc();
        }
        throw LibraryFailure(message_.data());
    }

    /// Only within run().
    template <class Work>
    void call(const Work& work) {
        try {
            work();
        } catch (...) {
            thrown_ = std::current_exception();
        }
        if (thrown_) {
            std::longjmp(place_, 1);
        }
    }

    /// Only within run(). The message is cut where there is no room.
    [[noreturn]] void fail(std::string_view message) {
        message_[message.copy(message_.data(), message_.size() - 1)] = '\0';
        std::longjmp(place_, 1);
    }

    /// Whatever the library says next, memory has run out.
    void out_of_memory() { out_of_memory_ = true; }

private:
    std::jmp_buf place_{};
    std::array<char, 256> message_{};
    std::exception_ptr thrown_;
    bool out_of_memory_ = false;
};

} // namespace foldless
