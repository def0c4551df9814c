// Reads Abaqus input (Abaqus keywords guide): nodes, elements of three or four nodes and lines, and sets. The
// k-th set or surface of a name is number k, whatever it is of; keywords that are not of the mesh are passed
// over.
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "index.h"
#include "io/formats.h"
#include "io/inp_sets.h"
#include "io/markers.h"
#include "io/number.h"
#include "io/scanner.h"
#include "io/tags.h"

namespace alphamst::io {
namespace {

struct Shape {
    std::string_view family; // of names of types of elements
    char digit;              // behind it, before letters of variants
    std::size_t nodes;
};

// 3 and 4 are the numbers of nodes of all families of faces; those of lines have the order, or the nodes.
constexpr std::array<std::string_view, 15> face_families{"CPS",  "CPE",  "CPEG", "CAX",   "CGAX",
                                                         "S",    "STRI", "M3D",  "SFM3D", "R3D",
                                                         "DC2D", "DCAX", "AC2D", "ACAX",  "DS"};
constexpr std::array<Shape, 8> lines{{{"T2D", '2', 2},
                                      {"T3D", '2', 2},
                                      {"R2D", '2', 2},
                                      {"RAX", '2', 2},
                                      {"B2", '1', 2},
                                      {"B3", '1', 2},
                                      {"SAX", '1', 2},
                                      {"MAX", '1', 2}}};

bool is_of(std::string_view type, std::string_view family, char digit) {
    const auto is_digit = [&](std::size_t i) { return i < type.size() && type[i] >= '0' && type[i] <= '9'; };
    return same_word(type.substr(0, family.size()), family) && type.size() > family.size() &&
           type[family.size()] == digit && !is_digit(family.size() + 1);
}

// 2, 3 or 4; 0: not read.
std::size_t nodes_of(std::string_view type) {
    for (const std::string_view family : face_families)
        for (const char digit : {'3', '4'})
            if (is_of(type, family, digit))
                return at(digit - '0');
    for (const Shape &line : lines)
        if (is_of(type, line.family, line.digit))
            return line.nodes;
    return 0;
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = std::min(text.find_first_not_of(" \t"), text.size());
    text.remove_prefix(first);
    return text.substr(0, text.find_last_not_of(" \t") + 1);
}

// Between the commas; nothing behind the last one.
std::vector<std::string_view> split(std::string_view line) {
    std::vector<std::string_view> words;
    for (std::size_t from = 0; from < line.size();) {
        const std::size_t comma = std::min(line.find(',', from), line.size());
        words.push_back(trimmed(line.substr(from, comma - from)));
        from = comma + 1;
    }
    return words;
}

class Reader {
public:
    explicit Reader(std::string_view bytes) : scan_(bytes) {}

    Arrays read() {
        while (!scan_.at_end()) {
            const std::string_view line = scan_.line();
            if (line.starts_with("**"))
                continue;
            if (line.starts_with('*'))
                begin(split(line.substr(1)));
            else
                read_data(line);
        }
        if (mesh_.points.empty() || mesh_.faces.empty())
            scan_.malformed(mesh_.points.empty() ? "the file has no *NODE"
                                                 : "the file has no *ELEMENT of faces");
        if (!nodes_.close() || !elements_.close())
            scan_.malformed("two nodes or two elements have the same number; write the mesh of one part");
        sets_.add_markers(nodes_, elements_, element_faces_, mesh_);
        settle_markers(mesh_, [this](std::int32_t vertex) { return nodes_.tag_of(vertex); });
        return finished(std::move(mesh_));
    }

private:
    enum class Block { other, node, element, node_set, element_set, surface };

    // The value of a parameter; "" of one without, nothing if it is not there.
    static std::optional<std::string_view> parameter(const std::vector<std::string_view> &words,
                                                     std::string_view name) {
        for (const std::string_view word : std::span(words).subspan(1)) { // behind the keyword
            const std::size_t equals = std::min(word.find('='), word.size());
            if (same_word(trimmed(word.substr(0, equals)), name))
                return trimmed(word.substr(std::min(equals + 1, word.size())));
        }
        return std::nullopt;
    }

