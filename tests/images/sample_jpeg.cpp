#include "sample_jpeg.h"

#include <cmath>
#include <cstdio> // which jpeglib.h needs and does not include
#include <cstdlib>

#include <jpeglib.h>

namespace foldless {

namespace {

J_COLOR_SPACE colour_space(const Image& image, const SampleJpeg& kind) {
    return kind.inks ? JCS_CMYK : image.channels.size() == 1 ? JCS_GRAYSCALE : JCS_RGB;
}

} // namespace

std::string jpeg_bytes(const Image& image, const SampleJpeg& kind) {
    jpeg_error_mgr errors{};
    jpeg_compress_struct encoder{};
    encoder.err = jpeg_std_error(&errors);
    jpeg_create_compress(&encoder);
    unsigned char* memory = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&encoder, &memory, &size);
    encoder.image_width = static_cast<JDIMENSION>(image.width);
    encoder.image_height = static_cast<JDIMENSION>(image.height);
    encoder.input_components = static_cast<int>(image.channels.size());
    encoder.in_color_space = colour_space(image, kind);
    jpeg_set_defaults(&encoder);
    jpeg_set_quality(&encoder, 100, TRUE);
    encoder.comp_info[0].h_samp_factor = encoder.comp_info[0].v_samp_factor = 1;
    if (kind.progressive) {
        jpeg_simple_progression(&encoder);
    }
    jpeg_start_compress(&encoder, TRUE);
    const std::size_t row_size = image.width * image.channels.size();
    for (int y = 0; y < image.height; ++y) {
        std::vector<JSAMPLE> row;
        for (std::size_t i = 0; i < row_size; ++i) {
            row.push_back(static_cast<JSAMPLE>(std::lround(image.values[y * row_size + i] * MAXJSAMPLE)));
        }
        JSAMPROW start = row.data();
        jpeg_write_scanlines(&encoder, &start, 1);
    }
    jpeg_finish_compress(&encoder);
    jpeg_destroy_compress(&encoder);
    std::string bytes(reinterpret_cast<const char*>(memory), size);
    std::free(memory);
    return bytes;
}

} // namespace foldless
