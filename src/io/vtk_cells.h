// What a file of VTK says, in whatever encoding it does: cells, and data of cells and points, which become
// faces, markers and fields.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/scanner.h"

namespace alphamst::io::vtk {

// Cell i has the vertices connectivity[offsets[i] .. offsets[i + 1]).
struct CellArray {
    std::vector<std::int64_t> offsets{0}, connectivity;
    std::size_t size() const { return offsets.size() - 1; }
    void append(const CellArray &more);
};

struct Data {
    std::string name;
    std::int64_t components = 1;
    bool whole = false;         // of a type of whole numbers
    std::vector<double> values; // [n][components]
};

struct DataSet {
    CellArray cells;
    std::vector<std::int64_t> types; // [cell]
    std::vector<Data> of_points, of_cells, of_all;
};

// Fails unless offsets ascend from 0 to the number of vertices.
void require_ascending(const Scanner &at, const CellArray &cells);

// Adds what is there to a mesh that has the points. Failures have the place of the last word read.
void add_data_set(const Scanner &at, DataSet data, Arrays &mesh);
// The other way round: faces, then edges with a marker as lines, then points with one as vertex cells, so
// that the number of a face's cell is that of the face. Data "marker" of cells come first if there are any;
// fields of faces are not a number on lines and vertex cells.
DataSet data_set_of(const Arrays &mesh);

} // namespace alphamst::io::vtk
