#include "draw/shade.h"

#include <algorithm>
#include <cmath>

namespace alphamst::draw {
namespace {

constexpr double cells = 1250; // along the longer side

Vector3 middle(const io::Arrays &mesh, const Drawing &drawing, std::size_t face) {
    Vector3 sum{};
    for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t c = 0; c < 3; ++c)
            sum[c] += drawing.points[static_cast<std::size_t>(mesh.faces[4 * face + k])][c] / 4;
    return sum;
}

// Each edge once one way and once the other.
bool is_closed(const io::Arrays &mesh) {
    std::vector<std::array<std::int32_t, 2>> edges;
    edges.reserve(mesh.faces.size());
    for (std::size_t i = 0; i < mesh.faces.size(); ++i)
        edges.push_back({mesh.faces[i], mesh.faces[i % 4 == 3 ? i - 3 : i + 1]});
    std::vector<std::array<std::int32_t, 2>> opposite = edges;
    for (auto &[from, to] : opposite)
        std::swap(from, to);
    std::sort(edges.begin(), edges.end());
    std::sort(opposite.begin(), opposite.end());
    return edges == opposite;
}

// Of a closed mesh, times twelve.
double volume(const io::Arrays &mesh, const Drawing &drawing) {
    double sum = 0;
    for (std::size_t f = 0; f < mesh.faces.size() / 4; ++f)
        sum += dot_product(middle(mesh, drawing, f), normal(mesh, drawing.points, f));
    return sum;
}

} // namespace

Scene::Scene(const io::Arrays &mesh, const Drawing &drawing)
    : mesh_(mesh), drawing_(drawing), raster_(mesh, drawing.points, static_cast<double>(drawing.width),
                                              static_cast<double>(drawing.height), longer_side / cells),
      closed_(is_closed(mesh)), is_corner_(drawing.points.size(), false) {
    if (closed_ && volume(mesh, drawing) < 0)
        outside_ = -1;
    const std::size_t n = mesh.faces.size() / 4;
    const std::vector<bool> nearest = raster_.nearest(n);
    std::vector<double> depth(n);
    for (std::size_t f = 0; f < n; ++f) {
        const Vector3 centre = middle(mesh, drawing, f);
        depth[f] = centre[2];
        // A face may be too small for a cell of its own.
        if ((closed_ && is_away(f)) || !(nearest[f] || raster_.shows(centre)))
            continue;
        faces_.push_back(f);
        for (std::size_t k = 0; k < 4; ++k)
            is_corner_[static_cast<std::size_t>(mesh.faces[4 * f + k])] = true;
    }
    std::stable_sort(faces_.begin(), faces_.end(),
                     [&](std::size_t a, std::size_t b) { return depth[a] < depth[b]; });
}

// Of a quad that is not plane the half that faces the eye may be seen.
bool Scene::is_away(std::size_t face) const {
    const auto at = [&](std::size_t k) -> const Vector3 & {
        return drawing_.points[static_cast<std::size_t>(mesh_.faces[4 * face + k])];
    };
    const Vector3 diagonal = difference(at(2), at(0));
    return outside_ * cross_product(difference(at(1), at(0)), diagonal)[2] <= 0 &&
           outside_ * cross_product(diagonal, difference(at(3), at(0)))[2] <= 0;
}

bool Scene::shows_inside(std::size_t face) const { return !closed_ && is_away(face); }

double Scene::level(std::size_t face) const {
    constexpr int tones = 40; // more are not told apart, and equal ones share a path
    const Vector3 light = unit_vector({-0.45, 0.6, 0.75});
    const double side = shows_inside(face) ? -outside_ : outside_;
    const double lit = side * dot_product(unit_vector(normal(mesh_, drawing_.points, face)), light);
    // Also what looks away from the light a little: the eye is shown no black.
    return std::round(std::clamp((lit + 0.35) / 1.35, 0.0, 1.0) * tones) / tones;
}

std::string Scene::tone(std::size_t face) const {
    constexpr Colour blue_dark{74, 88, 112}, blue_light{238, 242, 248};
    constexpr Colour sand_dark{112, 96, 70}, sand_light{246, 236, 214};
    const bool inside = shows_inside(face);
    return text_of(mix(inside ? sand_dark : blue_dark, inside ? sand_light : blue_light, level(face)));
}

std::string Scene::tone(std::size_t face, const Colour &colour) const {
    constexpr double dark = 0.5; // as much as that of the plain tones is of their light
    const Colour shadow{dark * colour[0], dark * colour[1], dark * colour[2]};
    return text_of(mix(shadow, colour, level(face)));
}

bool Scene::shows(std::int32_t vertex) const {
    const auto v = static_cast<std::size_t>(vertex);
    return is_corner_[v] && raster_.shows(drawing_.points[v]);
}

bool Scene::shows_edge(std::int32_t v, std::int32_t w) const {
    const Vector3 &a = drawing_.points[static_cast<std::size_t>(v)];
    const Vector3 &b = drawing_.points[static_cast<std::size_t>(w)];
    return raster_.shows({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2});
}

} // namespace alphamst::draw
