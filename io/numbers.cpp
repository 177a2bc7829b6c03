#include <foldless/io/numbers.h>

#include <charconv>
#include <cmath>

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

// std::from_chars reports numbers too small and too large alike; the wider type tells them apart. The wider value is
// below the smallest number of the narrow type, so that rounding it again gives what rounding once would.
template <class Narrow, class Wide>
Parsed<Narrow> narrowed(const Parsed<Wide>& wide) {
    if (wide.ok() && std::abs(wide.value) < 1) {
        return {static_cast<Narrow>(wide.value), std::errc{}};
    }
    return {Narrow{}, std::errc::result_out_of_range};
}

} // namespace

Parsed<double> parse_double(std::string_view token) {
    const auto parsed = parse_whole<double>(token);
    return parsed.error == std::errc::result_out_of_range ? narrowed<double>(parse_whole<long double>(token)) : parsed;
}

Parsed<float> parse_float(std::string_view token) {
    const auto parsed = parse_whole<float>(token);
    return parsed.error == std::errc::result_out_of_range ? narrowed<float>(parse_double(token)) : parsed;
}

Parsed<std::int64_t> parse_integer(std::string_view token) {
    return parse_whole<std::int64_t>(token);
}

} // namespace foldless
