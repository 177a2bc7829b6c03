/// \file
/// Images for tests, and what is said of files that are none.
#pragma once

#include <foldless/images/image.h>
#include <foldless/images/read_image.h>

#include "temporary_folder.h"

#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace foldless {

/// An image with values that differ from pixel to pixel and cover [0, 1].
inline Image slope(int width, int height, std::vector<std::string> channels) {
    Image image{width, height, std::move(channels), {}};
    const std::size_t count = width * height * image.channels.size();
    for (std::size_t i = 0; i < count; ++i) {
        image.values.push_back(static_cast<float>(i) / static_cast<float>(count - 1));
    }
    return image;
}

/// Tells NaNs and zeros of two signs apart, too.
inline std::vector<std::uint32_t> bits_of(const std::vector<float>& values) {
    std::vector<std::uint32_t> bits;
    for (const float value : values) {
        bits.push_back(std::bit_cast<std::uint32_t>(value));
    }
    return bits;
}

/// Reads these bytes as an image file of this name.
inline ReadImage image_of(const std::string& name, std::string_view bytes) {
    const TemporaryFolder folder;
    return read_image(folder.file(name, bytes));
}

/// The message with which reading is refused, without the folder in front.
inline std::string unreadable_image_text(const std::string& name, std::string_view bytes) {
    const TemporaryFolder folder;
    const auto path = folder.file(name, bytes);
    const std::string message = message_of<UnreadableFile>([&] { static_cast<void>(read_image(path)); });
    const std::string prefix = folder.path().string() + "/";
    return message.starts_with(prefix) ? message.substr(prefix.size()) : message;
}

} // namespace foldless
