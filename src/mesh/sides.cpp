#include "mesh/sides.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "failure.h"

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

void test_corners(Faces faces, std::size_t n_vertices, bool triangles) {
    for (std::size_t c = 0; c < faces.size(); c += 4) {
        const auto face = static_cast<std::int64_t>(c / 4);
        const std::size_t end = c + (triangles && faces[c + 3] == -1 ? 3 : 4);
        for (std::size_t i = c; i < end; ++i)
            if (faces[i] < 0 || static_cast<std::size_t>(faces[i]) >= n_vertices)
                throw Failure(Fault::range,
                              "face {} has corner {}, but the mesh has " + std::to_string(n_vertices) +
                                  " vertices; correct the corner or add the vertex",
                              Entity::face, {face, faces[i]});
        for (std::size_t i = c; i < end; ++i)
            for (std::size_t j = i + 1; j < end; ++j)
                if (faces[i] == faces[j])
                    throw Failure(Fault::not_quad,
                                  "face {} has vertex {} at two corners; give it " +
                                      std::string(end == c + 3 ? "three" : "four") + " different corners",
                                  Entity::face, {face, faces[i]});
    }
}

namespace {

// One side of a face, filed under the smaller of its two vertices.
struct Side {
    std::int32_t larger;
    std::int32_t corner;
};

struct Buckets {
    std::vector<std::int32_t> end; // [vertex], one behind its last side
    std::vector<Side> sides;
};

// Counting sort by the smaller vertex, then each bucket by the larger one.
Buckets sort_sides(Faces faces, std::size_t n_vertices) {
    Buckets buckets{std::vector<std::int32_t>(n_vertices + 1), {}};
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

[[noreturn]] void refuse_edge(Faces faces, std::span<const Side> sides) {
    const auto corner = [&](std::size_t i) { return static_cast<std::size_t>(sides[i].corner); };
    const std::int64_t from = faces[corner(0)], to = faces[next_corner(faces, corner(0))];
    if (sides.size() > 2)
        throw Failure(Fault::not_manifold,
                      "face {} is the third one at the edge between vertices {} and {}; split the mesh there",
                      Entity::face, {sides[2].corner / 4, from, to});
    throw Failure(Fault::not_manifold,
                  "faces {} and {} both run from vertex {} to vertex {}; reverse the corners of one of them, "
                  "or split the mesh there if it has only one side",
                  Entity::face, {sides[1].corner / 4, sides[0].corner / 4, from, to});
}

} // namespace

Halfedges pair_sides(Faces faces, std::size_t n_vertices) {
    const Buckets buckets = sort_sides(faces, n_vertices);
    Halfedges halfedges{std::vector<std::int32_t>(faces.size(), -1)};
    const std::span<const Side> sides = buckets.sides;
    for (std::size_t v = 0, i = 0; v < n_vertices; ++v) {
        const auto end = static_cast<std::size_t>(buckets.end[v]);
        while (i < end) {
            std::size_t last = i + 1;
            while (last < end && sides[last].larger == sides[i].larger)
                ++last;
            const auto reversed = [&](std::size_t k) {
                return faces[static_cast<std::size_t>(sides[k].corner)] == sides[k].larger;
            };
            if (last - i > 2 || (last - i == 2 && reversed(i) == reversed(i + 1)))
                refuse_edge(faces, sides.subspan(i, last - i));
            for (; i < last; ++i)
                halfedges.of_corner[static_cast<std::size_t>(sides[i].corner)] =
                    static_cast<std::int32_t>(2 * halfedges.n_edges + (reversed(i) ? 1 : 0));
            ++halfedges.n_edges;
        }
    }
    return halfedges;
}

} // namespace alphamst::mesh
