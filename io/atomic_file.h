/// \file
/// Output files that appear whole or not at all.
#pragma once

#include <foldless/io/errors.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace foldless {

/// A file that is written under a temporary name in the folder of its target and renamed onto the target at the end.
/// Until commit() an existing target is untouched; without commit() the temporary file is removed by the destructor.
/// A target that is a symbolic link to a file is replaced where the link points.
///
/// Every function throws UnwritableFile when the system refuses; the temporary file is then removed by the destructor.
class AtomicFile {
public:
    /// Creates the temporary file. The target must not exist or be a regular file that may be written.
    explicit AtomicFile(const std::filesystem::path& target);
    ~AtomicFile();
    AtomicFile(AtomicFile&& other) noexcept;
    AtomicFile& operator=(AtomicFile&&) = delete;

    /// Appends. Small pieces are gathered before they go to the system.
    void write(std::string_view bytes);
    /// Hands everything to the disk and closes the file, which still has its temporary name and can be read back.
    void finish();
    /// Finishes and renames.
    void commit();

    [[nodiscard]] const std::filesystem::path& temporary_path() const { return temporary_; }

private:
    void flush();
    void write_out(std::string_view bytes);
    void close_descriptor();
    [[noreturn]] void fail_with_errno(std::string_view what) const;

    std::filesystem::path target_;    ///< with symbolic links resolved
    std::filesystem::path temporary_; ///< empty after a move or a commit
    std::string buffer_;
    int descriptor_ = -1;
    int slot_ = -1; ///< in the table of remove_temporary_files()
};

/// Commits each, once all of them are on the disk. Takes no memory, so that a run that prepares what it says afterwards
/// cannot end for want of it when some outputs are new and others are not.
///
/// \throws UnwritableFile when the system refuses
void commit_all(std::vector<AtomicFile>& files);

/// Removes the temporary files that are open at this moment. Async-signal-safe: a signal handler calls it before it
/// ends the program. Not for anything else, as the files in question can no longer be committed.
void remove_temporary_files() noexcept;

} // namespace foldless
