/// \file
/// What libpng needs to read or write, taken and given back.
#pragma once

#include <foldless/images/jump_back.h>

#include <png.h>

namespace foldless {

/// A libpng writer whose errors go to `jump`, which must live longer.
class PngWriteHandles {
public:
    explicit PngWriteHandles(JumpBack& jump);
    ~PngWriteHandles();
    PngWriteHandles(const PngWriteHandles&) = delete;
    PngWriteHandles& operator=(const PngWriteHandles&) = delete;

    [[nodiscard]] png_structp png() const { return png_; }
    [[nodiscard]] png_infop info() const { return info_; }

private:
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

/// A libpng reader whose errors go to `jump`, which must live longer.
class PngReadHandles {
public:
    explicit PngReadHandles(JumpBack& jump);
    ~PngReadHandles();
    PngReadHandles(const PngReadHandles&) = delete;
    PngReadHandles& operator=(const PngReadHandles&) = delete;

    [[nodiscard]] png_structp png() const { return png_; }
    [[nodiscard]] png_infop info() const { return info_; }

private:
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

/// The place where errors of this reader or writer go.
[[nodiscard]] JumpBack& jump_of(png_structp png);

} // namespace foldless
