#include "io/vtu_values.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <new>

#include "io/scanner.h"

namespace alphamst::io::vtu {
namespace {

[[noreturn]] void fail(std::size_t byte, const std::string &text) {
    throw Failure(Fault::format, "byte " + std::to_string(byte) + ": " + text);
}

[[noreturn]] void ends_early(std::size_t byte, const Array &array) {
    fail(byte,
         "the numbers of " + io::quoted(array.name) + " end too early; the file is damaged or was cut off");
}

int six_bits(char c) {
    return c >= 'A' && c <= 'Z'   ? c - 'A'
           : c >= 'a' && c <= 'z' ? c - 'a' + 26
           : c >= '0' && c <= '9' ? c - '0' + 52
           : c == '+'             ? 62
           : c == '/'             ? 63
                                  : -1;
}

// Bytes of an array one after the other. In base64 some writers end the lengths with a group of their own
// and others do not, so that groups with = may come in the middle.
class Stream {
public:
    Stream(std::string_view file, const Array &array) : file_(file), array_(array), here_(array.begin) {}

    std::string take(std::uint64_t n) {
        const std::size_t left = array_.end - here_;
        const std::size_t most = array_.place == Array::Place::raw ? left : left / 4 * 3 + group_.size();
        if (n > most)
            ends_early(here_, array_);
        std::string bytes;
        bytes.reserve(static_cast<std::size_t>(n));
        if (array_.place == Array::Place::raw) {
            bytes = file_.substr(here_, static_cast<std::size_t>(n));
            here_ += bytes.size();
            return bytes;
        }
        while (bytes.size() < n) {
            if (group_.empty())
                read_group();
            const std::size_t used = std::min(group_.size(), static_cast<std::size_t>(n) - bytes.size());
            bytes += group_.substr(0, used);
            group_.erase(0, used);
        }
        return bytes;
    }
    std::size_t here() const { return here_; }
    bool at_end() {
        while (here_ < array_.end && blank(file_[here_]))
            ++here_;
        return group_.empty() && here_ >= array_.end;
    }

private:
    static bool blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

    void read_group() {
        std::uint32_t bits = 0;
        int digits = 0, padding = 0;
        while (digits + padding < 4) {
            if (here_ >= array_.end)
                ends_early(here_, array_);
            const char c = file_[here_++];
            if (blank(c))
                continue;
            const int value = six_bits(c);
            if (c == '=' && digits >= 2)
                ++padding;
            else if (value >= 0 && padding == 0)
                ++digits;
            else
                fail(here_ - 1, quoted(std::string_view(&c, 1)) + " is not of base64");
            bits = bits << 6 | static_cast<std::uint32_t>(std::max(value, 0));
        }
        for (int i = 0; i < 3 - padding; ++i)
            group_ += static_cast<char>(bits >> (16 - 8 * i) & 0xff);
    }

