#include "temporary_folder.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <system_error>

namespace foldless {

namespace {

std::string without_folder(const std::string& message, const TemporaryFolder& folder) {
    const std::string prefix = folder.path().string() + "/";
    return message.starts_with(prefix) ? message.substr(prefix.size()) : message;
}

} // namespace

TemporaryFolder::TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "foldless-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
        throw std::system_error(errno, std::generic_category(), name);
    }
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path TemporaryFolder::file(const std::string& name, std::string_view bytes) const {
    const std::filesystem::path path = path_ / name;
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
}

std::vector<std::string> TemporaryFolder::names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) {
        names.push_back(entry.path().filename().string());
    }
    std::ranges::sort(names);
    return names;
}

std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

ReadScan scan_of(const std::string& name, std::string_view bytes) {
    const TemporaryFolder folder;
    return read_scan(folder.file(name, bytes));
}

ReadColouredScan coloured_scan_of(const std::string& name, std::string_view bytes) {
    const TemporaryFolder folder;
    return read_coloured_scan(folder.file(name, bytes));
}

ReadBaseMesh base_mesh_of(const std::string& name, std::string_view bytes) {
    const TemporaryFolder folder;
    return read_base_mesh(folder.file(name, bytes));
}

std::string unreadable(const std::string& name, std::string_view bytes) {
    const TemporaryFolder folder;
    const auto path = folder.file(name, bytes);
    return without_folder(message_of<UnreadableFile>([&] { static_cast<void>(read_scan(path)); }), folder);
}

std::string unreadable_colours(const std::string& name, std::string_view bytes) {
    const TemporaryFolder folder;
    const auto path = folder.file(name, bytes);
    return without_folder(message_of<UnreadableFile>([&] { static_cast<void>(read_coloured_scan(path)); }), folder);
}

std::string refused(const std::string& name, std::string_view bytes) {
    const TemporaryFolder folder;
    const auto path = folder.file(name, bytes);
    return without_folder(message_of<RefusedMesh>([&] { static_cast<void>(read_scan(path)); }), folder);
}

} // namespace foldless
