#include "io/scanner.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/number.h"

namespace alphamst::io {
namespace {

constexpr std::string_view line_ends = "\r\n"; // also a lone \r, as on the first Macs

bool blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

bool ends_line(char c) { return c == '\n' || c == '\r'; }

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

} // namespace

void Scanner::skip_blanks() { // and comments, and the ends of lines that continue
    while (here_ < text_.size()) {
        if (blank(text_[here_])) {
            ++here_;
        } else if (comment_ != '\0' && text_[here_] == comment_) {
            here_ = std::min(text_.find_first_of(line_ends, here_), text_.size());
        } else if (continues_ && ahead("\\\n")) {
            here_ += 2;
        } else if (continues_ && ahead("\\\r\n")) {
            here_ += 3;
        } else {
            return;
        }
    }
}

bool Scanner::at_line_end() {
    skip_blanks();
    return here_ == text_.size() || ends_line(text_[here_]);
}

bool Scanner::at_end() {
    while (at_line_end() && here_ < text_.size())
        ++here_;
    return here_ == text_.size();
}

std::string_view Scanner::word() {
    const bool none = at_end();
    word_ = here_;
    if (none)
        malformed("the file ends too early; it is empty or was cut off");
    while (here_ < text_.size() && !blank(text_[here_]) && !ends_line(text_[here_]) &&
           (comment_ == '\0' || text_[here_] != comment_) &&
           !(continues_ && (ahead("\\\n") || ahead("\\\r\n"))))
        ++here_;
    return text_.substr(word_, here_ - word_);
}

std::string_view Scanner::line() {
    word_ = here_;
    std::size_t end = std::min(text_.find_first_of(line_ends, here_), text_.size());
    here_ = end;
    here_ += ahead("\r\n") ? 2 : end < text_.size() ? 1 : 0;
    while (end > word_ && blank(text_[end - 1]))
        --end;
    return text_.substr(word_, end - word_);
}

double Scanner::real() {
    const std::string_view w = word();
    double value = 0;
    switch (parse(w, value)) {
    case Parsed::number:
        return value;
    case Parsed::too_large:
        malformed("the number " + quoted(w) + " is too large");
    default:
        malformed("found " + quoted(w) + " in place of a number");
    }
}

std::int64_t Scanner::integer() {
    const std::string_view w = word();
    std::int64_t value = 0;
    switch (parse(w, value)) {
    case Parsed::number:
        return value;
    case Parsed::too_large:
        malformed("the number " + quoted(w) + " is too large");
    default:
        malformed("found " + quoted(w) + " in place of a whole number");
    }
}

std::int64_t Scanner::count(std::string_view things, std::size_t least) {
    const std::int64_t n = integer();
    expect(n, things, least);
    return n;
}

void Scanner::expect(std::int64_t n, std::string_view things, std::size_t least) {
    const std::string promise = std::to_string(n) + " " + std::string(things);
    if (n < 0)
        malformed(promise + " cannot be");
    // The last thing may lack its line end, hence the 1.
    if (static_cast<std::uint64_t>(n) > (remaining() + 1) / least)
        malformed(promise + " are promised, but only " + std::to_string(remaining()) +
                  " bytes follow: the file is cut off, or the number is wrong");
    if (n > std::numeric_limits<std::int32_t>::max())
        fail(Fault::unsupported, promise + " are more than 32-bit numbers can name");
}

std::string_view Scanner::take(std::size_t bytes) {
    binary_ = true;
    word_ = here_;
    if (bytes > remaining())
        malformed("the file ends too early; it is empty or was cut off");
    here_ += bytes;
    return text_.substr(word_, bytes);
}

void Scanner::fail(Fault fault, std::string_view text, Entity entity, std::vector<std::int64_t> ids) const {
    std::int64_t lines = 1;
    for (std::size_t i = 0; i < word_; ++i)
        lines += text_[i] == '\n' || (text_[i] == '\r' && !text_.substr(i + 1).starts_with('\n'));
    const std::string place = binary_ ? "byte " + std::to_string(word_) : "line " + std::to_string(lines);
    throw Failure(fault, place + ": " + std::string(text), entity, std::move(ids));
}

std::string quoted(std::string_view word) {
    std::string text = "'";
    for (char c : word.substr(0, 24))
        text += c > ' ' && c <= '~' && c != '{' && c != '}' ? c : '?';
    return text + (word.size() > 24 ? "...'" : "'");
}

bool same_word(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char p, char q) { return lower(p) == lower(q); });
}

void add_vertex(const Scanner &at, Arrays &mesh, double x, double y, double z) {
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
        at.fail(Fault::not_finite,
                "vertex {} has a coordinate that is infinite or not a number; give it a finite one",
                Entity::vertex, {static_cast<std::int64_t>(mesh.points.size() / 3)});
    mesh.points.insert(mesh.points.end(), {x, y, z});
}

std::int32_t corner(const Scanner &at, const Arrays &mesh, std::int64_t vertex, std::int64_t n_vertices,
                    std::int64_t first_number) {
    if (vertex < first_number || vertex - first_number >= n_vertices)
        at.fail(Fault::range,
                "face {} has vertex number " + std::to_string(vertex) + " of the file, which has " +
                    std::to_string(n_vertices) + " vertices counted from " + std::to_string(first_number) +
                    (vertex == first_number - 1            ? "; correct it, or add 1 to all numbers"
                     : vertex == first_number + n_vertices ? "; correct it, or take 1 off all numbers"
                                                           : "; correct it, or add the vertex"),
                Entity::face, {static_cast<std::int64_t>(mesh.faces.size() / 4)});
    return static_cast<std::int32_t>(vertex - first_number);
}

std::size_t need_corners(const Scanner &at, const Arrays &mesh, std::int64_t n) {
    if (n != 3 && n != 4)
        at.fail(Fault::not_quad,
                "face {} has " + std::to_string(n) +
                    " corners, not 3 or 4; divide it into triangles or quadrilaterals",
                Entity::face, {static_cast<std::int64_t>(mesh.faces.size() / 4)});
    return static_cast<std::size_t>(n);
}

Arrays finished(Arrays mesh) {
    mesh.dim = 2;
    for (std::size_t i = 2; i < mesh.points.size(); i += 3)
        if (mesh.points[i] != 0)
            mesh.dim = 3;
    return mesh;
}

} // namespace alphamst::io
