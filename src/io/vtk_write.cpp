// Writes legacy VTK, version 3.0: an UNSTRUCTURED_GRID in ASCII with the markers of faces, edges and points
// as data of its cells, and fields.
#include <array>
#include <cmath>

#include "io/formats.h"
#include "io/number.h"
#include "io/vtk.h"
#include "io/vtk_cells.h"

namespace alphamst::io {
namespace {

// Blanks and the like as %20, so that a name is one word.
std::string encoded(std::string_view name) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string text;
    for (const char c : name) {
        if (c > ' ' && c <= '~' && c != '%' && c != '"') {
            text += c;
            continue;
        }
        const auto byte = static_cast<unsigned char>(c);
        text += {'%', digits[byte / 16], digits[byte % 16]};
    }
    return text;
}

void append_field(std::string &text, const std::vector<vtk::Data> &all, std::size_t from) {
    if (from >= all.size())
        return;
    text += "FIELD FieldData " + std::to_string(all.size() - from) + "\n";
    for (; from < all.size(); ++from) {
        const vtk::Data &data = all[from];
        const auto width = static_cast<std::size_t>(data.components);
        text += encoded(data.name) + " " + std::to_string(width) + " " +
                std::to_string(data.values.size() / width) + (data.whole ? " int\n" : " double\n");
        for (std::size_t i = 0; i < data.values.size(); ++i) {
            // Of what is no face: VTK's own reader takes nan for a keyword.
            append_number(text, std::isnan(data.values[i]) ? 0 : data.values[i]);
            text += (i + 1) % width == 0 ? '\n' : ' ';
        }
    }
}

} // namespace

std::string print_vtk(const Arrays &mesh) {
    const vtk::DataSet data = vtk::data_set_of(mesh);
    const std::string n = std::to_string(data.types.size());
    std::string text = "# vtk DataFile Version 3.0\nquadrilateral mesh\nASCII\nDATASET UNSTRUCTURED_GRID\n";
    append_field(text, data.of_all, 0);
    text += "POINTS " + std::to_string(mesh.points.size() / 3) + " double\n";
    append_points(text, mesh, "");
    text += "CELLS " + n + " " + std::to_string(data.types.size() + data.cells.connectivity.size()) + "\n";
    for (std::size_t i = 0; i < data.types.size(); ++i) {
        const std::int64_t first = data.cells.offsets[i], end = data.cells.offsets[i + 1];
        append_number(text, end - first);
        for (std::int64_t k = first; k < end; ++k) {
            text += ' ';
            append_number(text, data.cells.connectivity[static_cast<std::size_t>(k)]);
        }
        text += '\n';
    }
    text += "CELL_TYPES " + n + "\n";
    for (const std::int64_t type : data.types)
        text += std::to_string(type) + "\n";
    if (!data.of_cells.empty())
        text += "CELL_DATA " + n + "\n";
    const bool marked = !data.of_cells.empty() && data.of_cells.front().whole;
    if (marked) {
        text += "SCALARS " + data.of_cells.front().name + " int 1\nLOOKUP_TABLE default\n";
        for (const double marker : data.of_cells.front().values)
            text += std::to_string(std::lround(marker)) + "\n";
    }
    append_field(text, data.of_cells, marked ? 1 : 0);
    if (!data.of_points.empty())
        text += "POINT_DATA " + std::to_string(mesh.points.size() / 3) + "\n";
    append_field(text, data.of_points, 0);
    return text;
}

} // namespace alphamst::io
