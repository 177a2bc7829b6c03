/// \file
/// A command line that makes no sense.
#pragma once

#include <stdexcept>

namespace foldless {

/// The message is one line that names the option or argument. (exit code 2)
class WrongUsage : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

} // namespace foldless
