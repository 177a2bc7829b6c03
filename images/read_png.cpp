#include <foldless/images/read_png.h>

#include <foldless/images/image_size.h>
#include <foldless/images/png_handles.h>
#include <foldless/images/rows.h>
#include <foldless/images/unreadable_image.h>
#include <foldless/io/byte_order.h>
#include <foldless/io/file_bytes.h>

#include <cstdint>
#include <cstring>

namespace foldless {

namespace {

// deflate copies 258 bytes by two bits at best.
constexpr double most_expansion = 1032;

constexpr std::size_t signature_size = 8;

/// The library takes the memory that a chunk claims before it looks for the bytes.
void require_chunks_within(std::string_view bytes) {
    constexpr std::size_t frame_size = 12; // length, kind and check sum
    std::string_view kind;
    for (std::string_view rest = bytes.substr(signature_size); kind != "IEND";) {
        if (rest.size() < frame_size) {
            throw LibraryFailure("the file ends too early");
        }
        const auto length = load<std::uint32_t>(rest.data(), std::endian::big);
        if (length > rest.size() - frame_size) {
            throw LibraryFailure("the file ends too early");
        }
        kind = rest.substr(sizeof(std::uint32_t), sizeof(std::uint32_t));
        rest.remove_prefix(frame_size + length);
    }
}

extern "C" void png_read_from_view(png_structp png, png_bytep bytes, std::size_t size) {
    auto* rest = static_cast<std::string_view*>(png_get_io_ptr(png));
    if (size > rest->size()) {
        jump_of(png).fail("the file ends too early");
    }
    std::memcpy(bytes, rest->data(), size);
    rest->remove_prefix(size);
}

std::vector<std::string> channel_names(std::size_t count) {
    switch (count) {
    case 1: return {"Y"};
    case 2: return {"Y", "A"};
    case 3: return {"R", "G", "B"};
    default: return {"R", "G", "B", "A"};
    }
}

/// Rows and columns of the image that stand together in the file.
struct Pass {
    int first_row = 0;
    int row_step = 1;
    int rows = 0;
    int first_column = 0;
    int column_step = 1;
    int columns = 0;
};

std::vector<Pass> passes_of(const Image& image, bool interlaced) {
    if (!interlaced) {
        return {{0, 1, image.height, 0, 1, image.width}};
    }
    std::vector<Pass> passes;
    for (int i = 0; i < PNG_INTERLACE_ADAM7_PASSES; ++i) {
        const Pass pass{PNG_PASS_START_ROW(i), 1 << PNG_PASS_ROW_SHIFT(i), PNG_PASS_ROWS(image.height, i),
                        PNG_PASS_START_COL(i), 1 << PNG_PASS_COL_SHIFT(i), PNG_PASS_COLS(image.width, i)};
        if (pass.rows > 0 && pass.columns > 0) { // the file leaves out the others
            passes.push_back(pass);
        }
    }
    return passes;
}

float scaled(const png_byte* bytes, std::size_t index, int bits) {
    if (bits == 8) {
        return static_cast<float>(bytes[index]) / 0xff;
    }
    return static_cast<float>(bytes[2 * index] << 8 | bytes[2 * index + 1]) / 0xffff;
}

/// Latin-1 as UTF-8.
std::string from_latin_1(std::string_view text) {
    std::string result;
    for (const unsigned char c : text) {
        if (c < 0x80) {
            result += static_cast<char>(c);
        } else {
            result += static_cast<char>(0xc0 | c >> 6);
            result += static_cast<char>(0x80 | (c & 0x3f));
        }
    }
    return result;
}

class PngReader {
public:
    explicit PngReader(std::string_view bytes) : file_size_(bytes.size()), rest_(bytes), handles_(jump_) {
        if (bytes.size() < signature_size ||
            png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, signature_size) != 0) {
            throw LibraryFailure("it does not start like one");
        }
        require_chunks_within(bytes);
    }

