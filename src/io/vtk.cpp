// Legacy VTK (Schroeder, Martin and Lorensen 2006; the layout of cells of version
// 5.1 after Kitware's file format pages): UNSTRUCTURED_GRID and POLYDATA, ASCII
// and binary. Vertices and lines are passed over, and so is everything from the
// first POINT_DATA or CELL_DATA on.
#include <algorithm>
#include <array>
#include <optional>

#include "io/formats.h"
#include "io/number.h"
#include "io/scanner.h"

namespace alphamst::io {
namespace {

enum class Kind { whole, natural, real };

struct Type {
    Kind kind;
    std::size_t size;
};

std::optional<Type> find_type(std::string_view word) {
    struct Named {
        std::string_view name;
        Type type;
    };
    static constexpr std::array<Named, 17> types{{{"char", {Kind::whole, 1}},
                                                  {"signed_char", {Kind::whole, 1}},
                                                  {"unsigned_char", {Kind::natural, 1}},
                                                  {"short", {Kind::whole, 2}},
                                                  {"unsigned_short", {Kind::natural, 2}},
                                                  {"int", {Kind::whole, 4}},
                                                  {"unsigned_int", {Kind::natural, 4}},
                                                  {"long", {Kind::whole, 8}},
                                                  {"unsigned_long", {Kind::natural, 8}},
                                                  {"vtkidtype", {Kind::whole, 4}}, // VTK writes it as int
                                                  {"vtktypeint32", {Kind::whole, 4}},
                                                  {"vtktypeuint32", {Kind::natural, 4}},
                                                  {"vtktypeint64", {Kind::whole, 8}},
                                                  {"vtktypeuint64", {Kind::natural, 8}},
                                                  {"float", {Kind::real, 4}},
                                                  {"double", {Kind::real, 8}},
                                                  {"bit", {Kind::natural, 0}}}};
    for (const Named &named : types)
        if (same_word(named.name, word))
            return named.type;
    return std::nullopt;
}

// Cells as VTK 5.1 has them: cell i has the vertices connectivity[offsets[i] .. offsets[i + 1]).
struct Cells {
    std::vector<std::int64_t> offsets{0}, connectivity;
    std::size_t size() const { return offsets.size() - 1; }
};

// VTK's cell types.
constexpr std::int64_t vertex_cell = 1, poly_line_cell = 4, triangle_cell = 5, polygon_cell = 7,
                       pixel_cell = 8, quad_cell = 9;

class Reader {
public:
    explicit Reader(std::string_view bytes) : scan_(bytes) {}

    Arrays read() {
        read_header();
        while (!scan_.at_end()) {
            const std::string_view keyword = scan_.word();
            if (same_word(keyword, "POINT_DATA") || same_word(keyword, "CELL_DATA"))
                break;
            if (same_word(keyword, "METADATA"))
                skip_metadata();
            else if (same_word(keyword, "FIELD"))
                skip_field();
            else if (same_word(keyword, "POINTS"))
                read_points();
            else if (grid_ ? !read_grid_part(keyword) : !read_polydata_part(keyword))
                scan_.malformed(quoted(keyword) + " is not a keyword of this data set");
        }
        if (!points_)
            scan_.malformed("the file has no POINTS");
        if (!cells_seen_) // cut off, rather than a mesh without any
            scan_.malformed(grid_ ? "the file has no CELLS" : "the file has no POLYGONS, LINES or VERTICES");
        if (grid_)
            add_grid();
        return finished(std::move(mesh_));
    }

private:
    void read_header() {
        if (!same_word(scan_.line().substr(0, 14), "# vtk DataFile"))
            scan_.malformed("the file does not begin with # vtk DataFile");
        scan_.line(); // the title
        const std::string_view encoding = scan_.word();
        binary_ = same_word(encoding, "BINARY");
        if (!binary_ && !same_word(encoding, "ASCII"))
            scan_.malformed("found " + quoted(encoding) + " in place of ASCII or BINARY");
        if (const std::string_view word = scan_.word(); !same_word(word, "DATASET"))
            scan_.malformed("found " + quoted(word) + " in place of DATASET");
        const std::string_view set = scan_.word();
        grid_ = same_word(set, "UNSTRUCTURED_GRID");
        if (!grid_ && !same_word(set, "POLYDATA"))
            scan_.fail(Fault::unsupported, "the data set " + quoted(set) + " is not read");
    }

