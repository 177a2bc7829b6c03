/// \file
/// What can go wrong with a user's file. Three exceptions, one for each exit code of the program that concerns files.
#pragma once

#include <stdexcept>
#include <string>

namespace foldless {

/// The file cannot be read: missing, unreadable, or bytes that are not numbers and indices in range. The message names
/// file, line or byte offset, and the reason. (exit code 3)
class UnreadableFile : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The mesh was read but cannot be used; the message counts each defect by name. (exit code 4)
class RefusedMesh : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The output cannot be written; an existing file of that name is untouched. (exit code 5)
class UnwritableFile : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

} // namespace foldless
