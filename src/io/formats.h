// One reader and one writer per format, from and to the bytes of a file. The
// readers throw what arrays.h says; the writers take a mesh that is in order.
//
// OFF, OBJ and PLY are not read by OpenMesh's readers, though OpenMesh is at hand:
// up to version 9 these parse coordinates as float (a double does not survive a
// read, nor a write to PLY), reserve memory by what the header promises, drop OBJ
// faces and repeated corners without a failure, do not know comments in OFF or
// joined lines in OBJ, open the material files an OBJ names, follow the locale of
// the program and print. The tests hold the files written here against OpenMesh's
// readers.
#pragma once

#include <string>
#include <string_view>

#include "io/arrays.h"

namespace alphamst::io {

Arrays parse_off(std::string_view bytes);
Arrays parse_obj(std::string_view bytes);
Arrays parse_ply(std::string_view bytes);
Arrays parse_msh(std::string_view bytes);
Arrays parse_su2(std::string_view bytes);
Arrays parse_vtk(std::string_view bytes);
Arrays parse_vtu(std::string_view bytes);
Arrays parse_inp(std::string_view bytes);

// OFF, OBJ and PLY have no place for markers and drop them; SU2 has those of edges; VTK has all as the
// data "marker" of its cells, marked edges being lines and marked points vertex cells, and fields but those
// of edges.
std::string print_off(const Arrays &mesh);
std::string print_obj(const Arrays &mesh);
std::string print_ply(const Arrays &mesh);  // ASCII
std::string print_msh(const Arrays &mesh);  // MSH 2.2 ASCII
std::string print_msh4(const Arrays &mesh); // MSH 4.1 ASCII
std::string print_su2(const Arrays &mesh);
std::string print_vtk(const Arrays &mesh); // legacy 3.0 ASCII
std::string print_vtu(const Arrays &mesh); // appended raw

// Lines "x y z" and "<start>a b c d", as most formats have them.
void append_points(std::string &text, const Arrays &mesh, const char *start);
void append_faces(std::string &text, const Arrays &mesh, const char *start, int first_number);

} // namespace alphamst::io
