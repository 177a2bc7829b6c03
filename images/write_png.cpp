#include <foldless/images/write_png.h>

#include <foldless/images/png_handles.h>
#include <foldless/io/printable.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace foldless {

namespace {

using Sink = std::function<void(std::string_view)>;

constexpr int colour_types[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                                PNG_COLOR_TYPE_RGB_ALPHA};

constexpr std::size_t longest_key = 79;
constexpr png_fixed_point gamma_of_one = 100000; // libpng counts in units of 1e-5

extern "C" void png_write_to_sink(png_structp png, png_bytep bytes, std::size_t size) {
    const auto* sink = static_cast<const Sink*>(png_get_io_ptr(png));
    jump_of(png).call([&] { (*sink)({reinterpret_cast<const char*>(bytes), size}); });
}

extern "C" void png_flush_nothing(png_structp) {}

bool is_printable_ascii(char c) {
    return c >= ' ' && c <= '~';
}

void require_key(std::string_view key) {
    const bool ok = !key.empty() && key.size() <= longest_key && std::ranges::all_of(key, is_printable_ascii) &&
                    key.front() != ' ' && key.back() != ' ' && key.find("  ") == std::string_view::npos;
    if (!ok) {
        throw std::invalid_argument(in_quotes(key) + " is no key for an entry of a PNG file");
    }
}

std::string text_of(const std::variant<double, std::string>& value) {
    const double* real = std::get_if<double>(&value);
    return real != nullptr ? fmt::format("{}", *real) : std::get<std::string>(value);
}

/// The entries as libpng takes them.
class Texts {
public:
    explicit Texts(const Metadata& metadata) {
        for (const auto& [key, value] : metadata) {
            require_key(key);
            entries_.emplace_back(key, text_of(value));
            if (entries_.back().second.find('\0') != std::string::npos) {
                throw std::invalid_argument("the text of " + in_quotes(key) + " holds a null");
            }
        }
        for (auto& [key, text] : entries_) {
            views_.push_back(view(key, text));
        }
    }

    void set(png_structp png, png_infop info) const {
        png_set_text(png, info, views_.data(), static_cast<int>(views_.size()));
    }

private:
    static png_text view(std::string& key, std::string& text) {
        png_text view{};
        const bool ascii = std::ranges::all_of(text, [](unsigned char c) { return c < 0x80; });
        view.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
        view.key = key.data();
        view.text = text.data();
        return view;
    }

    std::vector<std::pair<std::string, std::string>> entries_;
    std::vector<png_text> views_;
};

void require_writable(const Image& image, const PngFormat& format) {
    require_sound(image);
    if (image.channels.size() > std::size(colour_types)) {
        throw std::invalid_argument("a PNG file has four channels at most");
    }
    if (format.bits != 8 && format.bits != 16) {
        throw std::invalid_argument("a value of a PNG file is written with 8 or 16 bits");
    }
}

/// The nearest multiple of 1 / most; NaN is 0.
std::uint32_t rounded(float value, std::uint32_t most) {
    const double clamped = value > 0 ? std::min(double{value}, 1.0) : 0;
    return static_cast<std::uint32_t>(clamped * most + 0.5);
}

void encode(const float* values, std::size_t count, int bits, std::vector<png_byte>& row) {
    row.clear();
    for (std::size_t i = 0; i < count; ++i) {
        if (bits == 8) {
            row.push_back(static_cast<png_byte>(rounded(values[i], 0xff)));
        } else {
            const std::uint32_t value = rounded(values[i], 0xffff);
            row.push_back(static_cast<png_byte>(value >> 8)); // the high byte first
            row.push_back(static_cast<png_byte>(value & 0xff));
        }
    }
}

void set_colour(png_structp png, png_infop info, PngColour colour) {
    if (colour == PngColour::srgb) {
        png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    } else if (colour == PngColour::linear) {
        png_set_gAMA_fixed(png, info, gamma_of_one);
    }
}

/// Of an image and texts that are known to be writable.
void write(Sink& sink, const Image& image, const PngFormat& format, const Texts& texts) {
    JumpBack jump;
    const PngWriteHandles handles(jump);
    png_structp png = handles.png();
    png_infop info = handles.info();
    jump.run([&] {
        png_set_write_fn(png, &sink, png_write_to_sink, png_flush_nothing);
        png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height),
                     format.bits, colour_types[image.channels.size() - 1], PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        set_colour(png, info, format.colour);
        texts.set(png, info);
        png_write_info(png, info);
    });
    const std::size_t row_size = image.width * image.channels.size();
    std::vector<png_byte> row;
    for (int y = 0; y < image.height; ++y) {
        encode(image.values.data() + y * row_size, row_size, format.bits, row);
        jump.run([&] { png_write_row(png, row.data()); });
    }
    jump.run([&] { png_write_end(png, nullptr); });
}

} // namespace

AtomicFile stage_png(const std::filesystem::path& path, const Image& image, const PngFormat& format,
                     const Metadata& metadata) {
    require_writable(image, format);
    const Texts texts(metadata);
    AtomicFile file(path);
    Sink sink = [&file](std::string_view bytes) { file.write(bytes); };
    write(sink, image, format, texts);
    return file;
}

std::string png_bytes(const Image& image, const PngFormat& format, const Metadata& metadata) {
    require_writable(image, format);
    const Texts texts(metadata);
    std::string file;
    Sink sink = [&file](std::string_view bytes) { file += bytes; };
    write(sink, image, format, texts);
    return file;
}

} // namespace foldless
