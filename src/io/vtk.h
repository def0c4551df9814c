// What the reader and the writer of legacy VTK both have to know.
#pragma once

#include <cstdint>
#include <string_view>

namespace alphamst::io::vtk {

// VTK's cell types.
constexpr std::int64_t vertex_cell = 1, line_cell = 3, poly_line_cell = 4, triangle_cell = 5,
                       polygon_cell = 7, pixel_cell = 8, quad_cell = 9;

// The data of cells that are the region numbers of faces and make marked edges of lines.
constexpr std::string_view marker_name = "marker";

} // namespace alphamst::io::vtk
