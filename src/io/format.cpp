// Chooses the format by the extension of a path.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "failure.h"
#include "io/arrays.h"
#include "io/file.h"
#include "io/formats.h"
#include "io/number.h"
#include "io/scanner.h"

namespace alphamst::io {
namespace {

// What a format has a place for.
struct Keeps {
    bool edges, faces_and_points, names; // markers of these, and what they are called
    bool fields;                         // of vertices and faces
    bool signs = true;                   // of markers
};

struct Format {
    std::string_view extension;
    Arrays (*parse)(std::string_view);
    std::string (*print)(const Arrays &); // null: it is only read
    Keeps keeps;
};

constexpr std::array<Format, 9> formats{{{".off", parse_off, print_off, {false, false, false, false}},
                                         {".obj", parse_obj, print_obj, {false, false, false, false}},
                                         {".ply", parse_ply, print_ply, {false, false, false, false}},
                                         {".msh", parse_msh, print_msh, {true, true, true, false}},
                                         {".msh4", parse_msh, print_msh4, {true, true, true, false, false}},
                                         {".su2", parse_su2, print_su2, {true, false, true, false}},
                                         {".vtk", parse_vtk, print_vtk, {true, true, true, true}},
                                         {".vtu", parse_vtu, print_vtu, {true, true, true, true}},
                                         {".inp", parse_inp, nullptr, {true, true, true, false}}}};

std::string_view extension(std::string_view path) {
    const std::size_t dot = path.find_last_of("./\\");
    return dot == std::string_view::npos || path[dot] != '.' ? std::string_view() : path.substr(dot);
}

const Format &find(std::string_view path, bool to_write, const char *known) {
    for (const Format &format : formats)
        if (same_word(extension(path), format.extension) && !(to_write && format.print == nullptr))
            return format;
    throw Failure(Fault::unsupported, "the extension " + quoted(extension(path)) + " is not one of " + known +
                                          "; convert the mesh to one of these formats");
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
    for (const Arrays::MarkedPoint &point : mesh.marked_points)
        if (!is_vertex(point.vertex))
            throw Failure(Fault::range, "a marked point is no vertex");
}

// What of the mesh is not in a file of this format.
std::vector<std::string> left_out(const Format &format, const Arrays &mesh) {
    std::vector<std::string> remarks;
    const auto say = [&](auto n, const char *things) {
        if (n > 0)
            remarks.push_back(std::string(format.extension) + " has no place for " + std::to_string(n) +
                              things);
    };
    if (!format.keeps.edges)
        say(mesh.marked_edges.size(), " markers of edges");
    if (!format.keeps.faces_and_points) {
        say(std::ranges::count_if(mesh.face_marker, [](std::int32_t marker) { return marker != 0; }),
            " markers of faces");
        say(mesh.marked_points.size(), " markers of vertices");
    }
    if (!format.keeps.signs) {
        const auto negative = [](const auto &marked) { return marked.marker < 0; };
        say(std::ranges::count_if(mesh.face_marker, [](std::int32_t marker) { return marker < 0; }) +
                std::ranges::count_if(mesh.marked_edges, negative) +
                std::ranges::count_if(mesh.marked_points, negative),
            " signs of markers, which are orientations in it");
    }
    const auto kept = [&](const auto &name) {
        return format.keeps.names && (name.first.first == Entity::edge || format.keeps.faces_and_points);
    };
    say(std::ranges::count_if(mesh.names, std::not_fn(kept)), " names of markers");
    const auto lost = [&](const auto &field) {
        return !format.keeps.fields || field->entity == Entity::edge;
    };
    std::string fields;
    for (const auto &field : mesh.fields)
        if (lost(field))
            fields += (fields.empty() ? ": " : ", ") + io::quoted(field->name);
    say(std::ranges::count_if(mesh.fields, lost), (" fields" + fields).c_str());
    return remarks;
}

} // namespace

Arrays read(const std::string &path) {
    const Format &format = find(path, false, ".off, .obj, .ply, .msh, .msh4, .su2, .vtk, .vtu, .inp, .amst");
    const std::string bytes = load(path);
    std::string_view text = bytes;
    if (constexpr std::string_view mark = "\xef\xbb\xbf"; text.starts_with(mark)) // of UTF-8
        text.remove_prefix(mark.size());
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        throw Failure(Fault::unsupported, "the file is text in UTF-16; save it in UTF-8");
    return format.parse(text);
}

std::vector<std::string> write(const std::string &path, const Arrays &mesh) {
    const Format &format = find(path, true, ".off, .obj, .ply, .msh, .msh4, .su2, .vtk, .vtu, .amst, .svg");
    check(mesh);
    std::vector<std::string> remarks = left_out(format, mesh);
    save(path, format.print(mesh));
    return remarks;
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
