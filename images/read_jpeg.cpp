#include <foldless/images/read_jpeg.h>

#include <foldless/images/image_size.h>
#include <foldless/images/jump_back.h>
#include <foldless/images/rows.h>
#include <foldless/images/unreadable_image.h>
#include <foldless/io/file_bytes.h>

#include <algorithm>
#include <array>
#include <cstdio> // which jpeglib.h needs and does not include

#include <jerror.h>
#include <jpeglib.h>

namespace foldless {

namespace {

// A block of 64 pixels has a bit for its mean at least, however often it is gone over.
constexpr double most_expansion = 512;

// Of a progressive file, each of which goes over the whole image. Programs write about ten; a small file with thousands
// of empty ones would take hours.
constexpr int most_scans = 200;

// What the decoder notes and no pixel suffers from.
constexpr int harmless_warnings[] = {JWRN_ADOBE_XFORM, JWRN_BOGUS_ICC, JWRN_EXTRANEOUS_DATA, JWRN_JFIF_MAJOR};

JumpBack& jump_of(j_common_ptr jpeg) {
    return *static_cast<JumpBack*>(jpeg->client_data);
}

extern "C" {

void jpeg_fail(j_common_ptr jpeg) {
    std::array<char, JMSG_LENGTH_MAX> message{};
    jpeg->err->format_message(jpeg, message.data());
    if (jpeg->err->msg_code == JERR_OUT_OF_MEMORY) {
        jump_of(jpeg).out_of_memory();
    }
    jump_of(jpeg).fail(message.data());
}

/// Damage makes the library guess pixels; a guess is none of a scan.
void jpeg_fail_if_damaged(j_common_ptr jpeg, int level) {
    const bool is_warning = level < 0;
    if (is_warning && std::ranges::find(harmless_warnings, jpeg->err->msg_code) == std::end(harmless_warnings)) {
        jpeg_fail(jpeg);
    }
}

void jpeg_count_scans(j_common_ptr jpeg) {
    if (reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number > most_scans) {
        jump_of(jpeg).fail("it has too many scans");
    }
}
}

class JpegReader {
public:
    JpegReader() {
        decoder_.err = jpeg_std_error(&errors_);
        decoder_.client_data = &jump_;
        errors_.error_exit = jpeg_fail;
        errors_.emit_message = jpeg_fail_if_damaged;
        progress_.progress_monitor = jpeg_count_scans;
        jump_.run([this] { jpeg_create_decompress(&decoder_); });
        decoder_.progress = &progress_;
    }
    ~JpegReader() { jpeg_destroy_decompress(&decoder_); }
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;

    ReadImage read(std::string_view bytes) {
        ReadImage result;
        Image& image = result.image;
        read_header(bytes, image);
        jump_.run([this] { jpeg_start_decompress(&decoder_); });
        Rows rows(image);
        const std::size_t row_size = image.width * image.channels.size();
        std::vector<JSAMPLE> row(row_size);
        for (int y = 0; y < image.height; ++y) {
            read_row(row);
            std::ranges::transform(row, rows.reach(y), [](JSAMPLE value) { return float(value) / MAXJSAMPLE; });
        }
        jump_.run([this] { jpeg_finish_decompress(&decoder_); });
        return result;
    }

private:
    void read_header(std::string_view bytes, Image& image) {
        jump_.run([&] {
            jpeg_mem_src(&decoder_, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
            jpeg_read_header(&decoder_, TRUE);
        });
        if (decoder_.num_components > 3) {
            throw LibraryFailure("it has inks instead of colours");
        }
        const bool grey = decoder_.jpeg_color_space == JCS_GRAYSCALE;
        image.channels = grey ? std::vector<std::string>{"Y"} : std::vector<std::string>{"R", "G", "B"};
        require_credible(bytes.size(), image.channels.size());
        image.width = static_cast<int>(decoder_.image_width);
        image.height = static_cast<int>(decoder_.image_height);
        decoder_.out_color_space = grey ? JCS_GRAYSCALE : JCS_RGB;
    }

    void require_credible(std::size_t file_size, std::size_t channels) const {
        const ImageSize size{decoder_.image_width, decoder_.image_height, channels};
        if (const std::string reason = refused_size_text(size); !reason.empty()) {
            throw LibraryFailure(reason);
        }
        const double pixels = double(size.width) * double(size.height);
        if (const std::string reason = refused_expansion_text(pixels, file_size, most_expansion); !reason.empty()) {
            throw LibraryFailure(reason);
        }
    }

    void read_row(std::vector<JSAMPLE>& row) {
        JSAMPROW start = row.data();
        jump_.run([&] {
            if (jpeg_read_scanlines(&decoder_, &start, 1) != 1) {
                jump_.fail("the file ends too early");
            }
        });
    }

    JumpBack jump_;
    jpeg_error_mgr errors_{};
    jpeg_progress_mgr progress_{};
    jpeg_decompress_struct decoder_{};
};

} // namespace

ReadImage read_jpeg(const std::filesystem::path& path) {
    const FileBytes file(path);
    return read_jpeg(file.bytes(), path.string());
}

ReadImage read_jpeg(std::string_view bytes, const std::string& name) {
    try {
        return JpegReader().read(bytes);
    } catch (const LibraryFailure& failure) {
        throw unreadable_image(name, "JPEG", failure.what());
    }
}

} // namespace foldless