    Type read_type() {
        const std::string_view word = scan_.word();
        const std::optional<Type> type = find_type(word);
        if (!type)
            scan_.malformed(quoted(word) + " is not a type of VTK");
        return *type;
    }

    std::size_t least(Type type) const { return binary_ ? std::max<std::size_t>(type.size, 1) : 2; }

    // Binary values begin right behind the line that announces them.
    void begin_values() {
        if (binary_)
            scan_.line();
    }

    double real(Type type) {
        if (!binary_)
            return scan_.real();
        if (type.kind != Kind::real)
            return static_cast<double>(integer(type));
        const char *bytes = scan_.take(type.size).data();
        return type.size == 4 ? static_cast<double>(decode<float>(bytes, true)) : decode<double>(bytes, true);
    }

    std::int64_t integer(Type type) {
        if (!binary_)
            return scan_.integer();
        const char *bytes = scan_.take(type.size).data();
        const bool natural = type.kind == Kind::natural;
        switch (type.size) {
        case 1:
            return natural ? std::int64_t{decode<std::uint8_t>(bytes, true)}
                           : decode<std::int8_t>(bytes, true);
        case 2:
            return natural ? std::int64_t{decode<std::uint16_t>(bytes, true)}
                           : decode<std::int16_t>(bytes, true);
        case 4:
            return natural ? std::int64_t{decode<std::uint32_t>(bytes, true)}
                           : decode<std::int32_t>(bytes, true);
        default:
            return decode<std::int64_t>(bytes, true);
        }
    }

    std::vector<std::int64_t> integers(std::int64_t n, Type type) {
        if (type.kind == Kind::real || type.size == 0)
            scan_.malformed("cells are not whole numbers");
        begin_values();
        scan_.expect(n, "numbers", least(type));
        std::vector<std::int64_t> numbers(static_cast<std::size_t>(n));
        for (std::int64_t &i : numbers)
            i = integer(type);
        return numbers;
    }

    // Up to an empty line.
    void skip_metadata() {
        scan_.line();
        while (!scan_.line().empty()) {
        }
    }

    void skip_field() {
        scan_.word(); // its name
        const std::int64_t n_arrays = scan_.count("arrays", 4);
        for (std::int64_t a = 0; a < n_arrays; ++a) {
            if (same_word(scan_.word(), "METADATA")) {
                skip_metadata();
                scan_.word();
            }
            const std::int64_t width = scan_.count("components", 1), length = scan_.count("tuples", 1);
            const std::string_view name = scan_.word();
            const std::optional<Type> type = find_type(name);
            if (!type || type->size == 0)
                scan_.fail(Fault::unsupported, "a field of type " + quoted(name) + " is not read");
            begin_values();
            const std::int64_t n = width * length;
            scan_.expect(n, "values", least(*type));
            if (binary_)
                scan_.take(static_cast<std::size_t>(n) * type->size);
            else
                for (std::int64_t i = 0; i < n; ++i)
                    scan_.word();
        }
    }

    void read_points() {
        if (points_)
            scan_.malformed("POINTS come twice");
        points_ = true;
        const std::int64_t n = scan_.count("points", 3);
        const Type type = read_type();
        if (type.size == 0)
            scan_.malformed("points are not bits");
        begin_values();
        scan_.expect(n, "points", 3 * least(type));
        mesh_.points.reserve(static_cast<std::size_t>(n) * 3);
        for (std::int64_t v = 0; v < n; ++v) {
            const double x = real(type), y = real(type), z = real(type);
            add_vertex(scan_, mesh_, x, y, z);
        }
    }

    // "n size" and then n times "k v1 ... vk", or since 5.1 "n+1 size", OFFSETS, CONNECTIVITY.
    Cells read_cells() {
        cells_seen_ = true;
        const std::int64_t n = scan_.count("cells", 1), size = scan_.count("numbers", 1);
        if (binary_)
            scan_.line();
        else
            scan_.at_end(); // moves to the next word
        if (scan_.ahead("OFFSETS") || scan_.ahead("offsets"))
            return read_offset_cells(n, size);
        scan_.expect(size, "numbers", binary_ ? 4 : 2);
        Cells cells;
        std::int64_t left = size;
        for (std::int64_t i = 0; i < n; ++i) {
            const std::int64_t k = integer({Kind::whole, 4});
            if (k < 0 || k > left - 1)
                scan_.malformed("a cell of " + std::to_string(k) + " vertices does not fit");
            for (std::int64_t j = 0; j < k; ++j)
                cells.connectivity.push_back(integer({Kind::whole, 4}));
            cells.offsets.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
            left -= 1 + k;
        }
        if (left != 0)
            scan_.malformed("the cells have fewer numbers than promised");
        return cells;
    }

