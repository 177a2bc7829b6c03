/// \file
/// The bytes of an input file.
#pragma once

#include <foldless/io/errors.h>

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace foldless {

/// A regular file mapped into memory, so that a header may claim anything without memory being taken for it. The file
/// must not be shortened while it is mapped: the system then ends the program with SIGBUS.
class FileBytes {
public:
    /// \throws UnreadableFile if the file is missing, empty, may not be read, or is no regular file (a folder, a pipe,
    /// a device: reading those might never end).
    /// \throws std::bad_alloc if the file does not fit into the address space.
    explicit FileBytes(const std::filesystem::path& path);
    ~FileBytes();
    FileBytes(const FileBytes&) = delete;
    FileBytes& operator=(const FileBytes&) = delete;

    [[nodiscard]] std::string_view bytes() const { return {data_, size_}; }

private:
    const char* data_ = nullptr;
    std::size_t size_ = 0;
};

} // namespace foldless
