#include "io/number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace alphamst::io {
namespace {

std::string_view without_plus(std::string_view word) {
    return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

// from_chars says "out of range" for 1e999 and for 1e-999 alike. The decimal
// exponent of the first non-zero digit tells which of the two it is.
bool too_small(std::string_view word) {
    const std::size_t e = std::min(word.find_first_of("eE"), word.size());
    std::int64_t exponent = 0;
    if (e < word.size()) {
        const std::string_view power = without_plus(word.substr(e + 1));
        if (parse(power, exponent) == Parsed::too_large)
            return power[0] == '-';
    }
    const std::string_view digits = word.substr(0, e);
    const std::size_t first = digits.find_first_of("123456789");
    const std::size_t point = std::min(digits.find('.'), digits.size());
    if (first == std::string_view::npos)
        return true;
    return static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first) < -exponent;
}

} // namespace

Parsed parse(std::string_view word, std::int64_t &value) {
    word = without_plus(word);
    const char *end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (error == std::errc::invalid_argument || stop != end)
        return Parsed::malformed;
    return error == std::errc() ? Parsed::number : Parsed::too_large;
}

Parsed parse(std::string_view word, double &value) {
    word = without_plus(word);
    const char *end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (error == std::errc::invalid_argument || stop != end)
        return Parsed::malformed;
    if (error == std::errc())
        return Parsed::number;
    if (!too_small(word))
        return Parsed::too_large;
    value = word[0] == '-' ? -0.0 : 0.0;
    return Parsed::number;
}

void append_number(std::string &text, double value) {
    std::array<char, 32> word; // the longest shortest double has 24 characters
    text.append(word.data(), std::to_chars(word.data(), word.data() + word.size(), value).ptr);
}

void append_number(std::string &text, std::int64_t value) {
    std::array<char, 24> word;
    text.append(word.data(), std::to_chars(word.data(), word.data() + word.size(), value).ptr);
}

} // namespace alphamst::io
