#include "mesh/sides.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "failure.h"
#include "mesh/defects.h"

namespace alphamst::mesh {

void test_lengths(int dim, Coordinates points, Faces faces) {
    if (dim != 2 && dim != 3)
        throw Failure(Fault::argument, "the dimension of a mesh is 2 or 3");
    if (points.size() % 3 != 0)
        throw Failure(Fault::argument, "the length of the points is not a multiple of 3");
    if (faces.size() % 4 != 0)
        throw Failure(Fault::argument, "the length of the faces is not a multiple of 4");
    // OpenMesh's ids are int, and each corner may bring an edge of two half-edges.
    constexpr std::size_t most = std::numeric_limits<int>::max();
    if (points.size() / 3 > most || faces.size() > most / 2)
        throw Failure(Fault::range, "the mesh has more entities than 32-bit ids can name");
}

void test_points(Coordinates points) {
    std::array<double, 3> low, high;
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto vertex = static_cast<std::int64_t>(i / 3);
        if (!std::isfinite(points[i]))
            throw Failure(Fault::not_finite,
                          "vertex {} has a coordinate that is infinite or not a number; give it a finite one",
                          Entity::vertex, {vertex});
        if (std::abs(points[i]) > largest_coordinate)
            throw Failure(Fault::range,
                          "vertex {} has a coordinate beyond 1e30; give the mesh in a larger unit of length",
                          Entity::vertex, {vertex});
        low[i % 3] = std::min(low[i % 3], points[i]);
        high[i % 3] = std::max(high[i % 3], points[i]);
    }
    if (points.empty())
        return;
    const double extent = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
    if (extent > 0 && extent < least_extent)
        throw Failure(Fault::range, "the mesh is smaller than 1e-30 in every direction, so that areas could "
                                    "become 0; give it in a smaller unit of length");
}

void test_arrays(Coordinates points, Faces faces, bool triangles) {
    const std::size_t n_vertices = points.size() / 3;
    if (!std::ranges::all_of(points, [](double x) { return std::isfinite(x); }))
        throw find_defects(points, faces, n_vertices, triangles);
    test_points(points);
    for (std::size_t f = 0; f < faces.size() / 4; ++f)
        if (!has_corners(faces, f, n_vertices, triangles))
            throw find_defects(points, faces, n_vertices, triangles);
}

// Counting sort by the smaller vertex, then each bucket by the larger one.
EdgeSides sort_sides(Faces faces, std::size_t n_vertices) {
    EdgeSides buckets{std::vector<std::int32_t>(n_vertices + 1), {}};
    auto &end = buckets.end;
    for (std::size_t c = 0; c < faces.size(); ++c)
        if (faces[c] >= 0)
            ++end[static_cast<std::size_t>(std::min(faces[c], faces[next_corner(faces, c)])) + 1];
    std::partial_sum(end.begin(), end.end(), end.begin());
    buckets.sides.resize(static_cast<std::size_t>(end.back()));
    for (std::size_t c = 0; c < faces.size(); ++c) {
        if (faces[c] < 0)
            continue;
        const auto [smaller, larger] = std::minmax(faces[c], faces[next_corner(faces, c)]);
        const auto place = end[static_cast<std::size_t>(smaller)]++;
        buckets.sides[static_cast<std::size_t>(place)] = {larger, static_cast<std::int32_t>(c)};
    }
    std::ptrdiff_t begin = 0;
    for (std::size_t v = 0; v < n_vertices; ++v) {
        std::sort(buckets.sides.begin() + begin, buckets.sides.begin() + end[v],
                  [](const Side &a, const Side &b) {
                      return a.larger != b.larger ? a.larger < b.larger : a.corner < b.corner;
                  });
        begin = end[v];
    }
    return buckets;
}

Halfedges pair_sides(Faces faces, std::size_t n_vertices) {
    Halfedges halfedges{std::vector<std::int32_t>(faces.size(), -1)};
    visit_edges(sort_sides(faces, n_vertices), [&](std::span<const Side> sides) {
        if (sides.size() > 2 ||
            (sides.size() == 2 && runs_down(faces, sides[0]) == runs_down(faces, sides[1])))
            throw find_defects({}, faces, n_vertices, true);
        for (const Side &side : sides)
            halfedges.of_corner[static_cast<std::size_t>(side.corner)] =
                static_cast<std::int32_t>(2 * halfedges.n_edges + (runs_down(faces, side) ? 1 : 0));
        ++halfedges.n_edges;
    });
    return halfedges;
}

} // namespace alphamst::mesh
