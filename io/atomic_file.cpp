#include <foldless/io/atomic_file.h>

#include <foldless/io/printable.h>

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>
#include <system_error>
#include <utility>

namespace foldless {

namespace {

// What a signal handler may look at: memory that is never moved or freed, and flags without locks.
enum class SlotState : int { free, filling, armed };

constexpr std::size_t slot_count = 16;  // far more than the three outputs of one run
constexpr std::size_t slot_size = 4096; // PATH_MAX of Linux, the longest name that the system accepts

struct Slot {
    std::atomic<SlotState> state{SlotState::free};
    std::array<char, slot_size> path{};
};

static_assert(std::atomic<SlotState>::is_always_lock_free);

std::array<Slot, slot_count> slots;

/// Enters a path into the table; -1 if it has no room.
int arm(const std::string& path) {
    if (path.size() >= slot_size) {
        return -1;
    }
    for (std::size_t i = 0; i < slot_count; ++i) {
        SlotState expected = SlotState::free;
        if (slots[i].state.compare_exchange_strong(expected, SlotState::filling)) {
            std::memcpy(slots[i].path.data(), path.c_str(), path.size() + 1);
            slots[i].state = SlotState::armed;
            return static_cast<int>(i);
        }
    }
    return -1;
}

void disarm(int slot) {
    if (slot >= 0) {
        slots[static_cast<std::size_t>(slot)].state = SlotState::free;
    }
}

constexpr mode_t permissions = 0666; // for all, less what the user's umask takes away

constexpr std::size_t buffer_size = std::size_t{1} << 20; // bytes; large enough that calls to the system cost nothing

// Names of files left behind by a program that was killed may be in the way; more than these never are.
constexpr int most_attempts = 100;

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view reason) {
    throw UnwritableFile(fmt::format("{}: {}", printable(path), reason));
}

std::string system_message() {
    return std::generic_category().message(errno);
}

/// The file that the name stands for: a symbolic link is followed, so that the link itself survives.
std::filesystem::path resolved(const std::filesystem::path& target) {
    if (!target.has_filename()) {
        fail(target, "cannot be written: is not the name of a file");
    }
    std::error_code error;
    std::filesystem::path real = std::filesystem::canonical(target, error);
    // Not for want of memory: the link itself would be replaced.
    if (error == std::errc::not_enough_memory) {
        throw std::bad_alloc();
    }
    if (error) {
        real = std::filesystem::absolute(target, error);
    }
    return error ? target : real;
}

/// Renaming onto a folder or an impossible name fails late, and onto a device it would replace the device.
void require_writable_target(const std::filesystem::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) {
        // A name that is too long, say: the temporary file has another, so that only the renaming would fail.
        if (errno != ENOENT) {
            fail(path, fmt::format("cannot be written: {}", system_message()));
        }
        return;
    }
    if (S_ISDIR(status.st_mode)) {
        fail(path, "cannot be written: is a folder");
    }
    if (!S_ISREG(status.st_mode)) {
        fail(path, "cannot be written: is not a regular file");
    }
    if (::access(path.c_str(), W_OK) != 0) {
        fail(path, fmt::format("cannot be written: {}", system_message()));
    }
}

/// A short name that no other call of this or another process uses at this time, with the extension of the target, so
/// that what was written can be read back before it is committed.
std::string temporary_name(const std::filesystem::path& target) {
    static std::atomic<unsigned> counter{0};
    return fmt::format(".foldless-{}-{}{}", ::getpid(), counter++, target.extension().string());
}

} // namespace

AtomicFile::AtomicFile(const std::filesystem::path& target) : target_(resolved(target)) {
    require_writable_target(target_);
    buffer_.reserve(buffer_size);
    for (int attempt = 0; attempt < most_attempts && descriptor_ < 0; ++attempt) {
        disarm(slot_);
        temporary_ = target_.parent_path() / temporary_name(target_);
        // Entered before it exists: a signal in between finds nothing to remove, instead of missing the file.
        slot_ = arm(temporary_.string());
        if (slot_ < 0) {
            fail(target, "cannot be written: too many files are being written, or the path is too long");
        }
        descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, permissions);
        if (descriptor_ < 0 && errno != EEXIST) {
            break;
        }
    }
    if (descriptor_ < 0) {
        const int reason = errno;
        disarm(slot_);
        errno = reason;
        fail(target, fmt::format("cannot be written: {}", system_message()));
    }
}

AtomicFile::~AtomicFile() {
    close_descriptor();
    if (!temporary_.empty()) {
        ::unlink(temporary_.c_str());
        disarm(slot_);
    }
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : target_(std::move(other.target_)), temporary_(std::move(other.temporary_)), buffer_(std::move(other.buffer_)),
      descriptor_(std::exchange(other.descriptor_, -1)), slot_(std::exchange(other.slot_, -1)) {
    other.temporary_.clear();
}

void AtomicFile::write(std::string_view bytes) {
    if (buffer_.size() + bytes.size() > buffer_size) {
        flush();
    }
    if (bytes.size() > buffer_size) {
        write_out(bytes);
    } else {
        buffer_ += bytes;
    }
}

void AtomicFile::finish() {
    if (descriptor_ < 0) {
        return;
    }
    flush();
    if (::fsync(descriptor_) != 0) {
        fail_with_errno("cannot be written");
    }
    if (::close(std::exchange(descriptor_, -1)) != 0) {
        fail_with_errno("cannot be written");
    }
}

void AtomicFile::commit() {
    finish();
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) {
        fail_with_errno("cannot be replaced");
    }
    temporary_.clear();
    disarm(std::exchange(slot_, -1));
}

void AtomicFile::flush() {
    write_out(buffer_);
    buffer_.clear();
}

void AtomicFile::write_out(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) {
            fail_with_errno("cannot be written");
        }
        bytes.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
    }
}

void AtomicFile::close_descriptor() {
    if (descriptor_ >= 0) {
        ::close(std::exchange(descriptor_, -1));
    }
}

void AtomicFile::fail_with_errno(std::string_view what) const {
    const std::string reason = system_message();
    fail(target_, fmt::format("{}: {}", what, reason));
}

void commit_all(std::vector<AtomicFile>& files) {
    for (AtomicFile& file : files) {
        file.finish();
    }
    for (AtomicFile& file : files) {
        file.commit();
    }
}

void remove_temporary_files() noexcept {
    for (const Slot& slot : slots) {
        if (slot.state == SlotState::armed) {
            ::unlink(slot.path.data());
        }
    }
}

} // namespace foldless
