// Reads Gmsh's MSH (Geuzaine and Remacle 2009): 1, 2.x, 4.0 and 4.1 in ASCII, 2.x and 4.1 in
// binary. Lines become marked edges, points marked points. A marker is the physical tag; lines have the tags
// of their curves if none has another one, so that outlines of a model without physical groups keep their
// numbers.
#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "io/formats.h"
#include "io/markers.h"
#include "io/msh_groups.h"
#include "io/msh_numbers.h"
#include "io/number.h"
#include "io/scanner.h"
#include "io/tags.h"

namespace alphamst::io {
namespace {

// Element types of Gmsh's reference manual.
constexpr std::int64_t line_type = 1, triangle_type = 2, quad_type = 3, point_type = 15;

// Of any order.
bool is_line(std::int64_t type) { return type == line_type || type == 8 || (type >= 26 && type <= 28); }

// Behind the ends of a line.
std::int64_t inner_nodes_of_line(std::int64_t type) {
    return type == line_type ? 0 : type == 8 ? 1 : type - 24;
}

// 0: of no interest.
std::int64_t nodes_of(std::int64_t type) {
    switch (type) {
    case line_type:
        return 2;
    case triangle_type:
        return 3;
    case quad_type:
        return 4;
    case point_type:
        return 1;
    default:
        return 0;
    }
}

class Reader {
public:
    explicit Reader(std::string_view bytes) : scan_(bytes) {}

    Arrays read() {
        read_version();
        while (!scan_.at_end()) {
            const std::string_view section = scan_.word();
            if (section == "$PhysicalNames")
                read_groups(section, &PhysicalGroups::read_names, scan_);
            else if (section == "$Entities" && major_ == 4)
                read_groups(section, &PhysicalGroups::read_entities, numbers_);
            else if (section == "$PartitionedEntities" && major_ == 4)
                read_groups(section, &PhysicalGroups::read_partitions, numbers_);
            else if (section == names().nodes)
                major_ == 4 ? read_nodes_4() : read_nodes_2();
            else if (section == names().elements)
                read_elements();
            else
                skip(section);
        }
        if (!nodes_ || !elements_)
            scan_.malformed("the file has no section " +
                            std::string(nodes_ ? names().elements : names().nodes));
        mesh_.names = groups_.names();
        if (mesh_.marked_edges.empty()) {
            mesh_.marked_edges = std::move(curves_);
            mesh_.curve_numbers = !mesh_.marked_edges.empty();
        }
        settle_markers(mesh_, [this](std::int32_t vertex) { return numbering_.tag_of(vertex); });
        return finished(std::move(mesh_));
    }

private:
    struct Names {
        std::string_view nodes, end_nodes, elements, end_elements;
    };
    const Names &names() const {
        static constexpr Names first{"$NOD", "$ENDNOD", "$ELM", "$ENDELM"},
            later{"$Nodes", "$EndNodes", "$Elements", "$EndElements"};
        return major_ == 1 ? first : later;
    }

    void expect_word(std::string_view expected) {
        const std::string_view word = scan_.word();
        if (word != expected)
            scan_.malformed("found " + quoted(word) + " in place of " + std::string(expected));
    }

    void read_version() {
        // Version 1 does not name itself: it begins with its nodes.
        if (!scan_.at_end() && scan_.ahead("$NOD")) {
            major_ = 1;
            return;
        }
        const std::string_view first = scan_.word();
        if (first != "$MeshFormat")
            scan_.malformed("found " + quoted(first) + " in place of $MeshFormat: this is no mesh of Gmsh");
        const std::string_view version = scan_.word();
        double value = 0;
        if (parse(version, value) != Parsed::number)
            scan_.malformed("found " + quoted(version) + " in place of a version");
        major_ = value == 4 || value == 4.1 ? 4 : 2;
        old_ = groups_.points_have_boxes = value == 4;
        if (major_ == 2 && !(value >= 2 && value < 3))
            scan_.fail(Fault::unsupported,
                       "MSH " + quoted(version) +
                           " is not read, only 1, 2.x, 4.0 and 4.1: save it as one of these");
        read_encoding(version);
        expect_word("$EndMeshFormat");
    }

    void read_encoding(std::string_view version) {
        const std::int64_t binary = scan_.integer();
        if (binary != 0 && binary != 1)
            scan_.malformed("the file is said to be neither ASCII, 0, nor binary, 1");
        if (binary == 1 && old_)
            scan_.fail(Fault::unsupported,
                       "MSH " + quoted(version) + " is not read in binary; save it as ASCII, or as 4.1");
        if (binary == 1 && scan_.integer() != 8)
            scan_.fail(Fault::unsupported, "numbers are not 8 bytes wide in the file; save it as ASCII");
        scan_.line();
        if (binary == 1)
            numbers_.begin_binary();
    }

