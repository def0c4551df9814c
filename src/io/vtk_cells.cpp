#include "io/vtk_cells.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <utility>

#include "index.h"
#include "io/fields.h"
#include "io/markers.h"
#include "io/vtk.h"
#include "io/vtk_notes.h"

namespace alphamst::io::vtk {
namespace {

constexpr std::size_t unknown = marker_names.size();

// The place of a name among those of markers, unknown if it is none of them.
std::size_t rank_of(const Data &data) {
    const bool possible = data.whole && data.components == 1;
    return possible ? at(std::ranges::find(marker_names, data.name) - marker_names.begin()) : unknown;
}

bool is_face(std::int64_t type) { return type < vertex_cell || type > poly_line_cell; }

class Adder {
public:
    Adder(const Scanner &at, DataSet data, Arrays &mesh) : scan_(at), data_(std::move(data)), mesh_(mesh) {}

    void add() {
        const CellArray &cells = data_.cells;
        if (cells.size() != data_.types.size())
            scan_.malformed("there are " + std::to_string(cells.size()) + " cells, but " +
                            std::to_string(data_.types.size()) + " types of cells");
        mesh_.faces.reserve(4 * at(std::ranges::count_if(data_.types, is_face)));
        for (std::size_t i = 0; i < cells.size(); ++i)
            if (is_face(data_.types[i]))
                add_face(i);
        add_markers();
        for (Data &data : data_.of_points)
            add_field(Entity::vertex, data);
        for (Data &data : data_.of_cells)
            add_field(Entity::face, data);
        add_notes(data_.of_all, mesh_);
        settle_markers(mesh_, [](std::int32_t vertex) { return vertex; });
        settle_fields(mesh_);
    }

private:
    void add_face(std::size_t i) {
        const std::int64_t type = data_.types[i];
        const std::int64_t first = data_.cells.offsets[i], n = data_.cells.offsets[i + 1] - first;
        if (type == triangle_cell || (type >= polygon_cell && type <= quad_cell))
            need_corners(scan_, mesh_, n);
        else
            scan_.fail(Fault::not_quad,
                       "face {} is of VTK's cell type " + std::to_string(type) +
                           ", not a triangle or quadrilateral; leave such cells out, or write their surface",
                       Entity::face, {static_cast<std::int64_t>(mesh_.faces.size() / 4)});
        if (const std::int64_t wanted = type == triangle_cell ? 3 : type == polygon_cell ? n : 4; n != wanted)
            scan_.malformed("a cell of type " + std::to_string(type) + " has " + std::to_string(n) +
                            " vertices, not " + std::to_string(wanted));
        std::array<std::int32_t, 4> face{-1, -1, -1, -1};
        const auto n_vertices = static_cast<std::int64_t>(mesh_.points.size() / 3);
        for (std::size_t k = 0; k < at(n); ++k)
            face[k] = corner(scan_, mesh_, data_.cells.connectivity[at(first) + k], n_vertices, 0);
        if (type == pixel_cell)
            std::swap(face[2], face[3]);
        mesh_.faces.insert(mesh_.faces.end(), face.begin(), face.end());
    }

    // Takes the data that are the markers out of those of cells.
    void add_markers() {
        std::vector<Data> &all = data_.of_cells;
        const auto best = std::ranges::min_element(all, {}, rank_of);
        if (best == all.end() || rank_of(*best) == unknown)
            return;
        for (const Data &data : all)
            if (&data != &*best && rank_of(data) < unknown)
                mesh_.remarks.push_back("the cells have " + io::quoted(data.name) + " and " +
                                        io::quoted(best->name) + ": the markers are " +
                                        io::quoted(best->name));
        const Data markers = std::move(*best);
        all.erase(best);
        if (markers.values.size() != data_.types.size())
            scan_.malformed("there are " + std::to_string(data_.types.size()) + " cells, but " +
                            std::to_string(markers.values.size()) + " markers");
        const bool tags = markers.name == entity_tags;
        for (std::size_t i = 0; i < data_.types.size(); ++i) {
            const std::int32_t marker = small(markers.values[i]);
            if (is_face(data_.types[i]))
                mesh_.face_marker.push_back(marker);
            else if (marker == 0)
                continue;
            else if (data_.types[i] >= line_cell)
                add_line(i, marker);
            else if (!tags) // Gmsh tags every corner of its model, which says nothing
                add_points(i, marker);
        }
        mesh_.curve_numbers = tags && !mesh_.marked_edges.empty();
    }

    std::int32_t small(double value) const {
        using Limits = std::numeric_limits<std::int32_t>;
        if (!(value >= Limits::min() && value <= Limits::max()))
            scan_.fail(Fault::unsupported,
                       "the marker " +
                           std::to_string(static_cast<std::int64_t>(std::clamp(value, -9e18, 9e18))) +
                           " does not fit in 32 bits");
        return static_cast<std::int32_t>(value);
    }

