/// \file
/// The headers of OpenEXR files, checked before the library trusts them.
#pragma once

#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>

#include <cstdint>
#include <stdexcept>
#include <string_view>

namespace foldless {

/// Bytes in memory as OpenEXR reads them.
class ExrStream final : public Imf::IStream {
public:
    explicit ExrStream(std::string_view bytes) : IStream(""), bytes_(bytes) {}

    /// \throws std::out_of_range if there are fewer bytes.
    bool read(char bytes[], int count) override;
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override { position_ = position; }

private:
    std::string_view bytes_;
    std::uint64_t position_ = 0;
};

/// Why the file is not read, where its header alone tells.
class RefusedExr : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The header of a file of one part whose claims its size allows: attributes end within it, every chunk of pixels is
/// there, and its compression can make as much of the file.
///
/// \throws RefusedExr, or what OpenEXR throws.
[[nodiscard]] Imf::Header read_exr_header(std::string_view bytes);

} // namespace foldless
