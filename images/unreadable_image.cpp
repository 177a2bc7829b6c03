#include <foldless/images/unreadable_image.h>

#include <foldless/io/printable.h>

#include <fmt/format.h>

namespace foldless {

UnreadableFile unreadable_image(const std::string& name, std::string_view format, std::string_view reason) {
    return UnreadableFile(
        fmt::format("{}: not a readable {} file: {}", printable(name), format, printable(std::string(reason))));
}

} // namespace foldless
