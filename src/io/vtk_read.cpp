// Reads legacy VTK (Schroeder, Martin and Lorensen 2006; the layout of cells of version
// 5.1 after Kitware's file format pages): UNSTRUCTURED_GRID and POLYDATA, ASCII
// and binary. Data of the cells in whole numbers that have one of some names are the markers of
// faces, lines and vertex cells; other data and cells without a marker are passed over.
#include <algorithm>
#include <array>
#include <optional>

#include "io/formats.h"
#include "io/markers.h"
#include "io/scanner.h"
#include "io/vtk.h"
#include "io/vtk_values.h"

namespace alphamst::io {
namespace {

using namespace vtk;

// Cells as VTK 5.1 has them: cell i has the vertices connectivity[offsets[i] .. offsets[i + 1]).
struct Cells {
    std::vector<std::int64_t> offsets{0}, connectivity;
    std::size_t size() const { return offsets.size() - 1; }
};

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
                if (!read_field(false))
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
        if (grid_)
            add_grid();
        add_markers();
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
    bool read_field(bool of_cells) {
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
            read_values(*type, width, length, of_cells ? rank_of(name) : unknown);
        }
        return true;
    }

    // The place of a name among those of markers, unknown if it is none of them.
    static std::size_t rank_of(std::string_view name) {
        return static_cast<std::size_t>(std::ranges::find(marker_names, name) - marker_names.begin());
    }

    // From exactly here; only single whole numbers can be markers.
    void read_values(Type type, std::int64_t width, std::int64_t length, std::size_t rank) {
        const std::int64_t n = width * length;
        scan_.expect(n, "values", values_.least(type));
        const bool possible = rank < unknown && width == 1 && type.kind != Kind::real;
        if (possible && rank_ < unknown)
            mesh_.remarks.push_back("the cells have " + quoted(marker_names[rank]) + " and " +
                                    quoted(marker_names[rank_]) + ": the markers are " +
                                    quoted(marker_names[std::min(rank, rank_)]));
        if (possible && rank < rank_) {
            rank_ = rank;
            markers_.emplace(static_cast<std::size_t>(n));
            for (std::int32_t &marker : *markers_) {
                const std::int64_t value = values_.integer(type);
                marker = static_cast<std::int32_t>(value);
                if (marker != value)
                    scan_.fail(Fault::unsupported,
                               "the marker " + std::to_string(value) + " does not fit in 32 bits");
            }
        } else {
            values_.skip(n, type);
        }
    }

    static bool is_attributes(std::string_view keyword) {
        return same_word(keyword, "POINT_DATA") || same_word(keyword, "CELL_DATA");
    }

    // To the end of the file, or up to the first thing that is not known: all that counts
    // for the mesh itself came before.
    void read_attributes(std::string_view keyword) {
        std::int64_t n = 0;
        bool of_cells = false;
        for (;; keyword = scan_.word()) {
            if (is_attributes(keyword)) {
                n = scan_.integer();
                of_cells = same_word(keyword, "CELL_DATA");
            } else if (same_word(keyword, "METADATA")) {
                skip_metadata();
            } else if (!(same_word(keyword, "FIELD") ? read_field(of_cells)
                                                     : read_attribute(keyword, n, of_cells))) {
                return;
            }
            if (scan_.at_end())
                return;
        }
    }