    void begin(const std::vector<std::string_view> &words) {
        if (words.empty())
            scan_.malformed("a line has no keyword behind its *");
        const std::string_view keyword = words[0];
        block_ = Block::other;
        set_ = nullptr;
        for (const char *generating : {"NGEN", "NFILL", "NCOPY", "ELGEN", "ELCOPY", "INCLUDE", "NMAP"})
            if (same_word(keyword, generating))
                scan_.fail(Fault::unsupported,
                           "the keyword " + quoted(keyword) +
                               " is not read; write all nodes and elements into the file");
        if (same_word(keyword, "NODE"))
            begin(Block::node, InputSets::Kind::nodes, parameter(words, "NSET"));
        else if (same_word(keyword, "ELEMENT"))
            begin_elements(words);
        else if (same_word(keyword, "NSET"))
            begin(Block::node_set, InputSets::Kind::nodes, needed(words, "NSET"));
        else if (same_word(keyword, "ELSET"))
            begin(Block::element_set, InputSets::Kind::elements, needed(words, "ELSET"));
        else if (same_word(keyword, "SURFACE"))
            begin(Block::surface,
                  same_word(parameter(words, "TYPE").value_or(""), "NODE") ? InputSets::Kind::nodes
                                                                           : InputSets::Kind::sides,
                  needed(words, "NAME"));
        generate_ = parameter(words, "GENERATE").has_value();
    }

    void begin(Block block, InputSets::Kind kind, std::optional<std::string_view> name) {
        block_ = block;
        if (name && !name->empty())
            set_ = &sets_.named(*name, kind);
    }

    std::string_view needed(const std::vector<std::string_view> &words, std::string_view name) const {
        const std::optional<std::string_view> value = parameter(words, name);
        if (!value || value->empty())
            scan_.malformed("the keyword " + quoted(words[0]) + " lacks " + std::string(name) + "=");
        return *value;
    }

    void begin_elements(const std::vector<std::string_view> &words) {
        const std::string_view type = needed(words, "TYPE");
        begin(Block::element, InputSets::Kind::elements, parameter(words, "ELSET"));
        n_nodes_ = nodes_of(type);
        if (n_nodes_ == 0)
            scan_.fail(
                Fault::not_quad,
                "face {} is of the type " + quoted(type) +
                    ", not a triangle, quadrilateral or line of straight sides; leave such elements out, or "
                    "write their surface",
                Entity::face, {static_cast<std::int64_t>(mesh_.faces.size() / 4)});
        if (elements_open_)
            return;
        elements_open_ = true;
        if (!nodes_.close())
            scan_.malformed("two nodes have the same number; write the mesh of one part");
    }

    void read_data(std::string_view line) {
        if (block_ == Block::node)
            read_node(split(line));
        else if (block_ == Block::element)
            read_element(line);
        else if (block_ == Block::surface && set_->kind == InputSets::Kind::sides)
            add_side(split(line));
        else if (block_ != Block::other)
            add_members(split(line));
    }

    std::int64_t whole(std::string_view word) const {
        std::int64_t number = 0;
        if (parse(word, number) != Parsed::number)
            scan_.malformed("found " + quoted(word) + " in place of a whole number");
        return number;
    }

    void read_node(const std::vector<std::string_view> &words) {
        if (elements_open_)
            scan_.fail(Fault::unsupported,
                       "nodes come behind elements: write all nodes first, and one part alone");
        std::array<double, 3> p{};
        if (words.size() < 3) // Abaqus gives 0 to what is not there, which is more often a mistake
            scan_.malformed("a node has fewer than two coordinates");
        for (std::size_t k = 0; k < 3 && k + 1 < words.size(); ++k)
            if (!words[k + 1].empty() && parse(words[k + 1], p[k]) != Parsed::number)
                scan_.malformed("found " + quoted(words[k + 1]) + " in place of a number");
        const std::int64_t tag = whole(words[0]);
        nodes_.add(tag);
        if (set_ != nullptr)
            set_->ranges.push_back({tag, tag, 1});
        add_vertex(scan_, mesh_, p[0], p[1], p[2]);
    }

