#include "io/sections.h"

#include <gtest/gtest.h>

#include "samples.h"

namespace alphamst::io {
namespace {

using samples::failure_of;

std::string file_of(const std::vector<double> &reals) {
    SectionWriter to;
    to.add("real", reals);
    to.add("text", std::span<const char>(std::string_view("five!").data(), 5));
    return to.finished();
}

TEST(Sections, ThereAndBack) {
    const std::vector<double> reals{0.1, -0.0, 1e300};
    const std::string file = file_of(reals);
    EXPECT_EQ(file.size() % 8, 0u);
    SectionReader from(file);
    EXPECT_TRUE(samples::same_bits(from.take<double>("real"), reals));
    EXPECT_EQ(from.take<char>("text"), (std::vector<char>{'f', 'i', 'v', 'e', '!'}));
    from.expect_end();
}

TEST(Sections, EveryByteCounts) {
    const std::string file = file_of({1, 2});
    for (std::size_t i = 0; i < file.size(); ++i)
        for (const int bit : {1, 128}) {
            std::string damaged = file;
            damaged[i] = static_cast<char>(damaged[i] ^ bit);
            const Failure failure = failure_of([&] {
                SectionReader from(damaged);
                from.take<double>("real");
                from.take<char>("text");
                from.expect_end();
            });
            EXPECT_TRUE(failure.fault == Fault::format || failure.fault == Fault::unsupported) << i;
            EXPECT_TRUE(failure.text.starts_with("byte ")) << failure.text;
        }
}

TEST(Sections, FailuresNameTheirPlace) {
    const std::string file = file_of({1, 2});
    const auto text_of = [&](const std::string &bytes, const char *section) {
        return failure_of([&] { SectionReader(bytes).take<double>(section); }).text;
    };
    EXPECT_EQ(text_of(file, "reel"),
              "byte 24: the section reel is not where it should be; the file is damaged");
    EXPECT_EQ(text_of(file.substr(0, 60), "real").substr(0, 27), "byte 16: the file has 60 by");
    EXPECT_EQ(text_of("solid", "real").substr(0, 24), "byte 0: this is no check");
    std::string lines = file; // as a program does that takes the file for text
    lines.erase(5, 1);
    EXPECT_EQ(text_of(lines, "real").substr(0, 8), "byte 0: ");
    std::string later = file;
    later[12] = 2;
    EXPECT_EQ(failure_of([&] { SectionReader from(later); }).fault, Fault::unsupported);
}

} // namespace
} // namespace alphamst::io
