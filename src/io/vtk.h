// What the reader and the writer of legacy VTK both have to know.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace alphamst::io::vtk {

// VTK's cell types.
constexpr std::int64_t vertex_cell = 1, poly_vertex_cell = 2, line_cell = 3, poly_line_cell = 4,
                       triangle_cell = 5, polygon_cell = 7, pixel_cell = 8, quad_cell = 9;

// Data of cells that are markers, the first that is there: that of this library, then of meshio and Gmsh, of
// meshio and Medit, of dolfinx, two of ParaView, and that of Gmsh itself, which are tags of the entities of
// its model and no physical groups.
constexpr std::string_view entity_tags = "CellEntityIds";
constexpr std::array<std::string_view, 7> marker_names{
    "marker", "gmsh:physical", "medit:ref", "cell_tags", "MaterialIds", "RegionId", entity_tags};

} // namespace alphamst::io::vtk
