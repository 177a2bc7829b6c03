#include <foldless/io/ply_header.h>

#include <foldless/io/printable.h>
#include <foldless/io/text_cursor.h>

#include <fmt/format.h>

#include <array>
#include <utility>

namespace foldless {

namespace {

struct TypeName {
    std::string_view name;
    PlyType type;
};

// Both families of names are in use: those of the first description of the format, and those with sizes.
constexpr std::array<TypeName, 16> type_names{{
    {"char", PlyType::int8},
    {"int8", PlyType::int8},
    {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},
    {"short", PlyType::int16},
    {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},
    {"uint16", PlyType::uint16},
    {"int", PlyType::int32},
    {"int32", PlyType::int32},
    {"uint", PlyType::uint32},
    {"uint32", PlyType::uint32},
    {"float", PlyType::float32},
    {"float32", PlyType::float32},
    {"double", PlyType::float64},
    {"float64", PlyType::float64},
}};

struct FormatName {
    std::string_view name;
    PlyFormat format;
};

constexpr std::array<FormatName, 3> format_names{{
    {"ascii", PlyFormat::ascii},
    {"binary_little_endian", PlyFormat::binary_little_endian},
    {"binary_big_endian", PlyFormat::binary_big_endian},
}};

PlyType parse_type(TextCursor& cursor) {
    const std::string_view token = cursor.token();
    for (const TypeName& known : type_names) {
        if (known.name == token) {
            return known.type;
        }
    }
    cursor.fail(fmt::format("unknown type {}", in_quotes(token)));
}

PlyFormat parse_format(TextCursor& cursor) {
    const std::string_view token = cursor.token();
    if (cursor.token() != "1.0") {
        cursor.fail("the format version is not 1.0");
    }
    for (const FormatName& known : format_names) {
        if (known.name == token) {
            return known.format;
        }
    }
    cursor.fail(fmt::format("unknown format {}", in_quotes(token)));
}

std::string parse_name(TextCursor& cursor) {
    const std::string_view token = cursor.token();
    if (token.empty()) {
        cursor.fail("a name is missing");
    }
    return std::string(token);
}

PlyElement parse_element(TextCursor& cursor) {
    std::string name = parse_name(cursor);
    const std::int64_t count = cursor.integer("the count");
    if (count < 0) {
        cursor.fail(fmt::format("element {} has a negative count", in_quotes(name)));
    }
    return {std::move(name), static_cast<std::uint64_t>(count), {}};
}

PlyProperty parse_property(TextCursor& cursor) {
    if (cursor.peek() != "list") {
        const PlyType type = parse_type(cursor);
        return {parse_name(cursor), type, std::nullopt};
    }
    static_cast<void>(cursor.token());
    const PlyType count_type = parse_type(cursor);
    if (!is_integer(count_type)) {
        cursor.fail("the length of a list is not an integer");
    }
    const PlyType type = parse_type(cursor);
    return {parse_name(cursor), type, count_type};
}

/// Comments may hold any bytes, so that this one is not read token by token.
std::optional<std::string> texture_of_comment(std::string_view comment) {
    constexpr std::string_view keyword = "TextureFile";
    const std::size_t name = comment.find_first_not_of(" \t", keyword.size());
    if (!comment.starts_with(keyword) || name == keyword.size() || name == std::string_view::npos) {
        return std::nullopt;
    }
    return std::string(comment.substr(name));
}

/// One line of the header into `header`; false at its end.
bool parse_line(TextCursor& cursor, PlyHeader& header, std::optional<PlyFormat>& format) {
    const std::string_view keyword = cursor.token();
    if (keyword == "comment" || keyword == "obj_info") {
        if (std::optional<std::string> texture = texture_of_comment(cursor.rest_of_line())) {
            header.textures.push_back(std::move(*texture));
        }
        return true;
    }
    if (keyword == "format") {
        if (format) {
            cursor.fail("the format is named twice");
        }
        format = parse_format(cursor);
    } else if (keyword == "element") {
        header.elements.push_back(parse_element(cursor));
    } else if (keyword == "property") {
        if (header.elements.empty()) {
            cursor.fail("a property comes before the first element");
        }
        header.elements.back().properties.push_back(parse_property(cursor));
    } else if (keyword != "end_header") {
        cursor.fail(fmt::format("unknown header line {}", in_quotes(keyword)));
    }
    cursor.require_end_of_line();
    return keyword != "end_header";
}

/// True if lines end at CR alone. Then a LF behind `end_header` CR is data. A header has several lines.
bool ends_lines_at_carriage_return(std::string_view bytes) {
    const std::size_t end = bytes.find_first_of("\r\n");
    return bytes[end] == '\r' && bytes.substr(end, 2) != "\r\n";
}

} // namespace

std::size_t size(PlyType type) {
    switch (type) {
    case PlyType::int8:
    case PlyType::uint8: return 1;
    case PlyType::int16:
    case PlyType::uint16: return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32: return 4;
    default: return 8;
    }
}

bool is_integer(PlyType type) {
    return type != PlyType::float32 && type != PlyType::float64;
}

PlyHeader parse_ply_header(std::string_view bytes, const std::string& name) {
    TextCursor cursor(bytes, name, {});
    if (!cursor.next_line() || cursor.token() != "ply") {
        cursor.fail("a PLY file starts with a line 'ply'");
    }
    cursor.require_end_of_line();
    PlyHeader header{};
    std::optional<PlyFormat> format;
    do {
        if (!cursor.next_line()) {
            cursor.fail("the header has no end");
        }
    } while (parse_line(cursor, header, format));
    if (!format) {
        cursor.fail("the header names no format");
    }
    header.format = *format;
    header.lines = cursor.line();
    const std::size_t end = bytes.size() - cursor.bytes_left();
    cursor.skip_line();
    header.bytes = bytes.size() - cursor.bytes_left();
    if (ends_lines_at_carriage_return(bytes)) {
        header.bytes = end + 1;
    }
    return header;
}

} // namespace foldless
