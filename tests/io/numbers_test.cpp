#include <foldless/io/numbers.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace foldless {
namespace {

TEST(Numbers, AreRoundedOnceToTheirType) {
    EXPECT_EQ(parse_double("0.1").value, 0.1);
    EXPECT_EQ(parse_float("0.1").value, 0.1F);
    EXPECT_EQ(parse_double("-.5e-3").value, -0.5e-3);
    EXPECT_EQ(parse_double("5.").value, 5.0);
    // Just above the midpoint of two floats; rounding to double first would land on the midpoint and then on 1.
    EXPECT_EQ(parse_float("1.00000005960464477540").value, std::nextafter(1.0F, 2.0F));
}

TEST(Numbers, AcceptALeadingPlus) {
    EXPECT_EQ(parse_double("+1.5").value, 1.5);
    EXPECT_EQ(parse_integer("+7").value, 7);
    EXPECT_EQ(parse_double("+-1").error, std::errc::invalid_argument);
    EXPECT_EQ(parse_double("++1").error, std::errc::invalid_argument);
    EXPECT_EQ(parse_double("+").error, std::errc::invalid_argument);
}

TEST(Numbers, ReadNotANumberAndInfinity) {
    EXPECT_TRUE(std::isnan(parse_double("NaN").value));
    EXPECT_TRUE(parse_double("-nan(ind)").ok());
    EXPECT_EQ(parse_double("-Inf").value, -std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isinf(parse_float("infinity").value));
}

TEST(Numbers, RefuseWhatIsNoNumberThroughout) {
    for (const char* text : {"", "-", ".", "e5", "1,5", "1.5x", "0x10", "zero", "1.#QNAN", "1 ", " 1", "1e", "--1"}) {
        EXPECT_EQ(parse_double(text).error, std::errc::invalid_argument) << text;
        EXPECT_EQ(parse_float(text).error, std::errc::invalid_argument) << text;
    }
    for (const char* text : {"", "1.5", "1e3", "0x1", "a", "-"}) {
        EXPECT_EQ(parse_integer(text).error, std::errc::invalid_argument) << text;
    }
}

TEST(Numbers, TellTooLargeFromTooSmall) {
    EXPECT_EQ(parse_double("1e400").error, std::errc::result_out_of_range);
    EXPECT_EQ(parse_double("-1e400").error, std::errc::result_out_of_range);
    EXPECT_EQ(parse_double("1e-400").value, 0.0);
    EXPECT_TRUE(parse_double("1e-400").ok());
    EXPECT_EQ(parse_double("1e-310").value, 1e-310);
    EXPECT_EQ(parse_float("1e39").error, std::errc::result_out_of_range);
    EXPECT_EQ(parse_float("1e400").error, std::errc::result_out_of_range);
    EXPECT_TRUE(parse_float("-1e-60").ok());
    EXPECT_EQ(parse_float("1e-44").value, 1e-44F);
    EXPECT_EQ(parse_integer("9223372036854775808").error, std::errc::result_out_of_range);
    EXPECT_EQ(parse_integer("-9223372036854775808").value, std::numeric_limits<std::int64_t>::min());
}

TEST(Numbers, TellTooLargeFromTooSmallWhateverTheExponent) {
    for (const char* text : {"1e-5000", "-1e-99999999999999999999", "0.0001e-9223372036854775807", "123e-400"}) {
        EXPECT_TRUE(parse_double(text).ok()) << text;
        EXPECT_EQ(parse_double(text).value, 0.0) << text;
        EXPECT_EQ(std::signbit(parse_double(text).value), text[0] == '-') << text;
        EXPECT_TRUE(parse_float(text).ok()) << text;
    }
    for (const char* text :
         {"1e5000", "-1e99999999999999999999", "+1e+400", "0.0001e9223372036854775807", ".001e400"}) {
        EXPECT_EQ(parse_double(text).error, std::errc::result_out_of_range) << text;
        EXPECT_EQ(parse_float(text).error, std::errc::result_out_of_range) << text;
    }
    EXPECT_EQ(parse_double("0e99999999999999999999").value, 0.0);
    EXPECT_EQ(parse_double("3e-324").value, std::numeric_limits<double>::denorm_min());
    EXPECT_EQ(parse_float("1e-45").value, std::numeric_limits<float>::denorm_min());
}

TEST(Numbers, ReadAMillionDigits) {
    EXPECT_TRUE(parse_double("0." + std::string(1000000, '0') + "1").ok());
    EXPECT_EQ(parse_double(std::string(1000000, '0') + "1").value, 1.0);
    EXPECT_EQ(parse_double(std::string(1000000, '9')).error, std::errc::result_out_of_range);
}

} // namespace
} // namespace foldless
