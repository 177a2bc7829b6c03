#include "raw_png.h"

#include <algorithm>
#include <array>

namespace foldless {

namespace {

std::string big_endian(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes += static_cast<char>(value >> shift & 0xff);
    }
    return bytes;
}

std::uint32_t crc_of(std::string_view bytes) {
    std::uint32_t crc = ~std::uint32_t{0};
    for (const unsigned char byte : bytes) {
        crc ^= byte;
        for (int i = 0; i < 8; ++i) {
            crc = crc >> 1 ^ ((crc & 1) != 0 ? 0xedb88320U : 0U);
        }
    }
    return ~crc;
}

/// Blocks that are stored as they are.
std::string zlib_stream(std::string_view bytes) {
    std::string stream = "\x78\x01";
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (const unsigned char byte : bytes) {
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    constexpr std::size_t largest_block = 65535;
    do {
        const std::string_view block = bytes.substr(0, largest_block);
        bytes.remove_prefix(block.size());
        const auto size = static_cast<unsigned>(block.size());
        stream += bytes.empty() ? '\1' : '\0';
        for (const unsigned half : {size, ~size}) {
            stream += static_cast<char>(half & 0xff);
            stream += static_cast<char>(half >> 8 & 0xff);
        }
        stream += block;
    } while (!bytes.empty());
    return stream + big_endian(b << 16 | a);
}

std::size_t channels_of(int colour_type) {
    constexpr std::array<std::size_t, 7> channels{1, 0, 3, 1, 2, 0, 4};
    return channels[static_cast<std::size_t>(colour_type)];
}

/// Every `step`th pixel of a row from `first` on, without a filter, packed from the high bit down.
std::string packed_row(const RawPng& png, std::uint32_t y, std::uint32_t first, std::uint32_t step) {
    const std::size_t channels = channels_of(png.colour_type);
    std::string row(1, '\0');
    unsigned gathered = 0;
    int bits = 0;
    for (std::uint32_t x = first; x < png.width; x += step) {
        for (std::size_t c = 0; c < channels; ++c) {
            gathered = gathered << png.bits | png.samples[(std::size_t{y} * png.width + x) * channels + c];
            for (bits += png.bits; bits >= 8; bits -= 8) {
                row += static_cast<char>(gathered >> (bits - 8) & 0xff);
            }
        }
    }
    return bits > 0 ? row + static_cast<char>(gathered << (8 - bits) & 0xff) : row;
}

std::string rows_of(const RawPng& png, std::array<std::uint32_t, 4> pass) {
    const auto [first_row, row_step, first_column, column_step] = pass;
    std::string rows;
    for (std::uint32_t y = first_row; y < png.height && first_column < png.width; y += row_step) {
        rows += packed_row(png, y, first_column, column_step);
    }
    return rows;
}

std::string pixels_of(const RawPng& png) {
    if (!png.interlaced) {
        return rows_of(png, {0, 1, 0, 1});
    }
    // PNG, third edition, 8.1: Adam7.
    constexpr std::array<std::uint32_t, 4> passes[] = {{0, 8, 0, 8}, {0, 8, 4, 8}, {4, 8, 0, 4}, {0, 4, 2, 4},
                                                       {2, 4, 0, 2}, {0, 2, 1, 2}, {1, 2, 0, 1}};
    std::string pixels;
    for (const auto& pass : passes) {
        pixels += rows_of(png, pass);
    }
    return pixels;
}

} // namespace

std::string png_chunk(std::string_view kind, std::string_view body) {
    const std::string checked = std::string(kind) + std::string(body);
    return big_endian(static_cast<std::uint32_t>(body.size())) + checked + big_endian(crc_of(checked));
}

std::string bytes_of(const RawPng& png) {
    std::string header = big_endian(png.width) + big_endian(png.height);
    header += {static_cast<char>(png.bits), static_cast<char>(png.colour_type), '\0', '\0',
               static_cast<char>(png.interlaced ? 1 : 0)};
    const std::string pixels = png.samples.empty() ? "" : pixels_of(png);
    return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) + png.chunks + png_chunk("IDAT", zlib_stream(pixels)) +
           png_chunk("IEND", "");
}

} // namespace foldless
