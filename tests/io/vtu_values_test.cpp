#include "io/vtu_values.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include "io/bytes.h"
#include "samples.h"

namespace alphamst::io::vtu {
namespace {

using samples::failure_of;
using vtk::Kind;

std::string base64(const std::string &bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 63];
    }
    return text;
}

template <class Number> std::string little(std::initializer_list<Number> numbers) {
    std::string bytes;
    for (const Number number : numbers)
        append_little(bytes, number);
    return bytes;
}

Array array(const std::string &text, Array::Place place, vtk::Type type = {Kind::whole, 4}) {
    Array result;
    result.name = "a";
    result.type = type;
    result.place = place;
    result.end = text.size();
    return result;
}

const std::vector<std::int64_t> wanted{1, -2, 300000};
const std::string numbers = little<std::int32_t>({1, -2, 300000});

TEST(VtuValues, WordsAndBytes) {
    const std::string words = " 1 -2\n300000 ";
    EXPECT_EQ(integers(words, array(words, Array::Place::words), {}, 3), wanted);
    const std::string raw = little<std::uint32_t>({12}) + numbers + "what follows";
    EXPECT_EQ(integers(raw, array(raw, Array::Place::raw), {}, 3), wanted);
    const std::string longer = little<std::uint64_t>({12}) + numbers;
    EXPECT_EQ(integers(longer, array(longer, Array::Place::raw), {.long_lengths = true}, -1), wanted);
    const std::string big{0, 0, 0, 4, 0, 0, 1, 2};
    EXPECT_EQ(integers(big, array(big, Array::Place::raw), {.big_endian = true}, 1),
              std::vector<std::int64_t>{258});
    const std::string real = little<std::uint32_t>({4}) + little<float>({0.5f});
    EXPECT_EQ(reals(real, array(real, Array::Place::raw, {Kind::real, 4}), {}, 1), std::vector<double>{0.5});
    EXPECT_EQ(failure_of([&] {
                  integers(real, array(real, Array::Place::raw, {Kind::real, 4}), {}, 1);
              }).fault,
              Fault::format);
}

// Some writers begin the numbers in a group of their own, and others do not.
TEST(VtuValues, Base64) {
    const std::string length = little<std::uint32_t>({12});
    for (const std::string &text : {base64(length + numbers), base64(length) + base64(numbers),
                                    "\n  " + base64(length + numbers).insert(5, "\n") + "\n "})
        EXPECT_EQ(integers(text, array(text, Array::Place::base64), {}, 3), wanted) << text;
    EXPECT_EQ(integers(" ", array(" ", Array::Place::base64), {}, 0), std::vector<std::int64_t>{});
    std::string wrong = base64(length + numbers);
    wrong[9] = '*';
    EXPECT_EQ(failure_of([&] { integers(wrong, array(wrong, Array::Place::base64), {}, 3); }).text,
              "byte 9: '*' is not of base64");
}

std::string packed(const std::string &bytes) {
    uLongf length = compressBound(static_cast<uLong>(bytes.size()));
    std::string result(length, '\0');
    compress(reinterpret_cast<Bytef *>(result.data()), &length, reinterpret_cast<const Bytef *>(bytes.data()),
             static_cast<uLong>(bytes.size()));
    result.resize(length);
    return result;
}

TEST(VtuValues, CompressedInBlocks) {
    const std::string first = packed(numbers.substr(0, 8)), second = packed(numbers.substr(8));
    const auto head = [&](std::uint32_t n, std::uint32_t size, std::uint32_t rest, std::uint32_t a) {
        return little<std::uint32_t>({n, size, rest, a, static_cast<std::uint32_t>(second.size())});
    };
    const auto size = static_cast<std::uint32_t>(first.size());
    const std::string good = head(2, 8, 4, size);
    const std::string raw = good + first + second, text = base64(good) + base64(first + second);
    EXPECT_EQ(integers(raw, array(raw, Array::Place::raw), {.zlib = true}, 3), wanted);
    EXPECT_EQ(integers(text, array(text, Array::Place::base64), {.zlib = true}, 3), wanted);
    const std::string whole = packed(numbers);
    const std::string one =
        little<std::uint32_t>({1, 12, 0, static_cast<std::uint32_t>(whole.size())}) + whole;
    EXPECT_EQ(integers(one, array(one, Array::Place::raw), {.zlib = true}, 3), wanted);
    const std::string none = little<std::uint32_t>({0, 0, 0});
    EXPECT_TRUE(integers(none, array(none, Array::Place::raw), {.zlib = true}, 0).empty());
    for (const std::string &bad :
         {head(2, 0xffffffff, 4, size), head(0xffffffff, 8, 4, size), head(2, 8, 5, size),
          head(2, 8, 9, size), head(2, 8, 4, 0xffffffff), head(2, 8, 4, size - 1), head(2, 8, 3, size)}) {
        const std::string file = bad + first + second;
        EXPECT_EQ(
            failure_of([&] { integers(file, array(file, Array::Place::raw), {.zlib = true}, 3); }).fault,
            Fault::format);
    }
}

TEST(VtuValues, CutOffAnywhere) {
    const std::string raw = little<std::uint32_t>({12}) + numbers;
    for (const auto &[whole, place] :
         {std::pair(raw, Array::Place::raw), std::pair(base64(raw), Array::Place::base64)})
        for (std::size_t n = 0; n < whole.size(); ++n) {
            const std::string cut = whole.substr(0, n);
            EXPECT_EQ(failure_of([&] { integers(cut, array(cut, place), {}, 3); }).fault, Fault::format) << n;
        }
    EXPECT_EQ(failure_of([&] { integers(raw, array(raw, Array::Place::raw), {}, 4); }).text,
              "byte 0: 'a' has 3 numbers, not 4");
}

} // namespace
} // namespace alphamst::io::vtu
