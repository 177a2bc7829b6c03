#include <foldless/images/png_handles.h>

#include <cstdlib>

namespace foldless {

namespace {

extern "C" {

void png_fail(png_structp png, png_const_charp message) {
    jump_of(png).fail(message);
}

// Of what can be passed over; the library is silent.
void png_ignore_warning(png_structp, png_const_charp) {}

png_voidp png_allocate(png_structp png, png_alloc_size_t size) {
    void* memory = std::malloc(size);
    if (memory == nullptr) {
        static_cast<JumpBack*>(png_get_mem_ptr(png))->out_of_memory();
    }
    return memory;
}

void png_release(png_structp, png_voidp memory) {
    std::free(memory);
}
}

} // namespace

PngWriteHandles::PngWriteHandles(JumpBack& jump) {
    png_ = png_create_write_struct_2(PNG_LIBPNG_VER_STRING, &jump, png_fail, png_ignore_warning, &jump, png_allocate,
                                     png_release);
    info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
    if (info_ == nullptr) {
        png_destroy_write_struct(&png_, nullptr);
        throw std::bad_alloc();
    }
}

PngWriteHandles::~PngWriteHandles() {
    png_destroy_write_struct(&png_, &info_);
}

PngReadHandles::PngReadHandles(JumpBack& jump) {
    png_ = png_create_read_struct_2(PNG_LIBPNG_VER_STRING, &jump, png_fail, png_ignore_warning, &jump, png_allocate,
                                    png_release);
    info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
    if (info_ == nullptr) {
        png_destroy_read_struct(&png_, nullptr, nullptr);
        throw std::bad_alloc();
    }
}

PngReadHandles::~PngReadHandles() {
    png_destroy_read_struct(&png_, &info_, nullptr);
}

JumpBack& jump_of(png_structp png) {
    return *static_cast<JumpBack*>(png_get_error_ptr(png));
}

} // namespace foldless
