// The native mesh format of SU2 (Economon et al. 2016; the page "Mesh File" of its manual):
// keywords in any order and case, each with a value behind "=", points and elements
// on lines of their own. The k-th marker is the number k of its edges, its tag the name
// of that. Points and elements are numbered by their order from 0, as SU2 itself does;
// numbers at the ends of their lines are passed over, and so are keywords that are not
// of the mesh, with what follows them.
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "io/formats.h"
#include "io/markers.h"
#include "io/number.h"
#include "io/scanner.h"

namespace alphamst::io {
namespace {

// VTK's cell types.
constexpr std::int64_t vertex_cell = 1, line_cell = 3, triangle_cell = 5, quad_cell = 9;

std::string_view first_word(std::string_view text) {
    constexpr std::string_view blanks = " \t\v\f";
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    return text.substr(0, text.find_first_of(blanks));
}

class Reader {
public:
    explicit Reader(std::string_view bytes) : scan_(bytes, '%') {}

    Arrays read() {
        find_sections();
        read_points(*points_);
        read_elements(*elements_);
        for (const Section &marker : markers_)
            read_marker(marker);
        settle_markers(mesh_, [](std::int32_t vertex) { return vertex; });
        return finished(std::move(mesh_));
    }

private:
    struct Section {
        Scanner scan; // behind the line of the keyword
        std::int64_t size;
    };

    // Elements mostly come before the points they name, so nothing is read until all is found.
    void find_sections() {
        while (!scan_.at_end()) {
            const std::string_view line = scan_.line();
            const std::string_view text = line.substr(0, line.find('%'));
            if (const std::size_t equals = text.find('='); equals != std::string_view::npos)
                note(first_word(text.substr(0, equals)), first_word(text.substr(equals + 1)));
        }
        if (!dim_ || !elements_ || !points_ || !promised_markers_) // SU2 wants all of them, too
            scan_.malformed(!dim_        ? "the file has no NDIME="
                            : !elements_ ? "the file has no NELEM="
                            : !points_   ? "the file has no NPOIN="
                                         : "the file has no NMARK=");
        const auto n_markers = static_cast<std::int64_t>(markers_.size());
        if (n_markers != *promised_markers_)
            scan_.malformed(std::to_string(*promised_markers_) + " markers are promised, but the file has " +
                            std::to_string(n_markers));
    }

    void note(std::string_view keyword, std::string_view value) {
        if (same_word(keyword, "NDIME"))
            once(dim_, keyword, whole(value));
        else if (same_word(keyword, "NPOIN")) // the points of a part without its halo may follow
            once(points_, keyword, Section{scan_, whole(value)});
        else if (same_word(keyword, "NELEM"))
            once(elements_, keyword, Section{scan_, whole(value)});
        else if (same_word(keyword, "NMARK"))
            once(promised_markers_, keyword, whole(value));
        else if (same_word(keyword, "MARKER_TAG"))
            tag_ = value;
        else if (same_word(keyword, "MARKER_ELEMS"))
            add_marker(value);
        else if (same_word(keyword, "NZONE") && whole(value) != 1)
            scan_.fail(Fault::unsupported, "a file of " + quoted(value) + " zones is not read, only of one");
        if (dim_ && *dim_ != 2 && *dim_ != 3)
            scan_.malformed("points of " + std::to_string(*dim_) + " dimensions cannot be");
    }

    void add_marker(std::string_view size) {
        markers_.push_back({scan_, whole(size)});
        const auto number = static_cast<std::int32_t>(markers_.size());
        if (const std::string_view tag = std::exchange(tag_, {}); !tag.empty())
            mesh_.names[{Entity::edge, number}] = clean_name(tag);
    }

    template <class Value> void once(std::optional<Value> &place, std::string_view keyword, Value value) {
        if (place)
            scan_.malformed(quoted(keyword) + " comes twice");
        place.emplace(std::move(value));
    }

    std::int64_t whole(std::string_view value) const {
        std::int64_t number = 0;
        if (parse(value, number) != Parsed::number)
            scan_.malformed("found " + quoted(value) + " in place of a whole number");
        return number;
    }

    void read_points(Section section) {
        Scanner &scan = section.scan;
        const bool planar = *dim_ == 2;
        scan.expect(section.size, "points", planar ? 4 : 6); // "0 0\n"
        mesh_.points.reserve(static_cast<std::size_t>(section.size) * 3);
        for (std::int64_t i = 0; i < section.size; ++i) {
            const double x = scan.real(), y = same_line(scan).real();
            add_vertex(scan, mesh_, x, y, planar ? 0 : same_line(scan).real());
            end_line(scan);
        }
        end_section(section, "points");
    }

    void read_elements(Section section) {
        Scanner &scan = section.scan;
        scan.expect(section.size, "elements", 4);
        for (std::int64_t i = 0; i < section.size; ++i) {
            const std::int64_t type = scan.integer();
            if (type != triangle_cell && type != quad_cell)
                scan.fail(Fault::not_quad,
                          "face {} is of VTK's type " + std::to_string(type) +
                              ", not a triangle or quadrilateral; leave such elements out, or write their "
                              "surface",
                          Entity::face, {i});
            std::int32_t face[4] = {-1, -1, -1, -1};
            for (std::size_t k = 0; k < (type == triangle_cell ? 3 : 4); ++k)
                face[k] = corner(scan, mesh_, same_line(scan).integer(), n_points(), 0);
            mesh_.faces.insert(mesh_.faces.end(), face, face + 4);
            end_line(scan);
        }
        end_section(section, "elements");
    }

