#include "io/number.h"

#include <gtest/gtest.h>

#include <bit>
#include <clocale>
#include <cmath>
#include <random>

namespace alphamst::io {
namespace {

Parsed real(std::string_view word, double &value) { return parse(word, value); }

TEST(Number, ReadsReals) {
    double x = 7;
    EXPECT_EQ(real("+1.5", x), Parsed::number);
    EXPECT_EQ(x, 1.5);
    EXPECT_EQ(real("2.", x), Parsed::number);
    EXPECT_EQ(x, 2);
    EXPECT_EQ(real("-1E-2", x), Parsed::number);
    EXPECT_EQ(x, -0.01);
    EXPECT_EQ(real("nan", x), Parsed::number);
    EXPECT_TRUE(std::isnan(x));
    for (const char *word : {"", "+", "+-1", "1.5x", "1,5", "x", "--1", "3.1+e2"})
        EXPECT_EQ(real(word, x), Parsed::malformed) << word;
}

TEST(Number, TellsTooLargeFromTooSmall) {
    double x = 7;
    for (const char *word : {"1e309", "-1e309", "1e99999999999999999999", "0.001e400", "1e+400"})
        EXPECT_EQ(real(word, x), Parsed::too_large) << word;
    for (const char *word :
         {"1e-400", "1e-99999999999999999999", "1000e-400", "0.0001e-320", "0e99999999999"}) {
        x = 7;
        EXPECT_EQ(real(word, x), Parsed::number) << word;
        EXPECT_EQ(x, 0) << word;
    }
    EXPECT_EQ(real("-1e-400", x), Parsed::number);
    EXPECT_TRUE(std::signbit(x));
    EXPECT_EQ(real("4.9406564584124654e-324", x), Parsed::number);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(x), 1u);
}

TEST(Number, ReadsIntegers) {
    std::int64_t i = 0;
    EXPECT_EQ(parse("+12", i), Parsed::number);
    EXPECT_EQ(i, 12);
    EXPECT_EQ(parse("-9223372036854775808", i), Parsed::number);
    EXPECT_EQ(parse("9223372036854775808", i), Parsed::too_large);
    EXPECT_EQ(parse("1.0", i), Parsed::malformed);
}

TEST(Number, EveryDoubleComesBack) {
    std::setlocale(LC_ALL, "de_DE.UTF-8"); // where there is one, the comma must not matter
    std::mt19937_64 random(1);
    for (int i = 0; i < 20000; ++i) {
        const double x = std::bit_cast<double>(random());
        if (!std::isfinite(x))
            continue;
        std::string text;
        append_number(text, x);
        double y = 0;
        ASSERT_EQ(real(text, y), Parsed::number) << text;
        ASSERT_EQ(std::bit_cast<std::uint64_t>(x), std::bit_cast<std::uint64_t>(y)) << text;
    }
    std::setlocale(LC_ALL, "C");
}

} // namespace
} // namespace alphamst::io
