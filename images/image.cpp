#include <foldless/images/image.h>

#include <foldless/images/image_size.h>
#include <foldless/io/numbers.h>

#include <cstdint>
#include <set>
#include <stdexcept>
#include <utility>

namespace foldless {

std::optional<double> number(const Metadata& metadata, const std::string& key) {
    const auto entry = metadata.find(key);
    if (entry == metadata.end()) {
        return std::nullopt;
    }
    if (const double* value = std::get_if<double>(&entry->second)) {
        return *value;
    }
    const Parsed<double> parsed = parse_double(std::get<std::string>(entry->second));
    return parsed.ok() ? std::optional(parsed.value) : std::nullopt;
}

void require_sound(const Image& image) {
    if (image.width < 0 || image.height < 0) {
        throw std::invalid_argument("an image has a negative width or height");
    }
    const ImageSize size{static_cast<std::uint64_t>(image.width), static_cast<std::uint64_t>(image.height),
                         image.channels.size()};
    if (const std::string reason = refused_size_text(size); !reason.empty()) {
        throw std::invalid_argument(reason);
    }
    if (std::set<std::string>(image.channels.begin(), image.channels.end()).size() != image.channels.size()) {
        throw std::invalid_argument("two channels of an image have the same name");
    }
    if (image.values.size() != size.values()) {
        throw std::invalid_argument("an image has more or fewer values than its size says");
    }
}

} // namespace foldless