    ReadImage read() {
        ReadImage result;
        read_header(result.image);
        Rows rows(result.image);
        for (const Pass& pass : passes_of(result.image, interlaced_)) {
            read_pass(pass, result.image, rows);
        }
        rows.reach(result.image.height - 1);
        jump_.run([&] { png_read_end(png_, info_); });
        result.metadata = texts();
        return result;
    }

private:
    void read_header(Image& image) {
        jump_.run([&] {
            png_set_read_fn(png_, &rest_, png_read_from_view);
            // Whatever the library can; what is too large is refused by name below.
            png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
            png_read_info(png_, info_);
        });
        const png_uint_32 width = png_get_image_width(png_, info_);
        const png_uint_32 height = png_get_image_height(png_, info_);
        const std::size_t channels = expanded_channels();
        if (const std::string reason = refused_size_text({width, height, channels}); !reason.empty()) {
            throw LibraryFailure(reason);
        }
        const double raw_size = double(png_get_rowbytes(png_, info_)) * height;
        if (const std::string reason = refused_expansion_text(raw_size, file_size_, most_expansion); !reason.empty()) {
            throw LibraryFailure(reason);
        }
        image.width = static_cast<int>(width);
        image.height = static_cast<int>(height);
        image.channels = channel_names(channels);
        expand();
    }

    /// Once palettes are colours and transparent colours are alpha.
    std::size_t expanded_channels() {
        const int type = png_get_color_type(png_, info_);
        const bool alpha = (type & PNG_COLOR_MASK_ALPHA) != 0 || png_get_valid(png_, info_, PNG_INFO_tRNS) != 0;
        return ((type & PNG_COLOR_MASK_COLOR) != 0 ? 3 : 1) + (alpha ? 1 : 0);
    }

    /// Rows of passes are left apart: the library would need each row in bytes until the last pass.
    void expand() {
        jump_.run([&] {
            png_set_expand(png_);
            png_read_update_info(png_, info_);
        });
        interlaced_ = png_get_interlace_type(png_, info_) == PNG_INTERLACE_ADAM7;
        bits_ = png_get_bit_depth(png_, info_);
        row_.resize(png_get_rowbytes(png_, info_));
    }

    void read_pass(const Pass& pass, const Image& image, Rows& rows) {
        const std::size_t channels = image.channels.size();
        for (int i = 0; i < pass.rows; ++i) {
            jump_.run([&] { png_read_row(png_, row_.data(), nullptr); });
            float* row = rows.reach(pass.first_row + i * pass.row_step);
            for (int j = 0; j < pass.columns; ++j) {
                float* pixel = row + (pass.first_column + j * pass.column_step) * channels;
                for (std::size_t c = 0; c < channels; ++c) {
                    pixel[c] = scaled(row_.data(), j * channels + c, bits_);
                }
            }
        }
    }

    Metadata texts() {
        Metadata metadata;
        png_textp entries = nullptr;
        const int count = png_get_text(png_, info_, &entries, nullptr);
        for (int i = 0; i < count; ++i) {
            const png_text& entry = entries[i];
            const bool utf_8 = entry.compression >= PNG_ITXT_COMPRESSION_NONE;
            const std::string_view text(entry.text, utf_8 ? entry.itxt_length : entry.text_length);
            metadata.emplace(from_latin_1(entry.key), utf_8 ? std::string(text) : from_latin_1(text));
        }
        return metadata;
    }

    std::size_t file_size_;
    std::string_view rest_;
    JumpBack jump_;
    PngReadHandles handles_;
    png_structp png_ = handles_.png();
    png_infop info_ = handles_.info();
    bool interlaced_ = false;
    int bits_ = 0; ///< of a value, after expansion
    std::vector<png_byte> row_;
};

} // namespace

ReadImage read_png(const std::filesystem::path& path) {
    const FileBytes file(path);
    return read_png(file.bytes(), path.string());
}

ReadImage read_png(std::string_view bytes, const std::string& name) {
    try {
        return PngReader(bytes).read();
    } catch (const LibraryFailure& failure) {
        throw unreadable_image(name, "PNG", failure.what());
    }
}

} // namespace foldless
