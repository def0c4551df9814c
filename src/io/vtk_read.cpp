// Reads legacy VTK (Schroeder, Martin and Lorensen 2006; the layout of cells of version
// 5.1 after Kitware's file format pages): UNSTRUCTURED_GRID and POLYDATA, ASCII
// and binary. Data of the cells in whole numbers that have one of some names are the markers of
// faces, lines and vertex cells; other data are fields. Cells without a marker are passed over.
#include <algorithm>
#include <array>
#include <optional>

#include "index.h"
#include "io/formats.h"
#include "io/scanner.h"
#include "io/vtk.h"
#include "io/vtk_cells.h"
#include "io/vtk_values.h"

namespace alphamst::io {
namespace {

using namespace vtk;

// VTK writes blanks and the like in names as %20.
std::string decoded(std::string_view name) {
    const auto digit = [](char c) {
        constexpr std::string_view digits = "0123456789abcdefABCDEF";
        const std::size_t place = digits.find(c);
        return place < 16              ? static_cast<int>(place)
               : place < digits.size() ? static_cast<int>(place) - 6
                                       : -1;
    };
    std::string text;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const int high = name[i] == '%' && i + 2 < name.size() ? digit(name[i + 1]) : -1;
        const int low = high < 0 ? -1 : digit(name[i + 2]);
        text += low < 0 ? name[i] : static_cast<char>(16 * high + low);
        i += low < 0 ? 0 : 2;
    }
    return text;
}

class Reader {
public:
    explicit Reader(std::string_view bytes) : scan_(bytes) {}

    Arrays read() {
        read_header();
        while (!scan_.at_end()) {
            const std::string_view keyword = scan_.word();
            if (is_attributes(keyword)) {
                read_attributes(keyword);
                break;
            }
            if (same_word(keyword, "METADATA"))
                skip_metadata();
            else if (same_word(keyword, "FIELD")) {
                if (!read_field(data_.of_all))
                    scan_.fail(Fault::unsupported, "a field of this type is not read");
            } else if (same_word(keyword, "POINTS"))
                read_points();
            else if (grid_ ? !read_grid_part(keyword) : !read_polydata_part(keyword))
                scan_.malformed(quoted(keyword) + " is not a keyword of this data set");
        }
        if (!points_)
            scan_.malformed("the file has no POINTS");
        if (!cells_seen_) // cut off, rather than a mesh without any
            scan_.malformed(grid_ ? "the file has no CELLS" : "the file has no POLYGONS, LINES or VERTICES");
        if (!grid_)
            gather_polydata();
        add_data_set(scan_, std::move(data_), mesh_);
        return finished(std::move(mesh_));
    }

private:
    void read_header() {
        if (!same_word(scan_.line().substr(0, 14), "# vtk DataFile"))
            scan_.malformed("the file does not begin with # vtk DataFile");
        scan_.line(); // the title
        const std::string_view encoding = scan_.word();
        values_.binary = same_word(encoding, "BINARY");
        if (!values_.binary && !same_word(encoding, "ASCII"))
            scan_.malformed("found " + quoted(encoding) + " in place of ASCII or BINARY");
        if (const std::string_view word = scan_.word(); !same_word(word, "DATASET"))
            scan_.malformed("found " + quoted(word) + " in place of DATASET");
        const std::string_view set = scan_.word();
        grid_ = same_word(set, "UNSTRUCTURED_GRID");
        if (!grid_ && !same_word(set, "POLYDATA"))
            scan_.fail(Fault::unsupported, "the data set " + quoted(set) + " is not read");
    }

    // Up to an empty line.
    void skip_metadata() {
        scan_.line();
        while (!scan_.line().empty()) {
        }
    }

    // The arrays of a field; false if one is of a type that cannot even be skipped.
    bool read_field(std::vector<Data> &to) {
        scan_.word(); // its name
        const std::int64_t n_arrays = scan_.count("arrays", 4);
        for (std::int64_t a = 0; a < n_arrays; ++a) {
            std::string_view name = scan_.word();
            if (same_word(name, "METADATA")) {
                skip_metadata();
                name = scan_.word();
            }
            const std::int64_t width = scan_.count("components", 1), length = scan_.count("tuples", 1);
            const std::optional<Type> type = find_type(scan_.word());
            if (!type || type->size == 0)
                return false;
            values_.begin();
            read_values(to, name, *type, width, length);
        }
        return true;
    }

    // From exactly here.
    void read_values(std::vector<Data> &to, std::string_view name, Type type, std::int64_t width,
                     std::int64_t length) {
        to.push_back({decoded(name), width, type.kind != Kind::real, values_.reals(width * length, type)});
    }

    static bool is_attributes(std::string_view keyword) {
        return same_word(keyword, "POINT_DATA") || same_word(keyword, "CELL_DATA");
    }

    // To the end of the file, or up to the first thing that is not known: all that counts
    // for the mesh itself came before.
    void read_attributes(std::string_view keyword) {
        std::int64_t n = 0;
        std::vector<Data> *to = nullptr;
        for (;; keyword = scan_.word()) {
            if (is_attributes(keyword)) {
                n = scan_.integer();
                to = same_word(keyword, "CELL_DATA") ? &data_.of_cells : &data_.of_points;
            } else if (same_word(keyword, "METADATA")) {
                skip_metadata();
            } else if (!(same_word(keyword, "FIELD") ? read_field(*to) : read_attribute(keyword, n, *to))) {
                return;
            }
            if (scan_.at_end())
                return;
        }
    }

