#include <foldless/images/read_image.h>

#include <foldless/images/read_exr.h>
#include <foldless/images/read_jpeg.h>
#include <foldless/images/read_png.h>
#include <foldless/io/file_type.h>
#include <foldless/io/printable.h>

#include <fmt/format.h>

#include <string>

namespace foldless {

ReadImage read_image(const std::filesystem::path& path) {
    const std::string extension = lower_case_extension(path);
    if (extension == ".exr") {
        return read_exr(path);
    }
    if (extension == ".png") {
        return read_png(path);
    }
    if (extension == ".jpg" || extension == ".jpeg") {
        return read_jpeg(path);
    }
    throw UnreadableFile(fmt::format("{}: unknown file type; .exr, .png, .jpg and .jpeg can be read", printable(path)));
}

} // namespace foldless
