// Any bytes as a base mesh, PLY or OBJ: read soundly, or refused in one line; and what was read and written is read
// again as it was.

#include "reading.h"
#include "same_base.h"

#include <foldless/io/read_mesh.h>
#include <foldless/io/write_mesh.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

namespace foldless::fuzz {
namespace {

/// A folder in memory, removed when the process ends normally.
class Folder {
public:
    Folder() : path_("/dev/shm/foldless-fuzz-" + std::to_string(::getpid())) {
        std::filesystem::create_directory(path_);
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    [[nodiscard]] std::filesystem::path file(const char* name) const { return path_ / name; }

private:
    std::filesystem::path path_;
};

std::optional<BaseMesh> read_or_refused(const std::filesystem::path& path) {
    try {
        return read_base_mesh(path).base;
    } catch (const UnreadableFile& error) {
        require_one_line(error.what());
    } catch (const RefusedMesh& error) {
        require_one_line(error.what());
    }
    return std::nullopt;
}

/// A base mesh with positions that are no numbers is read, since it is refused later with its other defects.
bool has_finite_positions(const BaseMesh& base) {
    return std::ranges::all_of(base.positions, [](const Vec3& position) { return position.allFinite(); });
}

void require_same_again(const BaseMesh& base, const std::filesystem::path& path) {
    try {
        write_base_mesh(path, base, {});
    } catch (const UnwritableFile& error) { // values that float32 does not hold
        require_one_line(error.what());
        return;
    }
    require(is_same(read_base_mesh(path).base, base), "what was written is read as it was");
}

} // namespace
} // namespace foldless::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace foldless::fuzz;
    static const Folder folder;
    const std::string_view text = text_of(data, size);
    const std::filesystem::path path = folder.file(text.starts_with("ply") ? "base.ply" : "base.obj");
    std::ofstream(path, std::ios::binary) << text;
    const std::optional<foldless::BaseMesh> base = read_or_refused(path);
    if (base && has_finite_positions(*base)) {
        require_same_again(*base, folder.file("again.ply"));
    }
    return 0;
}
