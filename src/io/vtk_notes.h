// What VTK has no place for and is kept in data of the whole set, one array of whole numbers each: carry
// rules as "carry vertex temperature", 0 .. 4, and names of markers as "marker edge inlet", the markers.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "io/vtk_cells.h"

namespace alphamst::io::vtk {

std::vector<Data> notes_of(const Arrays &mesh); // of vertices, edges and faces; carry rules not of edges
// Gives the mesh, whose fields are there, what the notes say; other data are passed over.
void add_notes(std::span<const Data> notes, Arrays &mesh);

} // namespace alphamst::io::vtk