    bool read_attribute(std::string_view keyword, std::int64_t n, bool of_cells) {
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
        read_values(*type, width, n, of_cells ? rank_of(name) : unknown);
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
    Cells read_cells() {
        cells_seen_ = true;
        const std::int64_t n = scan_.count("cells", 1), size = scan_.count("numbers", 1);
        if (values_.binary)
            scan_.line();
        else
            scan_.at_end(); // moves to the next word
        if (scan_.ahead("OFFSETS") || scan_.ahead("offsets"))
            return read_offset_cells(n, size);
        scan_.expect(size, "numbers", values_.binary ? 4 : 2);
        Cells cells;
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

    Cells read_offset_cells(std::int64_t n_offsets, std::int64_t size) {
        Cells cells;
        scan_.word();
        cells.offsets = values_.integers(n_offsets, values_.read_type());
        if (const std::string_view word = scan_.word(); !same_word(word, "CONNECTIVITY"))
            scan_.malformed("found " + quoted(word) + " in place of CONNECTIVITY");
        cells.connectivity = values_.integers(size, values_.read_type());
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
            types_ = values_.integers(scan_.count("cell types", 1), {Kind::whole, 4});
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
                scan_.fail(Fault::not_quad, "face {} is in a strip of triangles; write single triangles",
                           Entity::face, {n_faces()});
        } else if (same_word(keyword, "VERTICES")) {
            vertex_cells_ = read_cells();
        } else if (same_word(keyword, "LINES")) {
            cells_ = read_cells();
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
            need_corners(scan_, mesh_, n);
        else
            scan_.fail(Fault::not_quad,
                       "face {} is of VTK's cell type " + std::to_string(type) +
                           ", not a triangle or quadrilateral; leave such cells out, or write their surface",
                       Entity::face, {n_faces()});
        if (const std::int64_t wanted = type == triangle_cell ? 3 : type == polygon_cell ? n : 4; n != wanted)
            scan_.malformed("a cell of type " + std::to_string(type) + " has " + std::to_string(n) +
                            " vertices, not " + std::to_string(wanted));
        std::array<std::int32_t, 4> face{-1, -1, -1, -1};
        const auto n_vertices = static_cast<std::int64_t>(mesh_.points.size() / 3);
        for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k)
            face[k] =
                corner(scan_, mesh_, cells.connectivity[static_cast<std::size_t>(first) + k], n_vertices, 0);
        if (type == pixel_cell)
            std::swap(face[2], face[3]);
        mesh_.faces.insert(mesh_.faces.end(), face.begin(), face.end());
    }

    // Cells of a grid are as in the file; those of POLYDATA are vertices, lines and faces,
    // in whatever order they came.
    void add_markers() {
        if (!markers_)
            return;
        const auto n_faces = static_cast<std::size_t>(this->n_faces());
        const std::size_t n_vertex_cells = vertex_cells_.size();
        const std::size_t n_cells = grid_ ? types_.size() : n_vertex_cells + cells_.size() + n_faces;
        if (markers_->size() != n_cells)
            scan_.malformed("there are " + std::to_string(n_cells) + " cells, but " +
                            std::to_string(markers_->size()) + " markers");
        for (std::size_t i = 0; i < n_cells; ++i) {
            const std::int32_t marker = (*markers_)[i];
            if (grid_ ? types_[i] < vertex_cell || types_[i] > poly_line_cell
                      : i >= n_vertex_cells + cells_.size())
                mesh_.face_marker.push_back(marker);
            else if (marker == 0)
                continue;
            else if (grid_ ? types_[i] >= line_cell : i >= n_vertex_cells)
                add_line(grid_ ? i : i - n_vertex_cells, marker);
            else
                add_points(grid_ ? cells_ : vertex_cells_, i, marker);
        }
        mesh_.curve_numbers = marker_names[rank_] == entity_tags && !mesh_.marked_edges.empty();
        settle_markers(mesh_, [](std::int32_t vertex) { return vertex; });
    }

    void add_line(std::size_t i, std::int32_t marker) {
        for (std::int64_t k = cells_.offsets[i] + 1; k < cells_.offsets[i + 1]; ++k)
            mesh_.marked_edges.push_back({{vertex(cells_, k - 1), vertex(cells_, k)}, marker});
    }

    // Gmsh tags every corner of its model, which says nothing.
    void add_points(const Cells &cells, std::size_t i, std::int32_t marker) {
        if (marker_names[rank_] != entity_tags)
            for (std::int64_t k = cells.offsets[i]; k < cells.offsets[i + 1]; ++k)
                mesh_.marked_points.push_back({vertex(cells, k), marker});
    }

    std::int32_t vertex(const Cells &cells, std::int64_t place) const {
        const std::int64_t v = cells.connectivity[static_cast<std::size_t>(place)];
        if (v < 0 || v >= static_cast<std::int64_t>(mesh_.points.size() / 3))
            scan_.fail(Fault::range, "a line or vertex cell has vertex number " + std::to_string(v) +
                                         " of the file, which has " +
                                         std::to_string(mesh_.points.size() / 3) + " vertices");
        return static_cast<std::int32_t>(v);
    }

    std::int64_t n_faces() const { return static_cast<std::int64_t>(mesh_.faces.size() / 4); }

    Scanner scan_;
    Values values_{scan_};
    bool grid_ = false, points_ = false, cells_seen_ = false;
    Cells cells_, vertex_cells_; // all of a grid, the lines of POLYDATA; its vertices
    std::vector<std::int64_t> types_;
    static constexpr std::size_t unknown = marker_names.size();
    std::size_t rank_ = unknown;                       // the place of the name of these
    std::optional<std::vector<std::int32_t>> markers_; // of the cells
    Arrays mesh_;
};

} // namespace

Arrays parse_vtk(std::string_view bytes) { return Reader(bytes).read(); }

} // namespace alphamst::io
