/// \file
/// The exit codes of the program; a program that a signal ends has 128 plus the number of the signal.
#pragma once

namespace foldless {

enum class ExitCode : int {
    done = 0,
    internal_error = 1,
    wrong_usage = 2,
    unreadable = 3,    ///< the input cannot be read
    refused = 4,       ///< the input was read but cannot be used
    unwritable = 5,    ///< the output cannot be written
    not_certified = 6, ///< the base mesh does not represent the scan
    out_of_memory = 7,
};

} // namespace foldless
