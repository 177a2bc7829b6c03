#include <foldless/io/file_type.h>

#include <string_view>

namespace foldless {

namespace {

struct Extension {
    std::string_view text;
    FileType type;
};

constexpr Extension extensions[] = {
    {".ply", FileType::ply},
    {".obj", FileType::obj},
    {".off", FileType::off},
    {".stl", FileType::stl},
};

} // namespace

std::string lower_case_extension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) {
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return extension;
}

FileType file_type(const std::filesystem::path& path) {
    const std::string extension = lower_case_extension(path);
    for (const Extension& known : extensions) {
        if (known.text == extension) {
            return known.type;
        }
    }
    return FileType::unknown;
}

} // namespace foldless