    std::string_view file_;
    const Array &array_;
    std::size_t here_;
    std::string group_; // decoded and not yet taken
};

std::uint64_t length_of(Stream &stream, Encoding encoding) {
    const std::size_t size = encoding.long_lengths ? 8 : 4;
    const std::string bytes = stream.take(size);
    return static_cast<std::uint64_t>(
        vtk::integer_of(bytes.data(), {vtk::Kind::natural, size}, encoding.big_endian));
}

// Appends what zlib makes of a block, `wanted` bytes. Memory grows with what comes, not with what was
// promised.
bool inflate_block(std::string &bytes, const std::string &packed, std::uint64_t wanted) {
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK)
        throw std::bad_alloc(); // the one failure there is when the library is the one that was built with
    const std::unique_ptr<z_stream, int (*)(z_stream *)> freed(&stream, inflateEnd);
    stream.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    std::array<char, 1 << 14> part; // small beside any mesh
    std::uint64_t left = wanted;
    int status = Z_OK;
    while (status == Z_OK) {
        const auto room = static_cast<uInt>(std::min<std::uint64_t>(left, part.size()));
        stream.next_out = reinterpret_cast<Bytef *>(part.data());
        stream.avail_out = room;
        status = inflate(&stream, Z_NO_FLUSH);
        bytes.append(part.data(), room - stream.avail_out);
        left -= room - stream.avail_out;
    }
    return status == Z_STREAM_END && left == 0;
}

// The number of blocks, the size of each and of a last smaller one, the sizes they have in the file, and then
// these blocks.
std::string inflated(Stream &stream, const Array &array, Encoding encoding) {
    const std::size_t start = stream.here(), word = encoding.long_lengths ? 8 : 4;
    const std::uint64_t n = length_of(stream, encoding), size = length_of(stream, encoding),
                        rest = length_of(stream, encoding);
    const std::uint64_t most = array.end - start;
    if (n > most / word || rest > size)
        fail(start, "the blocks of " + io::quoted(array.name) + " do not fit in the file");
    std::vector<std::uint64_t> sizes(static_cast<std::size_t>(n));
    for (std::uint64_t &block : sizes) {
        block = length_of(stream, encoding);
        if (block > std::min<std::uint64_t>(most, std::numeric_limits<uInt>::max()))
            fail(start, "the blocks of " + io::quoted(array.name) + " do not fit in the file");
    }
    std::string bytes;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const std::size_t place = stream.here();
        const std::string packed = stream.take(sizes[i]);
        if (!inflate_block(bytes, packed, i + 1 == sizes.size() && rest != 0 ? rest : size))
            fail(place, "a compressed block of " + io::quoted(array.name) + " is damaged");
    }
    return bytes;
}

template <class Number, class Word, class Bytes>
std::vector<Number> numbers(std::string_view file, const Array &array, Encoding encoding, std::int64_t wanted,
                            const Word &word, const Bytes &decode) {
    std::vector<Number> result;
    const auto wrong = [&](std::size_t n) {
        fail(array.begin, io::quoted(array.name) + " has " + std::to_string(n) + " numbers, not " +
                              std::to_string(wanted));
    };
    if (array.place == Array::Place::words) {
        Scanner scan(file.substr(0, array.end));
        scan.take(array.begin);
        if (wanted > 0)
            scan.expect(wanted, "numbers", 2);
        result.reserve(static_cast<std::size_t>(std::max<std::int64_t>(wanted, 0)));
        while (!scan.at_end())
            result.push_back(word(scan));
    } else {
        Stream stream(file, array);
        std::string bytes;
        if (array.place == Array::Place::raw || !stream.at_end()) // nothing at all: no numbers
            bytes =
                encoding.zlib ? inflated(stream, array, encoding) : stream.take(length_of(stream, encoding));
        if (bytes.size() % array.type.size != 0)
            fail(array.begin,
                 "the bytes of " + io::quoted(array.name) + " are not whole numbers of its type");
        result.reserve(bytes.size() / array.type.size);
        for (std::size_t i = 0; i < bytes.size(); i += array.type.size)
            result.push_back(decode(bytes.data() + i));
    }
    if (wanted >= 0 && result.size() != static_cast<std::size_t>(wanted))
        wrong(result.size());
    return result;
}

} // namespace

std::vector<double> reals(std::string_view file, const Array &array, Encoding encoding, std::int64_t wanted) {
    return numbers<double>(
        file, array, encoding, wanted, [](Scanner &scan) { return scan.real(); },
        [&](const char *bytes) { return vtk::real_of(bytes, array.type, encoding.big_endian); });
}

std::vector<std::int64_t> integers(std::string_view file, const Array &array, Encoding encoding,
                                   std::int64_t wanted) {
    if (array.type.kind == vtk::Kind::real)
        fail(array.begin, io::quoted(array.name) + " are not whole numbers");
    return numbers<std::int64_t>(
        file, array, encoding, wanted, [](Scanner &scan) { return scan.integer(); },
        [&](const char *bytes) { return vtk::integer_of(bytes, array.type, encoding.big_endian); });
}

} // namespace alphamst::io::vtu
