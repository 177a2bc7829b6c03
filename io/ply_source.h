/// \file
/// The values of a PLY file one after another, from text or from bytes. Both classes offer the same functions.
#pragma once

#include <foldless/io/ply_header.h>
#include <foldless/io/text_cursor.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace foldless {

/// The data of an ascii file; each instance of an element is one line.
class PlyText {
public:
    PlyText(std::string_view bytes, const std::string& name, const PlyHeader& header);

    /// The least space that an instance can take, in the unit of space_left().
    [[nodiscard]] static std::size_t least_space(const PlyElement& element);
    [[nodiscard]] std::size_t space_left() const { return cursor_.bytes_left() + 1; }
    /// An element without properties has no lines.
    void begin(const PlyElement& element, std::uint64_t instance);
    void end();
    [[nodiscard]] double value(const PlyProperty& property);
    [[nodiscard]] std::size_t list_length(const PlyProperty& property);
    [[nodiscard]] std::int64_t index(const PlyProperty& property);
    /// Reads over instances of which nothing is kept.
    void skip(const PlyElement& element);
    void require_end();
    [[noreturn]] void fail(std::string_view reason) const { cursor_.fail(reason); }

private:
    TextCursor cursor_;
};

/// The data of a binary file.
class PlyBytes {
public:
    PlyBytes(std::string_view bytes, const std::string& name, const PlyHeader& header);

    [[nodiscard]] static std::size_t least_space(const PlyElement& element);
    [[nodiscard]] std::size_t space_left() const { return bytes_.size() - position_; }
    void begin(const PlyElement& element, std::uint64_t instance);
    void end();
    [[nodiscard]] double value(const PlyProperty& property);
    [[nodiscard]] std::size_t list_length(const PlyProperty& property);
    [[nodiscard]] std::int64_t index(const PlyProperty& property);
    void skip(const PlyElement& element);
    void require_end();
    [[noreturn]] void fail(std::string_view reason) const;

private:
    const char* take(std::size_t count);

    std::string_view bytes_;
    std::string name_;
    std::endian order_;
    std::size_t position_;
    std::size_t reading_; ///< where the value or instance begins that is being read, for messages
};

} // namespace foldless
