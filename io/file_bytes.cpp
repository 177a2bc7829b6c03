#include <foldless/io/file_bytes.h>

#include <foldless/io/printable.h>

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <new>
#include <system_error>

namespace foldless {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
    throw UnreadableFile(fmt::format("{}: {}", printable(path), reason));
}

[[noreturn]] void fail_with_errno(const std::filesystem::path& path) {
    if (errno == ENOMEM) {
        throw std::bad_alloc();
    }
    fail(path, std::generic_category().message(errno));
}

/// A file descriptor that closes itself.
class Descriptor {
public:
    explicit Descriptor(int value) : value_(value) {}
    ~Descriptor() {
        if (value_ >= 0) {
            ::close(value_);
        }
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int value() const { return value_; }

private:
    int value_;
};

std::size_t regular_file_size(const Descriptor& file, const std::filesystem::path& path) {
    struct stat status {};
    if (::fstat(file.value(), &status) != 0) {
        fail_with_errno(path);
    }
    if (S_ISDIR(status.st_mode)) {
        fail(path, "is a folder");
    }
    if (!S_ISREG(status.st_mode)) {
        fail(path, "is not a regular file");
    }
    if (status.st_size == 0) {
        fail(path, "the file is empty");
    }
    return static_cast<std::size_t>(status.st_size);
}

} // namespace

FileBytes::FileBytes(const std::filesystem::path& path) {
    // Without O_NONBLOCK, opening a pipe that nobody writes to would wait for ever.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    if (file.value() < 0) {
        fail_with_errno(path);
    }
    size_ = regular_file_size(file, path);
    void* mapped = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file.value(), 0);
    if (mapped == MAP_FAILED) {
        fail_with_errno(path);
    }
    ::madvise(mapped, size_, MADV_SEQUENTIAL);
    data_ = static_cast<const char*>(mapped);
}

FileBytes::~FileBytes() {
    ::munmap(const_cast<char*>(data_), size_);
}

} // namespace foldless