    bool read_attribute(std::string_view keyword, std::int64_t n, std::vector<Data> &to) {
        struct Attribute {
            std::string_view keyword;
            std::int64_t width;
        };
        static constexpr std::array<Attribute, 6> attributes{{{"SCALARS", 1},
                                                              {"VECTORS", 3},
                                                              {"NORMALS", 3},
                                                              {"TENSORS", 9},
                                                              {"GLOBAL_IDS", 1},
                                                              {"PEDIGREE_IDS", 1}}};
        const auto attribute = std::find_if(attributes.begin(), attributes.end(), [&](const Attribute &a) {
            return same_word(a.keyword, keyword);
        });
        if (attribute == attributes.end())
            return false;
        const std::string_view name = scan_.word();
        const std::optional<Type> type = find_type(scan_.word());
        if (!type || type->size == 0)
            return false;
        const std::int64_t width = scan_.at_line_end() ? attribute->width : scan_.count("components", 1);
        scan_.line();
        if (scan_.ahead("LOOKUP_TABLE") || scan_.ahead("lookup_table"))
            scan_.line();
        scan_.expect(n, "values", 1);
        read_values(to, name, *type, width, n);
        return true;
    }

    void read_points() {
        if (points_)
            scan_.malformed("POINTS come twice");
        points_ = true;
        const std::int64_t n = scan_.count("points", 3);
        const Type type = values_.read_type();
        if (type.size == 0)
            scan_.malformed("points are not bits");
        values_.begin();
        scan_.expect(n, "points", 3 * values_.least(type));
        mesh_.points.reserve(static_cast<std::size_t>(n) * 3);
        for (std::int64_t v = 0; v < n; ++v) {
            const double x = values_.real(type), y = values_.real(type), z = values_.real(type);
            add_vertex(scan_, mesh_, x, y, z);
        }
    }

    // "n size" and then n times "k v1 ... vk", or since 5.1 "n+1 size", OFFSETS, CONNECTIVITY.
    CellArray read_cells() {
        cells_seen_ = true;
        const std::int64_t n = scan_.count("cells", 1), size = scan_.count("numbers", 1);
        if (values_.binary)
            scan_.line();
        else
            scan_.at_end(); // moves to the next word
        if (scan_.ahead("OFFSETS") || scan_.ahead("offsets"))
            return read_offset_cells(n, size);
        scan_.expect(size, "numbers", values_.binary ? 4 : 2);
        CellArray cells;
        cells.offsets.reserve(at(std::min(n, size)) + 1);
        cells.connectivity.reserve(at(size));
        std::int64_t left = size;
        for (std::int64_t i = 0; i < n; ++i) {
            const std::int64_t k = values_.integer({Kind::whole, 4});
            if (k < 0 || k > left - 1)
                scan_.malformed("a cell of " + std::to_string(k) + " vertices does not fit");
            for (std::int64_t j = 0; j < k; ++j)
                cells.connectivity.push_back(values_.integer({Kind::whole, 4}));
            cells.offsets.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
            left -= 1 + k;
        }
        if (left != 0)
            scan_.malformed("the cells have fewer numbers than promised");
        return cells;
    }

    CellArray read_offset_cells(std::int64_t n_offsets, std::int64_t size) {
        CellArray cells;
        scan_.word();
        cells.offsets = values_.integers(n_offsets, values_.read_type());
        if (const std::string_view word = scan_.word(); !same_word(word, "CONNECTIVITY"))
            scan_.malformed("found " + quoted(word) + " in place of CONNECTIVITY");
        cells.connectivity = values_.integers(size, values_.read_type());
        if (cells.offsets.empty()) // VTK writes no offsets for no cells
            cells.offsets.push_back(0);
        require_ascending(scan_, cells);
        return cells;
    }

    bool read_grid_part(std::string_view keyword) {
        if (same_word(keyword, "CELLS")) {
            data_.cells = read_cells();
        } else if (same_word(keyword, "CELL_TYPES")) {
            data_.types = values_.integers(scan_.count("cell types", 1), {Kind::whole, 4});
        } else {
            return false;
        }
        return true;
    }

    bool read_polydata_part(std::string_view keyword) {
        if (same_word(keyword, "POLYGONS")) {
            polygons_.append(read_cells());
        } else if (same_word(keyword, "TRIANGLE_STRIPS")) {
            if (read_cells().size() > 0)
                scan_.fail(Fault::not_quad, "the file has strips of triangles; write single triangles");
        } else if (same_word(keyword, "VERTICES")) {
            data_.cells = read_cells();
        } else if (same_word(keyword, "LINES")) {
            lines_ = read_cells();
        } else {
            return false;
        }
        return true;
    }

    // Data of POLYDATA are those of vertices, lines and faces, in whatever order these came.
    void gather_polydata() {
        data_.types.assign(data_.cells.size(), poly_vertex_cell);
        data_.types.insert(data_.types.end(), lines_.size(), poly_line_cell);
        data_.types.insert(data_.types.end(), polygons_.size(), polygon_cell);
        data_.cells.append(lines_);
        data_.cells.append(polygons_);
    }

    Scanner scan_;
    Values values_{scan_};
    bool grid_ = false, points_ = false, cells_seen_ = false;
    DataSet data_; // of POLYDATA at first the vertices alone
    CellArray lines_, polygons_;
    Arrays mesh_;
};

} // namespace

Arrays parse_vtk(std::string_view bytes) { return Reader(bytes).read(); }

} // namespace alphamst::io
