#include <foldless/io/numbers.h>

#include <algorithm>
#include <charconv>
#include <cstddef>

namespace foldless {

namespace {

// std::from_chars knows no leading plus. "+-1" stays wrong: the minus must not follow a plus.
std::string_view without_plus(std::string_view token) {
    return token.size() > 1 && token[0] == '+' && token[1] != '-' ? token.substr(1) : token;
}

template <class Number>
Parsed<Number> parse_whole(std::string_view token) {
    const std::string_view digits = without_plus(token);
    Parsed<Number> parsed;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), parsed.value);
    const bool whole = end == digits.data() + digits.size();
    parsed.error = whole ? error : std::errc::invalid_argument;
    return parsed;
}

/// Whether a number is below 1, by the power of ten of its first digit that is not 0. `number` is one in decimal digits
/// that has such a digit.
bool is_below_one(std::string_view number) {
    const std::size_t mark = std::min(number.find_first_of("eE"), number.size());
    const std::string_view digits = number.substr(0, mark);
    const auto point = static_cast<std::int64_t>(std::min(digits.find('.'), digits.size()));
    const auto first = static_cast<std::int64_t>(digits.find_first_of("123456789"));
    const std::int64_t power = first < point ? point - first - 1 : point - first;
    if (mark == number.size()) {
        return power < 0;
    }
    const std::string_view exponent = number.substr(mark + 1);
    const auto parsed = parse_whole<std::int64_t>(exponent);
    // No text is so long that its digits outweigh an exponent that does not fit into 64 bits.
    return parsed.ok() ? parsed.value < -power : exponent.starts_with('-');
}

template <class Real>
Parsed<Real> parse_real(std::string_view token) {
    const auto parsed = parse_whole<Real>(token);
    // std::from_chars reports alike what is too large and what rounds to zero.
    if (parsed.error == std::errc::result_out_of_range && is_below_one(token)) {
        return {token.starts_with('-') ? -Real{0} : Real{0}, std::errc{}};
    }
    return parsed;
}

} // namespace

Parsed<double> parse_double(std::string_view token) {
    return parse_real<double>(token);
}

Parsed<float> parse_float(std::string_view token) {
    return parse_real<float>(token);
}

Parsed<std::int64_t> parse_integer(std::string_view token) {
    return parse_whole<std::int64_t>(token);
}

} // namespace foldless
