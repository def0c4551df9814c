#include "mesh/orient.h"

#include <utility>

#include "index.h"
#include "mesh/components.h"
#include "mesh/defects.h"

namespace alphamst::mesh {
namespace {

// Twice the area in the plane, above 0 for a face that is counter-clockwise.
double signed_area(Coordinates points, Faces faces, std::size_t face) {
    const auto x = [&](std::size_t k, std::size_t axis) {
        return points[3 * at(faces[4 * face + k]) + axis];
    };
    const std::size_t last = is_triangle(faces, face) ? 2 : 3; // of a triangle the diagonals are two sides
    return (x(2, 0) - x(0, 0)) * (x(last, 1) - x(1, 1)) - (x(2, 1) - x(0, 1)) * (x(last, 0) - x(1, 0));
}

bool any_clockwise(Coordinates points, Faces faces) {
    for (std::size_t f = 0; f < faces.size() / 4; ++f)
        if (signed_area(points, faces, f) < 0)
            return true;
    return false;
}

// Whether some edge has two faces that run along it the same way.
bool runs_both_ways(Faces faces, const EdgeSides &sides) {
    bool any = false;
    visit_edges(sides, [&](std::span<const Side> edge) {
        any = any || (edge.size() == 2 && runs_down(faces, edge[0]) == runs_down(faces, edge[1]));
    });
    return any;
}

// [component] whether its first face is to be turned over.
std::vector<bool> wrong_way(int dim, Coordinates points, Faces faces, const Components &components) {
    const std::size_t n = components.one_sided.size();
    std::vector<double> area(n);
    std::vector<std::int64_t> surplus(n); // of faces that run as the first does
    for (std::size_t f = 0; f < faces.size() / 4; ++f) {
        const std::size_t component = at(components.of_face[f]);
        const bool against = components.against[f];
        surplus[component] += against ? -1 : 1;
        if (dim == 2)
            area[component] += (against ? -1 : 1) * signed_area(points, faces, f);
    }
    std::vector<bool> wrong(n);
    for (std::size_t i = 0; i < n; ++i)
        wrong[i] = area[i] != 0 ? area[i] < 0 : surplus[i] < 0;
    return wrong;
}

} // namespace

Oriented orient(int dim, Coordinates points, Faces faces) {
    test_lengths(dim, points, faces);
    test_arrays(points, faces, true);
    const EdgeSides sides = sort_sides(faces, points.size() / 3);
    const bool mixed = runs_both_ways(faces, sides);
    if (!mixed && (dim != 2 || !any_clockwise(points, faces)))
        return {};
    if (mixed)
        if (const std::optional<Failure> failure = find_lasting_defects(points, faces))
            throw *failure;
    const Components components = find_components(faces, neighbours(faces, sides));
    const std::vector<bool> wrong = wrong_way(dim, points, faces, components);
    Oriented oriented{{faces.begin(), faces.end()}};
    for (std::size_t f = 0; f < faces.size() / 4; ++f) {
        if (components.against[f] == wrong[at(components.of_face[f])])
            continue;
        if (oriented.n_turned++ == 0)
            oriented.first_turned = static_cast<std::int64_t>(f);
        std::int32_t *corners = &oriented.faces[4 * f];
        std::swap(corners[1], corners[is_triangle(faces, f) ? 2 : 3]);
    }
    return oriented.n_turned > 0 ? oriented : Oriented{};
}

} // namespace alphamst::mesh
