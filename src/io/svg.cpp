#include "io/svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "io/file.h"
#include "io/number.h"

namespace alphamst::io {
namespace {

// The longer side of the mesh in units of the picture: coordinates are whole
// numbers, so relative paths are short and exact.
constexpr double longer_side = 10000;
constexpr std::int64_t margin = 250, legend_height = 500;

using Vector = std::array<double, 3>;

Vector cross(const Vector &a, const Vector &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Vector &a, const Vector &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector unit(const Vector &a) {
    const double length = std::sqrt(dot(a, a));
    return {a[0] / length, a[1] / length, a[2] / length};
}

struct Pixel {
    std::int64_t x, y;
};

struct Drawing {
    std::vector<Pixel> pixels; // per vertex
    std::int64_t width = 0, height = 0;
    double edge = 0; // mean length
};

// Coordinates divided by a power of two near the largest, so that nothing overflows.
std::vector<Vector> normalized(const Arrays &mesh) {
    double largest = 0;
    for (double x : mesh.points)
        largest = std::max(largest, std::abs(x));
    const int exponent = largest > 0 ? std::ilogb(largest) : 0;
    std::vector<Vector> points(mesh.points.size() / 3);
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
        points[i / 3][i % 3] = std::scalbn(mesh.points[i], -exponent);
    return points;
}

// From the mesh to the eye.
Vector view(const Arrays &mesh, const std::vector<Vector> &points) {
    if (mesh.dim == 2)
        return {0, 0, 1};
    Vector sum{};
    double total = 0;
    for (std::size_t f = 0; f + 3 < mesh.faces.size(); f += 4) {
        std::array<Vector, 4> p;
        for (std::size_t k = 0; k < 4; ++k)
            p[k] = points[static_cast<std::size_t>(mesh.faces[f + k])];
        const Vector d{p[2][0] - p[0][0], p[2][1] - p[0][1], p[2][2] - p[0][2]};
        const Vector e{p[3][0] - p[1][0], p[3][1] - p[1][1], p[3][2] - p[1][2]};
        const Vector normal = cross(d, e);
        for (std::size_t k = 0; k < 3; ++k)
            sum[k] += normal[k];
        total += std::sqrt(dot(normal, normal));
    }
    const double length = std::sqrt(dot(sum, sum));
    return length > 0.1 * total ? unit(sum) : unit({1, 1, 1});
}

Drawing project(const Arrays &mesh) {
    std::vector<Vector> points = normalized(mesh);
    const Vector towards = view(mesh, points);
    // z points up in the picture, or y when z points to the eye.
    const Vector up = std::abs(towards[2]) > 0.9 ? Vector{0, 1, 0} : Vector{0, 0, 1};
    const Vector right = unit(cross(up, towards)), above = cross(towards, right);
    Vector least{}, most{};
    for (std::size_t v = 0; v < points.size(); ++v) {
        points[v] = {dot(points[v], right), dot(points[v], above), 0};
        for (std::size_t k = 0; k < 2; ++k) {
            least[k] = v == 0 ? points[v][k] : std::min(least[k], points[v][k]);
            most[k] = v == 0 ? points[v][k] : std::max(most[k], points[v][k]);
        }
    }
    const double side = std::max(most[0] - least[0], most[1] - least[1]);
    const double scale = side > 0 ? longer_side / side : 0;
    Drawing drawing;
    drawing.pixels.reserve(points.size());
    for (const Vector &p : points)
        drawing.pixels.push_back(
            {std::llround((p[0] - least[0]) * scale), std::llround((most[1] - p[1]) * scale)});
    drawing.width = std::llround((most[0] - least[0]) * scale);
    drawing.height = std::llround((most[1] - least[1]) * scale);
    double sum = 0;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const Pixel a = drawing.pixels[static_cast<std::size_t>(mesh.faces[i])];
        const Pixel b = drawing.pixels[static_cast<std::size_t>(mesh.faces[i % 4 == 3 ? i - 3 : i + 1])];
        sum += std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
    }
    drawing.edge = mesh.faces.empty() ? 0 : sum / static_cast<double>(mesh.faces.size());
    return drawing;
}

// A minus sign separates as well as a blank.
void append_number(std::string &text, std::int64_t number, bool first) {
    if (!first && number >= 0)
        text += ' ';
    append(text, number);
}

// A closed loop in coordinates relative to `from`, which becomes its first corner.
void append_loop(std::string &text, const std::vector<Pixel> &corners, Pixel &from) {
    Pixel here = from;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        if (k < 2)
            text += k == 0 ? 'm' : 'l';
        append_number(text, corners[k].x - here.x, k < 2);
        append_number(text, corners[k].y - here.y, false);
        here = corners[k];
    }
    text += 'z';
    from = corners.front();
}

std::string faces_path(const Arrays &mesh, const Drawing &drawing) {
    std::string text;
    Pixel here{0, 0};
    std::vector<Pixel> corners(4);
    for (std::size_t f = 0; f + 3 < mesh.faces.size(); f += 4) {
        for (std::size_t k = 0; k < 4; ++k)
            corners[k] = drawing.pixels[static_cast<std::size_t>(mesh.faces[f + k])];
        const std::int64_t twice_area = (corners[2].x - corners[0].x) * (corners[3].y - corners[1].y) -
                                        (corners[2].y - corners[0].y) * (corners[3].x - corners[1].x);
        if (twice_area > 0) // one direction for all, or front and back would leave a hole
            std::swap(corners[1], corners[3]);
        append_loop(text, corners, here);
    }
    return text;
}

std::string outlines_path(const Picture &picture, const Drawing &drawing) {
    std::string text;
    Pixel here{0, 0};
    for (const std::vector<std::int32_t> &outline : picture.outlines) {
        std::vector<Pixel> corners;
        for (std::int32_t v : outline)
            corners.push_back(drawing.pixels[static_cast<std::size_t>(v)]);
        if (!corners.empty())
            append_loop(text, corners, here);
    }
    return text;
}

// Paul Tol's "muted" and two of his "bright": apart also for eyes that confuse red and green.
constexpr std::array colours{"#332288", "#88ccee", "#44aa99", "#117733", "#999933", "#ddcc77",
                             "#cc6677", "#882255", "#aa4499", "#4477aa", "#ee6677"};

Pixel middle(const Drawing &drawing, const std::array<std::int32_t, 2> &edge) {
    const Pixel a = drawing.pixels[static_cast<std::size_t>(edge[0])];
    const Pixel b = drawing.pixels[static_cast<std::size_t>(edge[1])];
    return {(a.x + b.x) / 2, (a.y + b.y) / 2};
}

std::string lines_path(const std::vector<Line> &lines, const Drawing &drawing, std::size_t colour) {
    std::string text;
    Pixel here{0, 0};
    for (const Line &line : lines) {
        constexpr auto n = static_cast<std::int64_t>(colours.size());
        if (static_cast<std::size_t>((line.number % n + n) % n) != colour)
            continue;
        const Pixel from = middle(drawing, line.from), to = middle(drawing, line.to);
        text += 'm';
        append_number(text, from.x - here.x, true);
        append_number(text, from.y - here.y, false);
        text += 'l';
        append_number(text, to.x - from.x, true);
        append_number(text, to.y - from.y, false);
        here = to;
    }
    return text;
}

struct Class {
    const std::vector<std::int32_t> &vertices;
    const char *colour, *name;
};

void append_circle(std::string &text, Pixel centre, std::int64_t radius) {
    text += "<circle cx=\"" + std::to_string(centre.x) + "\" cy=\"" + std::to_string(centre.y) + "\" r=\"" +
            std::to_string(radius) + "\"/>";
}

std::string legend(const std::array<Class, 3> &classes, std::size_t n_vertices, std::size_t n_faces,
                   std::int64_t top) {
    std::string text = "<g font-family=\"sans-serif\" font-size=\"220\">\n";
    const std::int64_t middle = top + legend_height / 2;
    std::int64_t left = 0;
    for (const Class &entry : classes) {
        text += "<g fill=\"" + std::string(entry.colour) + "\">";
        append_circle(text, {left + 80, middle}, 80);
        text += "<text x=\"" + std::to_string(left + 220) + "\" y=\"" + std::to_string(middle + 80) + "\">" +
                entry.name + ": " + std::to_string(entry.vertices.size()) + "</text></g>\n";
        left += 2300;
    }
    return text + "<text x=\"" + std::to_string(left) + "\" y=\"" + std::to_string(middle + 80) +
           "\" fill=\"#444\">" + std::to_string(n_vertices) + " vertices, " + std::to_string(n_faces) +
           " faces</text>\n</g>\n";
}

} // namespace

