// Chooses the format by the extension of a path.
#include <algorithm>
#include <array>
#include <cmath>

#include "failure.h"
#include "io/arrays.h"
#include "io/file.h"
#include "io/formats.h"
#include "io/number.h"
#include "io/scanner.h"

namespace alphamst::io {
namespace {

struct Format {
    std::string_view extension;
    Arrays (*parse)(std::string_view);
    std::string (*print)(const Arrays &); // nullptr: not written
};

constexpr std::array<Format, 6> formats{{{".off", parse_off, print_off},
                                         {".obj", parse_obj, print_obj},
                                         {".ply", parse_ply, print_ply},
                                         {".msh", parse_msh, print_msh},
                                         {".su2", parse_su2, nullptr},
                                         {".vtk", parse_vtk, print_vtk}}};

std::string_view extension(std::string_view path) {
    const std::size_t dot = path.find_last_of("./\\");
    return dot == std::string_view::npos || path[dot] != '.' ? std::string_view() : path.substr(dot);
}

const Format &find(std::string_view path, bool written, const char *known) {
    for (const Format &format : formats)
        if (same_word(extension(path), format.extension) && (format.print != nullptr || !written))
            return format;
    throw Failure(Fault::unsupported, "the extension " + quoted(extension(path)) + " is not one of " + known);
}

// What the writers rely on.
void check(const Arrays &mesh) {
    const auto n_vertices = static_cast<std::int64_t>(mesh.points.size() / 3);
    const auto is_vertex = [n_vertices](std::int32_t v) { return v >= 0 && v < n_vertices; };
    if (mesh.points.size() % 3 != 0 || mesh.faces.size() % 4 != 0 ||
        (!mesh.face_marker.empty() && mesh.face_marker.size() != mesh.faces.size() / 4))
        throw Failure(Fault::argument, "the arrays of the mesh do not fit together");
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
        if (!std::isfinite(mesh.points[i]))
            throw Failure(Fault::not_finite, "a coordinate of vertex {} is not finite", Entity::vertex,
                          {static_cast<std::int64_t>(i / 3)});
    for (std::size_t i = 0; i < mesh.faces.size(); ++i)
        if (!is_vertex(mesh.faces[i]))
            throw Failure(Fault::range, "face {} has a corner that is not a vertex", Entity::face,
                          {static_cast<std::int64_t>(i / 4)});
    for (const Arrays::MarkedEdge &edge : mesh.marked_edges)
        if (!is_vertex(edge.vertices[0]) || !is_vertex(edge.vertices[1]))
            throw Failure(Fault::range, "a marked edge ends at no vertex");
}

} // namespace

Arrays read(const std::string &path) {
    const Format &format = find(path, false, ".off, .obj, .ply, .msh, .su2, .vtk");
    return format.parse(load(path));
}

void write(const std::string &path, const Arrays &mesh) {
    const Format &format = find(path, true, ".off, .obj, .ply, .msh, .vtk, .svg");
    check(mesh);
    save(path, format.print(mesh));
}

void append_points(std::string &text, const Arrays &mesh, const char *start) {
    for (std::size_t i = 0; i + 2 < mesh.points.size(); i += 3) {
        text += start;
        for (std::size_t k = 0; k < 3; ++k) {
            append_number(text, mesh.points[i + k]);
            text += k < 2 ? ' ' : '\n';
        }
    }
}

void append_faces(std::string &text, const Arrays &mesh, const char *start, int first_number) {
    for (std::size_t i = 0; i + 3 < mesh.faces.size(); i += 4) {
        text += start;
        for (std::size_t k = 0; k < 4; ++k) {
            append_number(text, std::int64_t{mesh.faces[i + k]} + first_number);
            text += k < 3 ? ' ' : '\n';
        }
    }
}

} // namespace alphamst::io