    void skip(std::string_view section) {
        if (section.size() < 2 || section[0] != '$' || same_word(section.substr(0, 4), "$End"))
            scan_.malformed("found " + quoted(section) + " in place of a section");
        const std::string end = "$End" + std::string(section.substr(1));
        scan_.line();
        while (!scan_.at_end())
            if (same_word(scan_.line(), end)) // $ENDVIEW in version 1
                return;
        scan_.malformed("the section " + quoted(section) + " has no end");
    }

    template <class From>
    void read_groups(std::string_view section, void (PhysicalGroups::*read)(From &), From &from) {
        (groups_.*read)(from);
        expect_word("$End" + std::string(section.substr(1)));
    }

    void read_node() {
        const double x = numbers_.real(), y = numbers_.real(), z = numbers_.real();
        add_vertex(scan_, mesh_, x, y, z);
    }

    void begin_nodes() {
        if (nodes_)
            scan_.malformed("the section " + std::string(names().nodes) + " comes twice");
        nodes_ = true;
    }

    void end_nodes() {
        expect_word(names().end_nodes);
        if (!numbering_.close())
            scan_.malformed("two nodes have the same number");
    }

    void read_nodes_2() {
        begin_nodes();
        const std::int64_t n = scan_.integer();
        numbers_.begin();
        numbers_.expect(n, "nodes", 8, 28);
        mesh_.points.reserve(static_cast<std::size_t>(n) * 3);
        for (std::int64_t i = 0; i < n; ++i) {
            numbering_.add(numbers_.integer());
            read_node();
        }
        end_nodes();
    }

    // Behind the numbers of blocks and of nodes or elements: the least tag and the largest.
    void skip_range() {
        for (int k = 0; numbers_.binary() && k < 2; ++k)
            numbers_.long_integer();
        numbers_.end_line();
    }

    void read_nodes_4() {
        begin_nodes();
        numbers_.begin();
        const std::int64_t n_blocks = numbers_.count("blocks of nodes", 8, 20),
                           n = numbers_.count("nodes", 8, 32);
        mesh_.points.reserve(static_cast<std::size_t>(n) * 3);
        skip_range();
        std::int64_t n_read = 0;
        for (std::int64_t block = 0; block < n_blocks; ++block)
            n_read += read_block_of_nodes();
        if (n_read != n)
            scan_.malformed(std::to_string(n) + " nodes are promised, but the blocks have " +
                            std::to_string(n_read));
        end_nodes();
    }

    std::int64_t read_block_of_nodes() {
        const std::int64_t dim = numbers_.integer();
        numbers_.integer(); // the entity
        const bool parametric = numbers_.integer() != 0;
        const std::int64_t size = numbers_.count("nodes", 8, 32);
        for (std::int64_t i = 0; i < size && !old_; ++i)
            numbering_.add(numbers_.long_integer());
        for (std::int64_t i = 0; i < size; ++i) {
            if (old_) // each in front of its coordinates
                numbering_.add(scan_.integer());
            read_node();
            // Parameters on the curve or surface may follow.
            for (std::int64_t k = 0; numbers_.binary() && parametric && k < dim; ++k)
                numbers_.real();
            numbers_.end_line();
        }
        return size;
    }

    // The number of a node or an element.
    std::int64_t tag() { return major_ == 4 ? numbers_.long_integer() : numbers_.integer(); }

    std::int32_t node(const char *of) {
        const std::int64_t number = tag();
        const std::int32_t vertex = numbering_.find(number);
        if (vertex >= 0)
            return vertex;
        const std::string text = " has node " + std::to_string(number) + ", which is not in the file";
        if (of != nullptr)
            scan_.fail(Fault::range, of + text);
        scan_.fail(Fault::range, "face {}" + text, Entity::face, {n_faces()});
    }

    std::int64_t n_faces() const { return static_cast<std::int64_t>(mesh_.faces.size() / 4); }

    // The nodes of an element, from its first node to the end of its line. groups: those it is in;
    // curve: that of a line.
    void read_element(std::int64_t type, std::span<const std::int32_t> groups, std::int64_t curve) {
        if (is_line(type)) {
            const std::int32_t v = node("a line"), w = node("a line");
            for (const std::int32_t group : groups)
                mesh_.marked_edges.push_back({{v, w}, group});
            if (const std::int32_t number = small_tag(scan_, curve); groups.empty() && number != 0)
                curves_.push_back({{v, w}, number});
        } else if (type == triangle_type || type == quad_type) {
            std::int32_t face[4] = {-1, -1, -1, -1};
            for (std::int64_t k = 0; k < nodes_of(type); ++k)
                face[k] = node(nullptr);
            for (std::size_t i = 0; i < std::max<std::size_t>(groups.size(), 1); ++i) { // once for each
                mesh_.faces.insert(mesh_.faces.end(), face, face + 4);
                mesh_.face_marker.push_back(groups.empty() ? 0 : groups[i]);
            }
        } else if (type != point_type) {
            scan_.fail(
                Fault::not_quad,
                "face {} is of Gmsh's type " + std::to_string(type) +
                    ", not a triangle or quadrilateral of straight sides; save elements of order 1, and "
                    "surfaces alone",
                Entity::face, {n_faces()});
        } else {
            if (groups.empty()) // any tag will do
                tag();
            else if (const std::int32_t vertex = node("a point"); vertex >= 0)
                for (const std::int32_t group : groups)
                    mesh_.marked_points.push_back({vertex, group});
        }
        if (numbers_.binary()) {
            for (std::int64_t k = is_line(type) ? inner_nodes_of_line(type) : 0; k > 0; --k)
                tag();
            return;
        }
        if ((type == line_type || type == triangle_type || type == quad_type) && !scan_.at_line_end())
            scan_.malformed("an element has too many nodes: " + quoted(scan_.word()));
        scan_.line();
    }

