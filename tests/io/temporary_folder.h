/// \file
/// A folder for the files of one test.
#pragma once

#include <foldless/io/errors.h>
#include <foldless/io/read_mesh.h>
#include <foldless/io/scan_appearance.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace foldless {

/// A new empty folder that is removed with everything in it at the end of the test.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// Writes a file of this name and returns its path.
    std::filesystem::path file(const std::string& name, std::string_view bytes) const;
    /// The names of all files in the folder, sorted.
    [[nodiscard]] std::vector<std::string> names() const;

private:
    std::filesystem::path path_;
};

[[nodiscard]] std::string bytes_of(const std::filesystem::path& path);

/// Reads these bytes as a scan, coloured scan or base mesh in a file of this name.
[[nodiscard]] ReadScan scan_of(const std::string& name, std::string_view bytes);
[[nodiscard]] ReadColouredScan coloured_scan_of(const std::string& name, std::string_view bytes);
[[nodiscard]] ReadBaseMesh base_mesh_of(const std::string& name, std::string_view bytes);

/// What an exception of this type says when `act` throws one; "no error" if it throws none.
template <class Error, class Act>
[[nodiscard]] std::string message_of(Act&& act) {
    try {
        act();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

/// The message with which reading is refused, without the folder in front.
[[nodiscard]] std::string unreadable(const std::string& name, std::string_view bytes);
[[nodiscard]] std::string unreadable_colours(const std::string& name, std::string_view bytes);
[[nodiscard]] std::string refused(const std::string& name, std::string_view bytes);

} // namespace foldless