    void read_element(std::string_view line) {
        std::vector<std::string_view> words = split(line);
        while (words.size() <= n_nodes_ && line.ends_with(',')) {
            line = scan_.at_end() ? std::string_view() : scan_.line();
            const std::vector<std::string_view> more = split(line);
            words.insert(words.end(), more.begin(), more.end());
        }
        if (words.size() != n_nodes_ + 1)
            scan_.malformed("an element has " + std::to_string(words.size()) + " numbers, not " +
                            std::to_string(n_nodes_ + 1));
        const std::int64_t tag = whole(words[0]);
        std::array<std::int32_t, 4> corners{-1, -1, -1, -1};
        for (std::size_t k = 0; k < n_nodes_; ++k) {
            corners[k] = nodes_.find(whole(words[k + 1]));
            if (corners[k] < 0)
                scan_.fail(Fault::range, "element " + std::to_string(tag) + " has node " +
                                             std::string(words[k + 1]) + ", which is not in the file");
        }
        elements_.add(tag);
        if (set_ != nullptr)
            set_->ranges.push_back({tag, tag, 1});
        element_faces_.push_back(
            {corners, n_nodes_ == 2 ? -1 : static_cast<std::int32_t>(mesh_.faces.size() / 4)});
        if (n_nodes_ > 2)
            mesh_.faces.insert(mesh_.faces.end(), corners.begin(), corners.end());
    }

    // "PART-1.SET" is SET.
    static std::string_view without_instance(std::string_view word) {
        const std::size_t dot = word.rfind('.');
        return dot == std::string_view::npos ? word : word.substr(dot + 1);
    }

    void add_members(const std::vector<std::string_view> &words) {
        if (generate_) {
            if (words.size() < 2)
                scan_.malformed("a range has a first and a last number");
            const std::int64_t step = words.size() > 2 && !words[2].empty() ? whole(words[2]) : 1;
            if (step < 1)
                scan_.malformed("steps of a range are not above 0");
            set_->ranges.push_back({whole(words[0]), whole(words[1]), step});
            return;
        }
        for (const std::string_view word : words) {
            const std::string_view member = without_instance(word);
            if (std::int64_t tag = 0; parse(member, tag) == Parsed::number)
                set_->ranges.push_back({tag, tag, 1});
            else if (!member.empty())
                set_->sets.emplace_back(member);
        }
    }

    // "7, S2", "SET, E1" or of whole faces "SET, SPOS".
    void add_side(const std::vector<std::string_view> &words) {
        const std::string_view member = without_instance(words[0]);
        const std::string_view side = words.size() > 1 ? words[1] : std::string_view();
        InputSets::Side added;
        if (parse(member, added.tag) != Parsed::number)
            added.set = member;
        const bool numbered =
            side.size() == 2 && (side[0] == 'S' || side[0] == 's' || side[0] == 'E' || side[0] == 'e');
        if (numbered && side[1] >= '1' && side[1] <= '4')
            added.side = side[1] - '1';
        else if (!side.empty() && !same_word(side, "SPOS") && !same_word(side, "SNEG"))
            scan_.malformed(quoted(side) + " is no side of a triangle or quadrilateral");
        set_->sides.push_back(std::move(added));
    }

    Scanner scan_;
    Block block_ = Block::other;
    bool generate_ = false, elements_open_ = false;
    std::size_t n_nodes_ = 0; // of elements to come
    InputSets sets_;
    InputSets::Set *set_ = nullptr; // that what comes is added to
    Tags nodes_, elements_;
    std::vector<InputSets::Element> element_faces_;
    Arrays mesh_;
};

} // namespace

Arrays parse_inp(std::string_view bytes) { return Reader(bytes).read(); }

} // namespace alphamst::io
