// A mesh as plain arrays: what every reader returns and every writer takes, which has no triangles.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/field.h"
#include "names.h"

namespace alphamst::io {

struct Arrays {
    int dim = 3;                // 2 when the file is planar (every z is 0)
    std::vector<double> points; // [n_vertices][3], z is 0 when dim is 2
    std::vector<std::int32_t>
        faces; // [n_faces][4] vertices, 0-based, as in the file, the last of a triangle -1
    std::vector<std::int32_t> face_marker; // [n_faces] region numbers, or empty
    struct MarkedEdge {
        std::array<std::int32_t, 2> vertices;
        std::int32_t marker;
    };
    std::vector<MarkedEdge> marked_edges; // boundary numbers, in file order
    bool curve_numbers = false;           // those are tags of curves of the model, which nobody named
    struct MarkedPoint {
        std::int32_t vertex, marker;
    };
    std::vector<MarkedPoint> marked_points;
    Names names; // of markers
    // One value for each vertex and face as they are above. Of a writer: also of the edges of its mesh, which
    // no list here numbers.
    mesh::Fields fields;

    // Of a reader: sentences about markers and fields of the file that are not here, and the first of them
    // about markers that somebody gave to what is not in the mesh at all, or "".
    std::vector<std::string> remarks;
    std::string left_out;
};

// Format by the extension of path (UTF-8): .off .obj .ply .msh .su2 .vtk .vtu .inp. Throws Failure: io
// (cannot be opened, read or written), format (malformed, with line number or byte offset in the sentence),
// unsupported (extension or binary variant not known), not_quad (a face of neither three nor four corners),
// range (a corner that is not a vertex of the file), not_finite.
Arrays read(const std::string &path);
// .msh is MSH 2.2. A failed write leaves the file that was there. Returns sentences about the markers and
// fields that the format does not keep. Throws likewise, and argument if the arrays do not fit together.
std::vector<std::string> write(const std::string &path, const Arrays &mesh);

} // namespace alphamst::io
