#include "io/sections.h"

#include <algorithm>

#include "digest.h"

namespace alphamst::io {
namespace {

constexpr std::string_view magic = "\x89"
                                   "AMST\r\n\x1a";
constexpr std::uint32_t byte_order = 0x01020304, version = 1;
constexpr std::size_t head_size = 24, length_place = 16; // of the file
constexpr std::size_t section_head = 24, alignment = 8;

std::string head_of(std::string_view letters, std::size_t element, std::uint64_t n) {
    std::string head(letters);
    append_little(head, static_cast<std::uint32_t>(element));
    append_little(head, n);
    return head;
}

void add_to(Digest &digest, std::string_view bytes) {
    for (std::size_t i = 0; i < bytes.size(); i += alignment) {
        std::array<char, alignment> word{};
        std::copy_n(bytes.data() + i, std::min(alignment, bytes.size() - i), word.begin());
        digest.add(decode<std::uint64_t>(word.data(), false));
    }
}

std::uint64_t digest_of(std::string_view head, std::string_view bytes) {
    Digest digest;
    add_to(digest, head);
    add_to(digest, bytes);
    return digest.value();
}

} // namespace

SectionWriter::SectionWriter() : file_(magic) {
    append_little(file_, byte_order);
    append_little(file_, version);
    append_little(file_, std::uint64_t{0}); // the length, in the end
}

void SectionWriter::add_bytes(std::string_view letters, std::size_t element, const std::string &bytes) {
    const std::string head = head_of(letters, element, bytes.size());
    file_ += head;
    append_little(file_, digest_of(head, bytes));
    file_ += bytes;
    file_.resize((file_.size() + alignment - 1) / alignment * alignment);
}

std::string SectionWriter::finished() const {
    std::string length, file = file_;
    append_little(length, std::uint64_t{file.size()});
    return file.replace(length_place, length.size(), length);
}

SectionReader::SectionReader(std::string_view file) : file_(file) {
    if (!file.starts_with(magic))
        fail(
            "this is no checkpoint of AlphaMST, or its line ends were changed on the way: copy it as binary");
    start_ = magic.size();
    if (file.size() < head_size)
        fail("the file was cut off");
    if (decode<std::uint32_t>(file.data() + start_, false) != byte_order)
        fail("the order of the bytes is wrong; copy the file as it was written");
    start_ += sizeof byte_order;
    if (const auto found = decode<std::uint32_t>(file.data() + start_, false); found != version)
        throw Failure(Fault::unsupported, "byte " + std::to_string(start_) + ": the checkpoint has version " +
                                              std::to_string(found) + ", this library reads version " +
                                              std::to_string(version) + "; take a later library");
    start_ = length_place;
    if (const auto length = decode<std::uint64_t>(file.data() + start_, false); length != file.size())
        fail("the file has " + std::to_string(file.size()) + " bytes, not " + std::to_string(length) +
             "; it was cut off, or something was added");
    here_ = start_ = head_size;
}

std::string_view SectionReader::take_bytes(std::string_view letters, std::size_t element) {
    start_ = here_;
    const std::string name = "the section " + std::string(letters);
    const std::string_view start = file_.substr(here_, section_head);
    if (start.size() < section_head || !start.starts_with(letters) ||
        decode<std::uint32_t>(start.data() + 4, false) != element)
        fail(name + " is not where it should be; the file is damaged");
    const auto n = decode<std::uint64_t>(file_.data() + here_ + 8, false);
    const auto digest = decode<std::uint64_t>(file_.data() + here_ + 16, false);
    if (n > file_.size() - here_ - section_head || n % element != 0)
        fail(name + " has a length that cannot be; the file is damaged");
    const std::string_view bytes = file_.substr(here_ + section_head, static_cast<std::size_t>(n));
    here_ += section_head + bytes.size();
    const std::size_t end = (here_ + alignment - 1) / alignment * alignment;
    if (digest_of(head_of(letters, element, n), bytes) != digest || end > file_.size() ||
        file_.substr(here_, end - here_).find_first_not_of('\0') != std::string_view::npos)
        fail(name + " is damaged");
    here_ = end;
    return bytes;
}

void SectionReader::expect_end() const {
    if (here_ != file_.size())
        fail("something follows the last section; the file is damaged");
}

void SectionReader::fail(const std::string &text) const {
    throw Failure(Fault::format, "byte " + std::to_string(start_) + ": " + text);
}

} // namespace alphamst::io
