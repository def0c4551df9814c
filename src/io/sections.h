// The sections of a file of the project's own format, see checkpoint.h.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes.h"
#include "io/scanner.h"

namespace alphamst::io {

class SectionWriter {
public:
    SectionWriter();

    template <class Number> void add(std::string_view letters, std::span<const Number> numbers) {
        std::string bytes;
        bytes.reserve(numbers.size() * sizeof(Number));
        for (const Number number : numbers)
            append_little(bytes, number);
        add_bytes(letters, sizeof(Number), bytes);
    }
    template <class Number> void add(std::string_view letters, const std::vector<Number> &numbers) {
        add(letters, std::span<const Number>(numbers));
    }
    std::string finished() const; // the file

private:
    void add_bytes(std::string_view letters, std::size_t element, const std::string &bytes);

    std::string file_;
};

class SectionReader {
public:
    explicit SectionReader(std::string_view file); // fails where the head is damaged

    // The next section, which must be that one.
    template <class Number> std::vector<Number> take(std::string_view letters) {
        const std::string_view bytes = take_bytes(letters, sizeof(Number));
        std::vector<Number> numbers(bytes.size() / sizeof(Number));
        for (std::size_t i = 0; i < numbers.size(); ++i)
            numbers[i] = decode<Number>(bytes.data() + i * sizeof(Number), false);
        return numbers;
    }
    void expect_end() const;
    // With the first byte of the last section.
    [[noreturn]] void fail(const std::string &text) const;

private:
    std::string_view take_bytes(std::string_view letters, std::size_t element);

    std::string_view file_;
    std::size_t here_ = 0, start_ = 0;
};

} // namespace alphamst::io
