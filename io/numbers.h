/// \file
/// Numbers spelled in text files, the same in every locale.
#pragma once

#include <cstdint>
#include <string_view>
#include <system_error>

namespace foldless {

/// A number and whether its text is one: `std::errc{}`, `invalid_argument`, or `result_out_of_range`.
template <class Number>
struct Parsed {
    Number value{};
    std::errc error{};
    [[nodiscard]] bool ok() const { return error == std::errc{}; }
};

/// The number that the whole token spells, rounded once to its type. A leading `+`, `nan` and `inf` are accepted, hex
/// digits are not. What is too small for the type is zero; what is too large is `result_out_of_range`.
[[nodiscard]] Parsed<double> parse_double(std::string_view token);
[[nodiscard]] Parsed<float> parse_float(std::string_view token);
[[nodiscard]] Parsed<std::int64_t> parse_integer(std::string_view token);

} // namespace foldless