    void add_line(std::size_t i, std::int32_t marker) {
        for (std::int64_t k = data_.cells.offsets[i] + 1; k < data_.cells.offsets[i + 1]; ++k)
            mesh_.marked_edges.push_back({{vertex(k - 1), vertex(k)}, marker});
    }

    void add_points(std::size_t i, std::int32_t marker) {
        for (std::int64_t k = data_.cells.offsets[i]; k < data_.cells.offsets[i + 1]; ++k)
            mesh_.marked_points.push_back({vertex(k), marker});
    }

    std::int32_t vertex(std::int64_t place) const {
        const std::int64_t v = data_.cells.connectivity[at(place)];
        if (v < 0 || v >= static_cast<std::int64_t>(mesh_.points.size() / 3))
            scan_.fail(Fault::range, "a line or vertex cell has vertex number " + std::to_string(v) +
                                         " of the file, which has " +
                                         std::to_string(mesh_.points.size() / 3) + " vertices");
        return static_cast<std::int32_t>(v);
    }

    void add_field(Entity entity, Data &data) {
        const std::size_t n = entity == Entity::vertex ? mesh_.points.size() / 3 : data_.types.size();
        const std::size_t width = at(data.components);
        if (width == 0 || data.values.size() != n * width) {
            mesh_.remarks.push_back("the data " + io::quoted(data.name) + " are not " + std::to_string(n) +
                                    " and are left out");
            return;
        }
        if (entity == Entity::face) { // without the rows of lines and vertex cells
            auto to = data.values.begin();
            for (std::size_t i = 0; i < n; ++i)
                if (is_face(data_.types[i]))
                    to = std::copy_n(data.values.begin() + static_cast<std::ptrdiff_t>(i * width), width, to);
            data.values.erase(to, data.values.end());
        }
        add_new_field(mesh_, entity, data.name, static_cast<int>(width), data.whole, std::move(data.values));
    }

    const Scanner &scan_;
    DataSet data_;
    Arrays &mesh_;
};

} // namespace

void CellArray::append(const CellArray &more) {
    const auto before = static_cast<std::int64_t>(connectivity.size());
    connectivity.insert(connectivity.end(), more.connectivity.begin(), more.connectivity.end());
    for (std::size_t i = 1; i < more.offsets.size(); ++i)
        offsets.push_back(before + more.offsets[i]);
}

void require_ascending(const Scanner &at, const CellArray &cells) {
    if (cells.offsets.front() != 0 ||
        cells.offsets.back() != static_cast<std::int64_t>(cells.connectivity.size()) ||
        !std::is_sorted(cells.offsets.begin(), cells.offsets.end()))
        at.malformed("the offsets of the cells do not ascend from 0 to the number of their vertices");
}

void add_data_set(const Scanner &at, DataSet data, Arrays &mesh) { Adder(at, std::move(data), mesh).add(); }

DataSet data_set_of(const Arrays &mesh) {
    DataSet data;
    Data marker{std::string(marker_names.front()), 1, true, {}};
    const auto add = [&](std::span<const std::int32_t> vertices, std::int64_t type, std::int32_t number) {
        data.cells.connectivity.insert(data.cells.connectivity.end(), vertices.begin(), vertices.end());
        data.cells.offsets.push_back(static_cast<std::int64_t>(data.cells.connectivity.size()));
        data.types.push_back(type);
        marker.values.push_back(number);
    };
    const std::size_t n_faces = mesh.faces.size() / 4;
    for (std::size_t f = 0; f < n_faces; ++f)
        add(std::span(mesh.faces).subspan(4 * f, 4), quad_cell,
            mesh.face_marker.empty() ? 0 : mesh.face_marker[f]);
    for (const Arrays::MarkedEdge &line : mesh.marked_edges)
        if (line.marker != 0)
            add(line.vertices, line_cell, line.marker);
    for (const Arrays::MarkedPoint &point : mesh.marked_points)
        add({&point.vertex, 1}, vertex_cell, point.marker);
    if (!mesh.face_marker.empty() || data.types.size() > n_faces)
        data.of_cells.push_back(std::move(marker));
    for (const auto &field : mesh.fields) {
        if (field->entity == Entity::edge)
            continue;
        Data values{field->name, field->components, false, field->values};
        if (field->entity == Entity::face)
            values.values.resize(data.types.size() * at(field->components),
                                 std::numeric_limits<double>::quiet_NaN());
        (field->entity == Entity::face ? data.of_cells : data.of_points).push_back(std::move(values));
    }
    data.of_all = notes_of(mesh);
    return data;
}

} // namespace alphamst::io::vtk
