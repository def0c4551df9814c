// OFF as Geomview describes it (Phillips, Levy and Munzner 1993), ASCII: the
// keyword may be missing, colours and normals behind the coordinates are passed
// over.
#include "io/formats.h"
#include "io/number.h"
#include "io/scanner.h"

namespace alphamst::io {
namespace {

// Reads the keyword and returns the number of vertices behind it.
std::int64_t header(Scanner &scan) {
    constexpr std::size_t least = 6; // "0 0 0\n"
    std::string_view word = scan.word();
    const std::size_t off = word.substr(0, 8).find("OFF");
    if (off != std::string_view::npos) {
        const std::string_view prefix = word.substr(0, off);
        if (prefix.find_first_not_of("STCN4n") != std::string_view::npos)
            scan.malformed(quoted(word) + " is not a keyword of OFF");
        if (prefix.find_first_of("4n") != std::string_view::npos)
            scan.fail(Fault::unsupported, "only points in three dimensions are read, not " + quoted(word));
        word.remove_prefix(off + 3);
        if (word.empty())
            word = scan.word();
    }
    if (word == "BINARY")
        scan.fail(Fault::unsupported, "binary OFF is not read");
    std::int64_t n = 0;
    if (parse(word, n) != Parsed::number)
        scan.malformed("found " + quoted(word) + " in place of the keyword OFF or the number of vertices");
    scan.expect(n, "vertices", least);
    return n;
}

} // namespace

Arrays parse_off(std::string_view bytes) {
    Scanner scan(bytes, '#');
    Arrays mesh;
    const std::int64_t n_vertices = header(scan);
    const std::int64_t n_faces = scan.count("faces", 4);
    scan.line(); // the number of edges is optional and means nothing
    mesh.points.reserve(static_cast<std::size_t>(n_vertices) * 3);
    for (std::int64_t v = 0; v < n_vertices; ++v) {
        const double x = scan.real(), y = scan.real(), z = scan.real();
        add_vertex(scan, mesh, x, y, z);
        scan.line();
    }
    for (std::int64_t f = 0; f < n_faces; ++f) {
        const std::size_t n = need_corners(scan, mesh, scan.integer());
        std::int32_t face[4] = {-1, -1, -1, -1};
        for (std::size_t k = 0; k < n; ++k)
            face[k] = corner(scan, mesh, scan.integer(), n_vertices, 0);
        mesh.faces.insert(mesh.faces.end(), face, face + 4);
        scan.line();
    }
    if (!scan.at_end())
        scan.malformed("after the " + std::to_string(n_faces) + " promised faces comes " +
                       quoted(scan.word()));
    return finished(std::move(mesh));
}

std::string print_off(const Arrays &mesh) {
    std::string text = "OFF\n" + std::to_string(mesh.points.size() / 3) + " " +
                       std::to_string(mesh.faces.size() / 4) + " 0\n";
    append_points(text, mesh, "");
    append_faces(text, mesh, "4 ", 0);
    return text;
}

} // namespace alphamst::io