    Cells read_offset_cells(std::int64_t n_offsets, std::int64_t size) {
        Cells cells;
        scan_.word();
        cells.offsets = integers(n_offsets, read_type());
        if (const std::string_view word = scan_.word(); !same_word(word, "CONNECTIVITY"))
            scan_.malformed("found " + quoted(word) + " in place of CONNECTIVITY");
        cells.connectivity = integers(size, read_type());
        if (cells.offsets.empty()) // VTK writes no offsets for no cells
            cells.offsets.push_back(0);
        if (cells.offsets.front() != 0 || cells.offsets.back() != size ||
            !std::is_sorted(cells.offsets.begin(), cells.offsets.end()))
            scan_.malformed("the offsets of the cells do not ascend from 0 to the number of their vertices");
        return cells;
    }

    bool read_grid_part(std::string_view keyword) {
        if (same_word(keyword, "CELLS")) {
            cells_ = read_cells();
        } else if (same_word(keyword, "CELL_TYPES")) {
            types_ = integers(scan_.count("cell types", 1), {Kind::whole, 4});
        } else {
            return false;
        }
        return true;
    }

    bool read_polydata_part(std::string_view keyword) {
        if (same_word(keyword, "POLYGONS")) {
            const Cells cells = read_cells();
            for (std::size_t i = 0; i < cells.size(); ++i)
                add_face(cells, i, polygon_cell);
        } else if (same_word(keyword, "TRIANGLE_STRIPS")) {
            if (read_cells().size() > 0)
                scan_.fail(Fault::not_quad, "face {} is in a strip of triangles", Entity::face, {n_faces()});
        } else if (same_word(keyword, "VERTICES") || same_word(keyword, "LINES")) {
            read_cells();
        } else {
            return false;
        }
        return true;
    }

    void add_grid() {
        if (cells_.size() != types_.size())
            scan_.malformed("there are " + std::to_string(cells_.size()) + " CELLS, but " +
                            std::to_string(types_.size()) + " CELL_TYPES");
        for (std::size_t i = 0; i < types_.size(); ++i)
            if (types_[i] < vertex_cell || types_[i] > poly_line_cell)
                add_face(cells_, i, types_[i]);
    }

    void add_face(const Cells &cells, std::size_t i, std::int64_t type) {
        const std::int64_t first = cells.offsets[i], n = cells.offsets[i + 1] - first;
        if (type == triangle_cell || (type >= polygon_cell && type <= quad_cell))
            need_quad(scan_, mesh_, type == triangle_cell ? 3 : n);
        else
            scan_.fail(Fault::not_quad,
                       "face {} is of VTK's cell type " + std::to_string(type) + ", not a quadrilateral",
                       Entity::face, {n_faces()});
        std::array<std::int32_t, 4> quad{};
        const auto n_vertices = static_cast<std::int64_t>(mesh_.points.size() / 3);
        for (std::size_t k = 0; k < 4; ++k)
            quad[k] =
                corner(scan_, mesh_, cells.connectivity[static_cast<std::size_t>(first) + k], n_vertices, 0);
        if (type == pixel_cell)
            std::swap(quad[2], quad[3]);
        mesh_.faces.insert(mesh_.faces.end(), quad.begin(), quad.end());
    }

    std::int64_t n_faces() const { return static_cast<std::int64_t>(mesh_.faces.size() / 4); }

    Scanner scan_;
    bool binary_ = false, grid_ = false, points_ = false, cells_seen_ = false;
    Cells cells_;
    std::vector<std::int64_t> types_;
    Arrays mesh_;
};

} // namespace

Arrays parse_vtk(std::string_view bytes) { return Reader(bytes).read(); }

std::string print_vtk(const Arrays &mesh) {
    const std::string n = std::to_string(mesh.faces.size() / 4);
    std::string text =
        "# vtk DataFile Version 3.0\nquadrilateral mesh\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " +
        std::to_string(mesh.points.size() / 3) + " double\n";
    append_points(text, mesh, "");
    text += "CELLS " + n + " " + std::to_string(mesh.faces.size() / 4 * 5) + "\n";
    append_faces(text, mesh, "4 ", 0);
    text += "CELL_TYPES " + n + "\n";
    for (std::size_t f = 0; f < mesh.faces.size() / 4; ++f)
        text += "9\n";
    return text;
}

} // namespace alphamst::io
