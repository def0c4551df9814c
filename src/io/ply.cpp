// PLY (Turk 1994): ASCII and binary of both byte orders; reads the vertices and
// the vertex lists of the faces and passes over everything else.
#include <array>
#include <optional>

#include "io/formats.h"
#include "io/scanner.h"

namespace alphamst::io {
namespace {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class Encoding { ascii, little, big };

struct Property {
    std::string_view name;
    Type type;
    std::optional<Type> list; // the type of the length
};

struct Element {
    std::string_view name;
    std::int64_t count;
    std::vector<Property> properties;
};

constexpr bool real(Type type) { return type == Type::float32 || type == Type::float64; }

constexpr std::size_t size(Type type) {
    constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

Type parse_type(const Scanner &scan, std::string_view word) {
    constexpr std::array<std::array<std::string_view, 2>, 8> names{{{"char", "int8"},
                                                                    {"uchar", "uint8"},
                                                                    {"short", "int16"},
                                                                    {"ushort", "uint16"},
                                                                    {"int", "int32"},
                                                                    {"uint", "uint32"},
                                                                    {"float", "float32"},
                                                                    {"double", "float64"}}};
    for (std::size_t i = 0; i < names.size(); ++i)
        if (word == names[i][0] || word == names[i][1])
            return static_cast<Type>(i);
    scan.malformed(quoted(word) + " is not a type of PLY");
}

Encoding parse_encoding(Scanner &scan) {
    const std::string_view word = scan.word();
    if (word == "ascii")
        return Encoding::ascii;
    if (word == "binary_little_endian")
        return Encoding::little;
    if (word == "binary_big_endian")
        return Encoding::big;
    scan.malformed(quoted(word) + " is not an encoding of PLY");
}

Property parse_property(Scanner &scan) {
    Property property{};
    std::string_view word = scan.word();
    if (word == "list") {
        property.list = parse_type(scan, scan.word());
        if (real(*property.list))
            scan.malformed("the length of a list is not a whole number");
        word = scan.word();
    }
    property.type = parse_type(scan, word);
    property.name = scan.word();
    return property;
}

std::vector<Element> parse_header(Scanner &scan, Encoding &encoding) {
    if (scan.line() != "ply")
        scan.malformed("the file does not begin with ply");
    std::vector<Element> elements;
    bool encoded = false;
    for (;;) {
        const std::string_view keyword = scan.word();
        if (keyword == "format") {
            encoding = parse_encoding(scan);
            encoded = true;
        } else if (keyword == "element") {
            const std::string_view name = scan.word();
            for (const Element &other : elements)
                if (other.name == name)
                    scan.malformed("the element " + quoted(name) + " comes twice");
            elements.push_back({name, scan.count("elements", 1), {}});
        } else if (keyword == "property") {
            if (elements.empty())
                scan.malformed("a property comes before the first element");
            elements.back().properties.push_back(parse_property(scan));
        } else if (keyword != "comment" && keyword != "obj_info" && keyword != "end_header") {
            scan.malformed(quoted(keyword) + " is not a keyword of PLY");
        }
        scan.line();
        if (keyword == "end_header")
            break;
    }
    if (!encoded)
        scan.malformed("the header does not say its format");
    return elements;
}

// The values behind the header, in the encoding of the file.
class Values {
public:
    Values(Scanner &scan, Encoding encoding) : scan_(scan), encoding_(encoding) {}

    double real(Type type) {
        if (encoding_ == Encoding::ascii)
            return scan_.real();
        const char *bytes = scan_.take(size(type)).data();
        const bool big = encoding_ == Encoding::big;
        if (type == Type::float32)
            return static_cast<double>(decode<float>(bytes, big));
        if (type == Type::float64)
            return decode<double>(bytes, big);
        return static_cast<double>(whole(type, bytes));
    }

    std::int64_t integer(Type type) {
        return encoding_ == Encoding::ascii ? scan_.integer() : whole(type, scan_.take(size(type)).data());
    }

    void skip(Type type, std::int64_t n) {
        scan_.expect(n, "values", least(type));
        if (encoding_ != Encoding::ascii)
            scan_.take(static_cast<std::size_t>(n) * size(type));
        else
            for (; n > 0; --n)
                scan_.word();
    }

    void skip(const Property &property) { skip(property.type, property.list ? integer(*property.list) : 1); }

    // The fewest bytes a value can take.
    std::size_t least(Type type) const { return encoding_ == Encoding::ascii ? 2 : size(type); }

private:
    std::int64_t whole(Type type, const char *bytes) const {
        const bool big = encoding_ == Encoding::big;
        switch (type) {
        case Type::int8:
            return decode<std::int8_t>(bytes, big);
        case Type::uint8:
            return decode<std::uint8_t>(bytes, big);
        case Type::int16:
            return decode<std::int16_t>(bytes, big);
        case Type::uint16:
            return decode<std::uint16_t>(bytes, big);
        case Type::int32:
            return decode<std::int32_t>(bytes, big);
        default:
            return decode<std::uint32_t>(bytes, big);
        }
    }

    Scanner &scan_;
    Encoding encoding_;
};

void read_vertices(const Scanner &scan, Values &values, const Element &element, Arrays &mesh) {
    constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
    std::array<int, 3> seen{};
    for (const Property &property : element.properties)
        for (std::size_t axis = 0; axis < 3; ++axis)
            seen[axis] += property.name == axes[axis] && !property.list;
    if (element.count > 0 && seen != std::array{1, 1, 1})
        scan.malformed("the element vertex does not have x, y and z once each");
    mesh.points.reserve(static_cast<std::size_t>(element.count) * 3);
    for (std::int64_t v = 0; v < element.count; ++v) {
        std::array<double, 3> p{};
        for (const Property &property : element.properties) {
            std::size_t axis = 0;
            while (axis < 3 && (property.list || property.name != axes[axis]))
                ++axis;
            if (axis < 3)
                p[axis] = values.real(property.type);
            else
                values.skip(property);
        }
        add_vertex(scan, mesh, p[0], p[1], p[2]);
    }
}

void read_faces(const Scanner &scan, Values &values, const Element &element, std::int64_t n_vertices,
                Arrays &mesh) {
    const auto is_corners = [](const Property &property) {
        return property.list && (property.name == "vertex_indices" || property.name == "vertex_index");
    };
    int lists = 0;
    for (const Property &property : element.properties) {
        lists += is_corners(property);
        if (is_corners(property) && real(property.type))
            scan.malformed("the vertices of the faces are not whole numbers");
    }
    if (element.count > 0 && lists != 1)
        scan.malformed("the element face does not have one list vertex_indices");
    for (std::int64_t f = 0; f < element.count; ++f)
        for (const Property &property : element.properties) {
            if (!is_corners(property)) {
                values.skip(property);
                continue;
            }
            const std::size_t n = need_corners(scan, mesh, values.integer(*property.list));
            std::int32_t face[4] = {-1, -1, -1, -1};
            for (std::size_t k = 0; k < n; ++k)
                face[k] = corner(scan, mesh, values.integer(property.type), n_vertices, 0);
            mesh.faces.insert(mesh.faces.end(), face, face + 4);
        }
}

} // namespace

Arrays parse_ply(std::string_view bytes) {
    Scanner scan(bytes);
    Encoding encoding = Encoding::ascii;
    const std::vector<Element> elements = parse_header(scan, encoding);
    Values values(scan, encoding);
    std::int64_t n_vertices = 0;
    for (const Element &element : elements)
        if (element.name == "vertex")
            n_vertices = element.count;
    Arrays mesh;
    for (const Element &element : elements) {
        std::size_t least = 0;
        for (const Property &property : element.properties)
            least += values.least(property.list.value_or(property.type));
        if (least == 0)
            least = 1;
        scan.expect(element.count, quoted(element.name), least);
        if (element.name == "vertex")
            read_vertices(scan, values, element, mesh);
        else if (element.name == "face")
            read_faces(scan, values, element, n_vertices, mesh);
        else if (element.name == "tristrips" && element.count > 0)
            scan.fail(Fault::not_quad, "face {} is in a strip of triangles; write single triangles",
                      Entity::face, {static_cast<std::int64_t>(mesh.faces.size() / 4)});
        else
            for (std::int64_t i = 0; i < element.count; ++i)
                for (const Property &property : element.properties)
                    values.skip(property);
    }
    if (encoding == Encoding::ascii && !scan.at_end())
        scan.malformed("after the last element comes " + quoted(scan.word()));
    return finished(std::move(mesh));
}

std::string print_ply(const Arrays &mesh) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(mesh.points.size() / 3) +
                       "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                       std::to_string(mesh.faces.size() / 4) +
                       "\nproperty list uchar int vertex_indices\nend_header\n";
    append_points(text, mesh, "");
    append_faces(text, mesh, "4 ", 0);
    return text;
}

} // namespace alphamst::io
