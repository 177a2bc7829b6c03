/// \file
/// The values of an image while its rows arrive.
#pragma once

#include <foldless/images/image.h>

#include <algorithm>
#include <cstddef>

namespace foldless {

/// Makes room for an image whose width, height and channels are set and sound. The system gives memory for a row when
/// the row is there, so that what a broken file claims and does not have takes none. Rows do not move.
class Rows {
public:
    explicit Rows(Image& image) : image_(image), row_size_(image.width * image.channels.size()) {
        image_.values.reserve(row_size_ * image.height);
    }

    /// Values up to the end of the row `y` exist from now on.
    float* reach(int y) {
        image_.values.resize(std::max(image_.values.size(), (std::size_t(y) + 1) * row_size_));
        return image_.values.data() + y * row_size_;
    }

private:
    Image& image_;
    std::size_t row_size_;
};

} // namespace foldless
