#include <foldless/io/ply_source.h>

#include <foldless/io/byte_order.h>
#include <foldless/io/errors.h>
#include <foldless/io/printable.h>

#include <fmt/format.h>

#include <algorithm>

namespace foldless {

namespace {

std::string ends_early_text(const PlyElement& element, std::uint64_t instance) {
    return fmt::format("the file ends after {} of {} instances of element {}", instance, element.count,
                       in_quotes(element.name));
}

bool has_lists(const PlyElement& element) {
    return std::ranges::any_of(element.properties, [](const PlyProperty& p) { return p.count_type.has_value(); });
}

double load_value(const char* bytes, PlyType type, std::endian order) {
    switch (type) {
    case PlyType::int8: return load<std::int8_t>(bytes, order);
    case PlyType::uint8: return load<std::uint8_t>(bytes, order);
    case PlyType::int16: return load<std::int16_t>(bytes, order);
    case PlyType::uint16: return load<std::uint16_t>(bytes, order);
    case PlyType::int32: return load<std::int32_t>(bytes, order);
    case PlyType::uint32: return load<std::uint32_t>(bytes, order);
    case PlyType::float32: return static_cast<double>(load<float>(bytes, order));
    default: return load<double>(bytes, order);
    }
}

/// Reads over one instance.
template <class Source>
void skip_instance(Source& source, const PlyElement& element) {
    for (const PlyProperty& property : element.properties) {
        const std::size_t values = property.count_type ? source.list_length(property) : 1;
        for (std::size_t i = 0; i < values; ++i) {
            static_cast<void>(source.value(property));
        }
    }
}

template <class Source>
void skip_instances(Source& source, const PlyElement& element) {
    for (std::uint64_t instance = 0; instance < element.count; ++instance) {
        source.begin(element, instance);
        skip_instance(source, element);
        source.end();
    }
}

} // namespace

PlyText::PlyText(std::string_view bytes, const std::string& name, const PlyHeader& header)
    : cursor_(bytes.substr(header.bytes), name, {.first_line = header.lines + 1}) {}

std::size_t PlyText::least_space(const PlyElement& element) {
    // A digit and a separator each; space_left() counts a separator behind the last one that need not be there.
    return 2 * element.properties.size();
}

void PlyText::begin(const PlyElement& element, std::uint64_t instance) {
    if (!cursor_.next_line()) {
        cursor_.fail(ends_early_text(element, instance));
    }
}

void PlyText::end() {
    cursor_.require_end_of_line();
}

double PlyText::value(const PlyProperty& property) {
    switch (property.type) {
    case PlyType::float32: return static_cast<double>(cursor_.real32(property.name));
    case PlyType::float64: return cursor_.real(property.name);
    default: return static_cast<double>(cursor_.integer(property.name));
    }
}

std::size_t PlyText::list_length(const PlyProperty& property) {
    const std::int64_t length = cursor_.integer("the length of a list");
    if (static_cast<std::uint64_t>(length) > space_left() / 2) { // negative ones too, which become huge
        fail(fmt::format("list {} cannot have {} values", in_quotes(property.name), length));
    }
    return static_cast<std::size_t>(length);
}

std::int64_t PlyText::index(const PlyProperty& property) {
    return cursor_.integer(property.name);
}

void PlyText::skip(const PlyElement& element) {
    skip_instances(*this, element);
}

void PlyText::require_end() {
    if (cursor_.next_line()) {
        cursor_.fail("data behind the last element of the header");
    }
}

PlyBytes::PlyBytes(std::string_view bytes, const std::string& name, const PlyHeader& header)
    : bytes_(bytes), name_(name),
      order_(header.format == PlyFormat::binary_big_endian ? std::endian::big : std::endian::little),
      position_(header.bytes), reading_(header.bytes) {}

std::size_t PlyBytes::least_space(const PlyElement& element) {
    std::size_t space = 0;
    for (const PlyProperty& property : element.properties) {
        space += size(property.count_type.value_or(property.type));
    }
    return space;
}

void PlyBytes::begin(const PlyElement& element, std::uint64_t instance) {
    if (space_left() < least_space(element)) {
        fail(ends_early_text(element, instance));
    }
}

void PlyBytes::end() {
    reading_ = position_;
}

double PlyBytes::value(const PlyProperty& property) {
    return load_value(take(size(property.type)), property.type, order_);
}

std::size_t PlyBytes::list_length(const PlyProperty& property) {
    const double length = load_value(take(size(*property.count_type)), *property.count_type, order_);
    const std::size_t most = space_left() / size(property.type);
    if (length < 0 || length > static_cast<double>(most)) {
        fail(fmt::format("list {} cannot have {} values", in_quotes(property.name), length));
    }
    return static_cast<std::size_t>(length);
}

std::int64_t PlyBytes::index(const PlyProperty& property) {
    return static_cast<std::int64_t>(value(property));
}

void PlyBytes::skip(const PlyElement& element) {
    if (has_lists(element)) {
        skip_instances(*this, element);
    } else {
        take(least_space(element) * static_cast<std::size_t>(element.count));
        end();
    }
}

void PlyBytes::require_end() {
    // Some writers end a binary file with a line end.
    const std::size_t rest = bytes_.find_first_not_of(" \t\r\n", position_);
    if (rest != std::string_view::npos) {
        reading_ = rest;
        fail("data behind the last element of the header");
    }
}

void PlyBytes::fail(std::string_view reason) const {
    throw UnreadableFile(fmt::format("{}: byte {}: {}", name_, reading_, reason));
}

const char* PlyBytes::take(std::size_t count) {
    reading_ = position_;
    if (space_left() < count) {
        fail("the file ends too early");
    }
    const char* taken = bytes_.data() + position_;
    position_ += count;
    return taken;
}

} // namespace foldless
