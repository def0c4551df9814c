// Writes legacy VTK, version 3.0: an UNSTRUCTURED_GRID in ASCII with the markers of faces, edges and points
// as data of its cells.
#include <algorithm>
#include <iterator>

#include "io/formats.h"
#include "io/vtk.h"

namespace alphamst::io {

std::string print_vtk(const Arrays &mesh) {
    // Faces first, so that the number of a cell is that of its face.
    std::vector<Arrays::MarkedEdge> lines;
    std::copy_if(mesh.marked_edges.begin(), mesh.marked_edges.end(), std::back_inserter(lines),
                 [](const Arrays::MarkedEdge &edge) { return edge.marker != 0; });
    const std::size_t n_faces = mesh.faces.size() / 4, n_lines = lines.size();
    const std::size_t n_points = mesh.marked_points.size(), n_cells = n_faces + n_lines + n_points;
    const std::string n = std::to_string(n_cells);
    std::string text =
        "# vtk DataFile Version 3.0\nquadrilateral mesh\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " +
        std::to_string(mesh.points.size() / 3) + " double\n";
    append_points(text, mesh, "");
    text += "CELLS " + n + " " + std::to_string(5 * n_faces + 3 * n_lines + 2 * n_points) + "\n";
    append_faces(text, mesh, "4 ", 0);
    for (const Arrays::MarkedEdge &line : lines)
        text += "2 " + std::to_string(line.vertices[0]) + " " + std::to_string(line.vertices[1]) + "\n";
    for (const Arrays::MarkedPoint &point : mesh.marked_points)
        text += "1 " + std::to_string(point.vertex) + "\n";
    text += "CELL_TYPES " + n + "\n";
    for (std::size_t i = 0; i < n_cells; ++i)
        text += std::to_string(i < n_faces             ? vtk::quad_cell
                               : i < n_faces + n_lines ? vtk::line_cell
                                                       : vtk::vertex_cell) +
                "\n";
    if (mesh.face_marker.empty() && n_cells == n_faces)
        return text;
    text += "CELL_DATA " + n + "\nSCALARS " + std::string(vtk::marker_names.front()) +
            " int 1\nLOOKUP_TABLE default\n";
    for (std::size_t f = 0; f < n_faces; ++f)
        text += std::to_string(mesh.face_marker.empty() ? 0 : mesh.face_marker[f]) + "\n";
    for (const Arrays::MarkedEdge &line : lines)
        text += std::to_string(line.marker) + "\n";
    for (const Arrays::MarkedPoint &point : mesh.marked_points)
        text += std::to_string(point.marker) + "\n";
    return text;
}

} // namespace alphamst::io
