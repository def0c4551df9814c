#include "draw/svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "draw/shade.h"
#include "draw/tint.h"
#include "draw/view.h"
#include "io/file.h"
#include "io/number.h"

namespace alphamst::draw {
namespace {

// Coordinates are whole numbers, so relative paths are short and exact.
constexpr std::int64_t margin = 250, legend_height = 500;

// A minus sign separates as well as a blank.
void append_coordinate(std::string &text, std::int64_t number, bool first) {
    if (!first && number >= 0)
        text += ' ';
    io::append_number(text, number);
}

// A closed loop in coordinates relative to `from`, which becomes its first corner.
void append_loop(std::string &text, const std::vector<Pixel> &corners, Pixel &from) {
    Pixel here = from;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        if (k < 2)
            text += k == 0 ? 'm' : 'l';
        append_coordinate(text, corners[k].x - here.x, k < 2);
        append_coordinate(text, corners[k].y - here.y, false);
        here = corners[k];
    }
    text += 'z';
    from = corners.front();
}

void append_face(std::string &text, const io::Arrays &mesh, const Drawing &drawing, std::size_t face,
                 Pixel &here) {
    std::vector<Pixel> corners(4);
    for (std::size_t k = 0; k < 4; ++k)
        corners[k] = drawing.pixels[static_cast<std::size_t>(mesh.faces[4 * face + k])];
    const std::int64_t twice_area = (corners[2].x - corners[0].x) * (corners[3].y - corners[1].y) -
                                    (corners[2].y - corners[0].y) * (corners[3].x - corners[1].x);
    if (twice_area > 0) // one direction for all, or front and back would leave a hole
        std::swap(corners[1], corners[3]);
    append_loop(text, corners, here);
}

std::string faces_path(const io::Arrays &mesh, const Drawing &drawing) {
    std::string text;
    Pixel here{0, 0};
    for (std::size_t f = 0; f < mesh.faces.size() / 4; ++f)
        append_face(text, mesh, drawing, f, here);
    return text;
}

// One path a colour; their edges come on top.
std::string coloured_paths(const Picture &picture, const Drawing &drawing) {
    std::map<std::string, std::vector<std::size_t>> faces;
    for (std::size_t f = 0; f < picture.errors.size(); ++f)
        faces[text_of(tint(picture.errors[f]))].push_back(f);
    std::string text;
    for (const auto &[colour, equal] : faces) {
        text += "<path fill=\"" + colour + "\" d=\"";
        Pixel here{0, 0};
        for (const std::size_t f : equal)
            append_face(text, *picture.mesh, drawing, f, here);
        text += "\"/>\n";
    }
    return text;
}

// One path for each run of equal tones, or the order of depths would be lost.
std::string shaded_paths(const Picture &picture, const Drawing &drawing, const Scene &scene) {
    std::string text, last;
    Pixel here{0, 0};
    for (std::size_t f : scene.faces()) {
        const std::string tone =
            picture.errors.empty() ? scene.tone(f) : scene.tone(f, tint(picture.errors[f]));
        if (tone != last) {
            text += (last.empty() ? "" : "\"/>\n") + ("<path fill=\"" + tone) + "\" d=\"";
            last = tone;
            here = {0, 0};
        }
        append_face(text, *picture.mesh, drawing, f, here);
    }
    return last.empty() ? text : text + "\"/>\n";
}

std::string faces(const Picture &picture, const Drawing &drawing, const std::optional<Scene> &scene,
                  std::int64_t stroke) {
    if (scene)
        return "<g stroke=\"#3a4250\" stroke-linejoin=\"round\" stroke-width=\"" +
               std::to_string(std::max<std::int64_t>(stroke / 2, 1)) + "\">\n" +
               shaded_paths(picture, drawing, *scene) + "</g>\n";
    return coloured_paths(picture, drawing) + "<path fill=\"" +
           (picture.errors.empty() ? "#f2f0e6" : "none") +
           "\" stroke=\"#888\" stroke-linejoin=\"round\" stroke-width=\"" + std::to_string(stroke) +
           "\" d=\"" + faces_path(*picture.mesh, drawing) + "\"/>\n";
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

void append_line(std::string &text, Pixel from, Pixel to, Pixel &here) {
    text += 'm';
    append_coordinate(text, from.x - here.x, true);
    append_coordinate(text, from.y - here.y, false);
    text += 'l';
    append_coordinate(text, to.x - from.x, true);
    append_coordinate(text, to.y - from.y, false);
    here = to;
}

// Edge by edge, those that nothing hides.
std::string seen_outlines_path(const Picture &picture, const Drawing &drawing, const Scene &scene) {
    std::string text;
    Pixel here{0, 0};
    for (const std::vector<std::int32_t> &outline : picture.outlines)
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const std::int32_t v = outline[k], w = outline[(k + 1) % outline.size()];
            if (scene.shows_edge(v, w))
                append_line(text, drawing.pixels[static_cast<std::size_t>(v)],
                            drawing.pixels[static_cast<std::size_t>(w)], here);
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

std::string lines_path(const std::vector<Polyline> &lines, const Drawing &drawing,
                       const std::optional<Scene> &scene, std::size_t colour) {
    std::string text;
    Pixel here{0, 0};
    for (const Polyline &line : lines) {
        constexpr auto n = static_cast<std::int64_t>(colours.size());
        if (static_cast<std::size_t>((line.number % n + n) % n) != colour)
            continue;
        if (scene &&
            !(scene->shows_edge(line.from[0], line.from[1]) && scene->shows_edge(line.to[0], line.to[1])))
            continue;
        append_line(text, middle(drawing, line.from), middle(drawing, line.to), here);
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

// What the colours of the faces mean.
std::string error_legend(std::int64_t top) {
    std::string text = "<g font-family=\"sans-serif\" font-size=\"220\" fill=\"#444\">\n";
    const std::string baseline = std::to_string(top + 160);
    std::int64_t left = 2300;
    text += "<text x=\"0\" y=\"" + baseline + "\">area / wanted area</text>\n";
    for (const auto &[error, name] :
         {std::pair(-strongest_error, "1/4"), std::pair(-strongest_error / 2, "1/2"), std::pair(0.0, "1"),
          std::pair(strongest_error / 2, "2"), std::pair(strongest_error, "4")}) {
        text += "<rect x=\"" + std::to_string(left) + "\" y=\"" + std::to_string(top) +
                "\" width=\"160\" height=\"160\" stroke=\"#888\" stroke-width=\"10\" fill=\"" +
                text_of(tint(error)) + "\"/><text x=\"" + std::to_string(left + 220) + "\" y=\"" + baseline +
                "\">" + name + "</text>\n";
        left += 1000;
    }
    return text + "</g>\n";
}

} // namespace

Picture picture(const io::Arrays &mesh) {
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
    const io::Arrays &mesh = *picture.mesh;
    const Drawing drawing = project(mesh);
    std::optional<Scene> scene;
    if (drawing.curved)
        scene.emplace(mesh, drawing);
    const std::int64_t stroke = std::clamp<std::int64_t>(std::llround(drawing.edge / 25), 1, 12);
    const std::int64_t radius = std::clamp<std::int64_t>(std::llround(drawing.edge / 4), 8, 90);
    const std::int64_t width = std::max<std::int64_t>(drawing.width, 9800); // the legend's
    const std::array<Class, 3> classes{{{picture.singular3, "#1f5fbf", "valence 3"},
                                        {picture.singular5, "#d0222c", "valence 5"},
                                        {picture.singular_other, "#222", "other"}}};

    const std::string corner = std::to_string(-margin), full_width = std::to_string(width + 2 * margin),
                      full_height = std::to_string(drawing.height + 2 * margin +
                                                   (picture.errors.empty() ? 1 : 2) * legend_height);
    std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"";
    text += corner + " " + corner + " " + full_width + " " + full_height + "\">\n";
    // Its own white paper, or a dark page would swallow lines and letters.
    text += "<rect x=\"" + corner + "\" y=\"" + corner + "\" width=\"" + full_width + "\" height=\"" +
            full_height + "\" fill=\"#fff\"/>\n";
    text += faces(picture, drawing, scene, stroke);
    if (!picture.outlines.empty())
        text += "<path fill=\"none\" stroke=\"#1a7a3c\" stroke-linejoin=\"round\" stroke-width=\"" +
                std::to_string(4 * stroke) + "\" d=\"" +
                (scene ? seen_outlines_path(picture, drawing, *scene) : outlines_path(picture, drawing)) +
                "\"/>\n";
    for (std::size_t colour = 0; colour < colours.size(); ++colour)
        if (const std::string path_data = lines_path(picture.lines, drawing, scene, colour);
            !path_data.empty())
            text += "<path fill=\"none\" stroke=\"" + std::string(colours[colour]) +
                    "\" stroke-linecap=\"round\" stroke-width=\"" + std::to_string(3 * stroke) + "\" d=\"" +
                    path_data + "\"/>\n";
    for (const Class &entry : classes) {
        text += "<g fill=\"" + std::string(entry.colour) + "\">";
        for (std::int32_t v : entry.vertices)
            if (!scene || scene->shows(v))
                append_circle(text, drawing.pixels[static_cast<std::size_t>(v)], radius);
        text += "</g>\n";
    }
    text += legend(classes, mesh.points.size() / 3, mesh.faces.size() / 4, drawing.height + margin / 2);
    if (!picture.errors.empty())
        text += error_legend(drawing.height + margin / 2 + legend_height);
    io::save(path, text + "</svg>\n");
}

} // namespace alphamst::draw
