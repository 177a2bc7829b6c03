#include <foldless/io/file_type.h>

#include <string>
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

FileType file_type(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) {
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    for (const Extension& known : extensions) {
        if (known.text == extension) {
            return known.type;
        }
    }
    return FileType::unknown;
}

} // namespace foldless
