// Wavefront OBJ: vertices and faces. Normals, texture coordinates, groups,
// materials, lines, points and free-form curves are passed over.
#include <algorithm>
#include <limits>

#include "io/formats.h"
#include "io/number.h"
#include "io/scanner.h"

namespace alphamst::io {
namespace {

// "v", "v/t", "v//n" or "v/t/n"; a negative v counts back from the last vertex.
std::int64_t vertex_number(const Scanner &scan, std::string_view word, std::int64_t n_vertices) {
    std::int64_t v = 0;
    const Parsed parsed = parse(word.substr(0, word.find('/')), v);
    if (parsed == Parsed::malformed)
        scan.malformed("found " + quoted(word) + " in place of a corner of a face");
    if (parsed == Parsed::too_large)
        scan.malformed("the number " + quoted(word) + " is too large");
    return v < 0 && v + n_vertices >= 0 ? v + n_vertices + 1 : v;
}

void read_face(Scanner &scan, Arrays &mesh) {
    const auto n_vertices = static_cast<std::int64_t>(mesh.points.size() / 3);
    // Faces may come before their vertices: only the range of the type is checked here.
    constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
    std::int32_t face[4] = {-1, -1, -1, -1};
    std::int64_t corners = 0;
    for (; !scan.at_line_end(); ++corners) {
        const std::int64_t v = vertex_number(scan, scan.word(), n_vertices);
        if (v < 1 || v > most)
            corner(scan, mesh, v, n_vertices, 1);
        if (corners < 4)
            face[corners] = static_cast<std::int32_t>(v - 1);
    }
    need_corners(scan, mesh, corners);
    mesh.faces.insert(mesh.faces.end(), face, face + 4);
}

} // namespace

Arrays parse_obj(std::string_view bytes) {
    Scanner scan(bytes, '#', true);
    Arrays mesh;
    while (!scan.at_end()) {
        const std::string_view keyword = scan.word();
        if (keyword == "v") {
            double p[3];
            for (double &x : p) {
                if (scan.at_line_end())
                    scan.malformed("a vertex needs three coordinates");
                x = scan.real();
            }
            add_vertex(scan, mesh, p[0], p[1], p[2]); // a weight or colour may follow
        } else if (keyword == "f" || keyword == "fo") {
            read_face(scan, mesh);
        } else if (std::any_of(keyword.begin(), keyword.end(), [](char c) { return c < ' ' || c > '~'; })) {
            scan.malformed(quoted(keyword) + " is not a keyword of OBJ");
        }
        while (!scan.at_line_end())
            scan.word();
    }
    if (mesh.points.empty())
        scan.malformed("the file has no vertices");
    if (mesh.points.size() / 3 > std::numeric_limits<std::int32_t>::max())
        scan.fail(Fault::unsupported, "the file has more vertices than 32-bit numbers can name");
    const auto n_vertices = static_cast<std::int32_t>(mesh.points.size() / 3);
    for (std::size_t i = 0; i < mesh.faces.size(); ++i)
        if (mesh.faces[i] >= n_vertices)
            throw Failure(Fault::range,
                          "face {} has vertex number " + std::to_string(std::int64_t{mesh.faces[i]} + 1) +
                              " of the file, which has " + std::to_string(n_vertices) +
                              " vertices counted from 1; correct it, or add the vertex",
                          Entity::face, {static_cast<std::int64_t>(i / 4)});
    return finished(std::move(mesh));
}

std::string print_obj(const Arrays &mesh) {
    std::string text;
    append_points(text, mesh, "v ");
    append_faces(text, mesh, "f ", 1);
    return text;
}

} // namespace alphamst::io