    void read_marker(Section section) {
        Scanner &scan = section.scan;
        const auto number = static_cast<std::int32_t>(++n_markers_read_);
        skip_destination(scan, number);
        scan.expect(section.size, "elements of a marker", 4);
        for (std::int64_t i = 0; i < section.size; ++i) {
            const std::int64_t type = scan.integer();
            if (type == line_cell) {
                const std::int32_t v = end_of_line_cell(scan), w = end_of_line_cell(scan);
                mesh_.marked_edges.push_back({{v, w}, number});
            } else if (type != vertex_cell) {
                scan.malformed("a marker has an element of VTK's type " + std::to_string(type) +
                               ", not a line");
            }
            end_line(scan);
        }
        end_section(section, "elements of a marker");
    }

    // Of old, the other side of a periodic boundary or the part of a mesh that has it stands there.
    void skip_destination(Scanner &scan, std::int32_t marker) {
        Scanner ahead = scan;
        if (ahead.at_end())
            return;
        const std::string_view line = ahead.line(), word = first_word(line.substr(0, line.find('=')));
        if (!same_word(word, "SEND_RECV") && !same_word(word, "SEND_TO"))
            return;
        scan = ahead;
        mesh_.remarks.push_back("marker " + std::to_string(marker) + " has " + std::string(word) +
                                "=, which is not kept");
    }

    std::int32_t end_of_line_cell(Scanner &scan) {
        const std::int64_t point = same_line(scan).integer();
        if (point < 0 || point >= n_points())
            scan.fail(Fault::range, "a line of a marker has point " + std::to_string(point) +
                                        " of the file, which has " + std::to_string(n_points()) +
                                        " points counted from 0");
        return static_cast<std::int32_t>(point);
    }

    std::int64_t n_points() const { return points_->size; }

    static Scanner &same_line(Scanner &scan) {
        if (scan.at_line_end())
            scan.malformed("the line has too few numbers");
        return scan;
    }

    // The number of the point or element may follow, and in a part of a mesh one more.
    static void end_line(Scanner &scan) {
        for (int k = 0; k < 2 && !scan.at_line_end(); ++k)
            scan.integer();
        if (!scan.at_line_end())
            scan.malformed("the line has too many numbers: " + quoted(scan.word()));
    }

    // Other text may follow, but not one line more of the same kind.
    static void end_section(Section section, std::string_view things) {
        if (section.scan.at_end())
            return;
        double number = 0;
        if (const std::string_view word = section.scan.word(); parse(word, number) != Parsed::malformed)
            section.scan.malformed("after the " + std::to_string(section.size) + " promised " +
                                   std::string(things) + " comes " + quoted(word));
    }

    Scanner scan_;
    std::optional<std::int64_t> dim_, promised_markers_;
    std::optional<Section> points_, elements_;
    std::vector<Section> markers_;
    std::string_view tag_; // of the marker to come
    std::int64_t n_markers_read_ = 0;
    Arrays mesh_;
};

// What the file and the configuration of SU2 take for one word.
std::string word_of(const std::string &name) {
    std::string word = name;
    for (char &c : word)
        if (std::string_view(" %=,()").find(c) != std::string_view::npos)
            c = '_';
    return word;
}

// A tag for each marker of edges, all different: its name, or its number.
std::map<std::int32_t, std::string> tags_of(const Arrays &mesh) {
    std::map<std::int32_t, std::string> tags;
    for (const Arrays::MarkedEdge &edge : mesh.marked_edges)
        if (edge.marker != 0)
            tags[edge.marker];
    std::set<std::string> taken;
    for (auto &[marker, tag] : tags) {
        const auto name = mesh.names.find({Entity::edge, marker});
        const std::string number = std::to_string(marker);
        tag = name == mesh.names.end() ? number : word_of(name->second);
        while (!taken.insert(tag).second)
            tag += "_" + number;
    }
    return tags;
}

} // namespace

Arrays parse_su2(std::string_view bytes) { return Reader(bytes).read(); }

std::string print_su2(const Arrays &mesh) {
    const bool planar = mesh.dim == 2;
    std::string text =
        "NDIME= " + std::to_string(mesh.dim) + "\nNELEM= " + std::to_string(mesh.faces.size() / 4) + "\n";
    append_faces(text, mesh, "9 ", 0);
    text += "NPOIN= " + std::to_string(mesh.points.size() / 3) + "\n";
    for (std::size_t i = 0; i + 2 < mesh.points.size(); i += 3)
        for (std::size_t k = 0; k < (planar ? 2 : 3); ++k) {
            append_number(text, mesh.points[i + k]);
            text += k + 1 < (planar ? 2 : 3) ? ' ' : '\n';
        }
    const std::map<std::int32_t, std::string> tags = tags_of(mesh);
    std::map<std::int32_t, std::string> lines;
    std::map<std::int32_t, std::int64_t> n_lines;
    for (const auto &[vertices, marker] : mesh.marked_edges) {
        ++n_lines[marker];
        lines[marker] += "3 " + std::to_string(vertices[0]) + " " + std::to_string(vertices[1]) + "\n";
    }
    text += "NMARK= " + std::to_string(tags.size()) + "\n";
    for (const auto &[marker, tag] : tags)
        text += "MARKER_TAG= " + tag + "\nMARKER_ELEMS= " + std::to_string(n_lines[marker]) + "\n" +
                lines[marker];
    return text;
}

} // namespace alphamst::io