Picture picture(const Arrays &mesh) {
    std::vector<std::array<std::int32_t, 2>> edges; // smaller vertex first, once per face
    edges.reserve(mesh.faces.size());
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const auto [v, w] = std::minmax(mesh.faces[i], mesh.faces[i % 4 == 3 ? i - 3 : i + 1]);
        edges.push_back({v, w});
    }
    std::sort(edges.begin(), edges.end());
    std::vector<std::int32_t> valence(mesh.points.size() / 3, 0);
    std::vector<bool> boundary(mesh.points.size() / 3, false);
    for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
        while (last < edges.size() && edges[last] == edges[first])
            ++last;
        for (std::int32_t v : edges[first]) {
            ++valence[static_cast<std::size_t>(v)];
            if (last - first == 1)
                boundary[static_cast<std::size_t>(v)] = true;
        }
    }
    Picture picture;
    picture.mesh = &mesh;
    for (std::size_t v = 0; v < valence.size(); ++v) {
        if (valence[v] == 0 || valence[v] == 4 || boundary[v])
            continue;
        (valence[v] == 3   ? picture.singular3
         : valence[v] == 5 ? picture.singular5
                           : picture.singular_other)
            .push_back(static_cast<std::int32_t>(v));
    }
    return picture;
}

void write_svg(const std::string &path, const Picture &picture) {
    const Arrays &mesh = *picture.mesh;
    const Drawing drawing = project(mesh);
    const std::int64_t stroke = std::clamp<std::int64_t>(std::llround(drawing.edge / 25), 1, 12);
    const std::int64_t radius = std::clamp<std::int64_t>(std::llround(drawing.edge / 4), 8, 90);
    const std::int64_t width = std::max<std::int64_t>(drawing.width, 9800); // the legend's
    const std::array<Class, 3> classes{{{picture.singular3, "#1f5fbf", "valence 3"},
                                        {picture.singular5, "#d0222c", "valence 5"},
                                        {picture.singular_other, "#222", "other"}}};

    const std::string corner = std::to_string(-margin), full_width = std::to_string(width + 2 * margin),
                      full_height = std::to_string(drawing.height + 2 * margin + legend_height);
    std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"";
    text += corner + " " + corner + " " + full_width + " " + full_height + "\">\n";
    // Its own white paper, or a dark page would swallow lines and letters.
    text += "<rect x=\"" + corner + "\" y=\"" + corner + "\" width=\"" + full_width + "\" height=\"" +
            full_height + "\" fill=\"#fff\"/>\n";
    text += "<path fill=\"#f2f0e6\" stroke=\"#888\" stroke-linejoin=\"round\" stroke-width=\"" +
            std::to_string(stroke) + "\" d=\"" + faces_path(mesh, drawing) + "\"/>\n";
    if (!picture.outlines.empty())
        text += "<path fill=\"none\" stroke=\"#1a7a3c\" stroke-linejoin=\"round\" stroke-width=\"" +
                std::to_string(4 * stroke) + "\" d=\"" + outlines_path(picture, drawing) + "\"/>\n";
    for (std::size_t colour = 0; colour < colours.size(); ++colour)
        if (const std::string path_data = lines_path(picture.lines, drawing, colour); !path_data.empty())
            text += "<path fill=\"none\" stroke=\"" + std::string(colours[colour]) +
                    "\" stroke-linecap=\"round\" stroke-width=\"" + std::to_string(3 * stroke) + "\" d=\"" +
                    path_data + "\"/>\n";
    for (const Class &entry : classes) {
        text += "<g fill=\"" + std::string(entry.colour) + "\">";
        for (std::int32_t v : entry.vertices)
            append_circle(text, drawing.pixels[static_cast<std::size_t>(v)], radius);
        text += "</g>\n";
    }
    text += legend(classes, mesh.points.size() / 3, mesh.faces.size() / 4, drawing.height + margin / 2);
    save(path, text + "</svg>\n");
}

} // namespace alphamst::io