    void read_elements() {
        if (elements_)
            scan_.malformed("the section " + std::string(names().elements) + " comes twice");
        elements_ = true;
        if (major_ == 1)
            read_elements_1();
        else
            major_ == 4 ? read_elements_4() : read_elements_2();
        expect_word(names().end_elements);
    }

    void read_elements_1() {
        const std::int64_t n = scan_.count("elements", 8);
        for (std::int64_t i = 0; i < n; ++i) {
            scan_.integer();
            const std::int64_t type = scan_.integer();
            const std::int32_t group = small_tag(scan_, scan_.integer());
            const std::int64_t curve = scan_.integer();
            const std::int64_t n_nodes = scan_.integer(), n_wanted = nodes_of(type);
            if (n_wanted != 0 && n_nodes != n_wanted)
                scan_.malformed("an element of type " + std::to_string(type) + " has " +
                                std::to_string(n_nodes) + " nodes, not " + std::to_string(n_wanted));
            read_element(type, groups_of(group), curve);
        }
    }

    void read_elements_2() {
        const std::int64_t n = scan_.integer();
        numbers_.begin();
        numbers_.expect(n, "elements", 8, 8);
        for (std::int64_t i = 0; i < n;) {
            if (!numbers_.binary()) {
                scan_.integer();
                const std::int64_t type = scan_.integer();
                read_element_2(type, scan_.count("tags", 2));
                ++i;
                continue;
            }
            const std::int64_t type = numbers_.integer(), size = numbers_.integer(),
                               n_tags = numbers_.integer();
            if (size < 1 || size > n - i)
                scan_.malformed("a block of " + std::to_string(size) + " elements does not fit");
            numbers_.expect(n_tags, "tags", 2, 4);
            for (const std::int64_t end = i + size; i < end; ++i) {
                numbers_.integer();
                read_element_2(type, n_tags);
            }
        }
    }

    void read_element_2(std::int64_t type, std::int64_t n_tags) {
        std::array<std::int64_t, 2> tags{}; // physical, elementary; partitions follow
        for (std::int64_t k = 0; k < n_tags; ++k)
            if (const std::int64_t number = numbers_.integer(); k < 2)
                tags[static_cast<std::size_t>(k)] = number;
        const std::int32_t group = small_tag(scan_, tags[0]);
        read_element(type, groups_of(group), tags[1]);
    }

    void read_elements_4() {
        numbers_.begin();
        const std::int64_t n_blocks = numbers_.count("blocks of elements", 8, 20),
                           n = numbers_.count("elements", 4, 16);
        skip_range();
        std::int64_t n_read = 0;
        for (std::int64_t block = 0; block < n_blocks; ++block) {
            std::int64_t dim = numbers_.integer(), entity = numbers_.integer();
            if (old_)
                std::swap(dim, entity);
            const std::int64_t type = numbers_.integer();
            const std::int64_t size = numbers_.count("elements", 4, 16);
            const std::vector<std::int32_t> groups = groups_.of(dim, entity);
            const std::int64_t curve = groups_.whole_curve(entity);
            for (std::int64_t i = 0; i < size; ++i) {
                tag();
                read_element(type, groups, curve);
            }
            n_read += size;
        }
        if (n_read != n)
            scan_.malformed(std::to_string(n) + " elements are promised, but the blocks have " +
                            std::to_string(n_read));
    }

    // None, or this one, which must outlive the answer.
    static std::span<const std::int32_t> groups_of(const std::int32_t &group) {
        return {&group, group != 0 ? std::size_t{1} : std::size_t{0}};
    }

    Scanner scan_;
    MshNumbers numbers_{scan_};
    int major_ = 2;    // version
    bool old_ = false; // 4.0
    bool nodes_ = false, elements_ = false;
    Tags numbering_;
    PhysicalGroups groups_;
    std::vector<Arrays::MarkedEdge> curves_; // lines in no group, with the tags of their curves
    Arrays mesh_;
};

} // namespace

Arrays parse_msh(std::string_view bytes) { return Reader(bytes).read(); }

} // namespace alphamst::io
