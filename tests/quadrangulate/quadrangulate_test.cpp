#include "quadrangulate/pairing.h"
#include "quadrangulate/quadrangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "bodies.h"
#include "mesh/grids.h"
#include "quadrangulate/halve.h"

namespace alphamst::quadrangulate {
namespace {

using namespace triangles;

TEST(Quadrangulate, AnOddDiscGetsOneVertexOnItsBoundary) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        Input input = seed % 2 == 0 ? lattice(5 + int(seed), 7, seed) : disc(5 + int(seed), 14, seed);
        input.faces.resize(input.faces.size() - 4);
        input.markers.assign(input.n_faces(), 3);
        const QuadArrays quads = input.quads();
        const mesh::QuadMesh mesh = expect_sound(input, quads, 2);
        expect_regions(input, quads);
        // Those that are neither at midpoints nor given are within quads: four in one.
        ASSERT_EQ((quads.points.size() - input.points.size() - 3 * quads.midpoints.size()) % 12, 0U);
        ASSERT_GE(quads.midpoints.size(), 1U);
        if (seed % 2 == 0) {
            EXPECT_EQ(quads.midpoints.size(), 1U);
        }
        for (const auto &[edge, vertex] : quads.midpoints) {
            EXPECT_TRUE(mesh.on_boundary(vertex));
            EXPECT_EQ(mesh.find_edge(edge[0], edge[1]), -1);
            EXPECT_GE(mesh.find_edge(edge[0], vertex), 0);
            EXPECT_GE(mesh.find_edge(vertex, edge[1]), 0);
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_EQ(quads.points[3 * std::size_t(vertex) + k],
                          (input.points[3 * std::size_t(edge[0]) + k] +
                           input.points[3 * std::size_t(edge[1]) + k]) /
                              2);
            EXPECT_GE(mesh.valence(vertex), 3); // no flat corner
        }
    }
}

// Nothing is left for smoothing to open.
TEST(Quadrangulate, InAPlaneAllCornersAreConvex) {
    for (unsigned seed = 0; seed < 30; ++seed) {
        Input input = seed % 2 == 0 ? lattice(6 + int(seed), 9, seed) : disc(8 + int(seed), 11, seed);
        for (std::size_t i = 2; i < input.points.size(); i += 3)
            input.points[i] = 0;
        input.faces.resize(input.faces.size() - 4 * (seed % 3));
        const QuadArrays quads = input.quads();
        double least = 1;
        for (std::size_t f = 0; f < quads.faces.size(); f += 4)
            for (const double sine : sines(quads.points, {quads.faces[f], quads.faces[f + 1],
                                                          quads.faces[f + 2], quads.faces[f + 3]}))
                least = std::min(least, sine);
        EXPECT_GT(least, 0) << seed;
    }
}

TEST(Quadrangulate, RegionsStayApart) {
    for (unsigned seed = 0; seed < 30; ++seed) {
        Input input = disc(12, 9, seed);
        // Borders cut through the rhombi, so that regions are odd or even as it happens.
        for (std::size_t f = 0; f < input.n_faces(); ++f)
            input.markers.push_back(f % 24 < 7 + seed ? 1 : f / 24 < 4 ? 2 : 5);
        const QuadArrays quads = input.quads();
        expect_sound(input, quads, 2);
        expect_regions(input, quads);
        EXPECT_LT(quads.midpoints.size(), input.n_faces() / 8);
    }
}

// Two odd regions of a closed surface: no way out but their border.
TEST(Quadrangulate, OddRegionsMeetAtAVertexOnTheirBorder) {
    Input input = sphere(3);
    for (std::size_t f = 0; f < input.n_faces(); ++f)
        input.markers.push_back(f == 17 ? 1 : 2);
    const QuadArrays quads = input.quads();
    const mesh::QuadMesh mesh = expect_sound(input, quads);
    ASSERT_EQ(quads.midpoints.size(), 1U);
    const auto [edge, vertex] = quads.midpoints.front();
    std::set<int> markers;
    for (const int face : mesh.faces_around(vertex))
        markers.insert(input.markers[std::size_t(quads.origin[std::size_t(face)])]);
    EXPECT_EQ(markers, (std::set<int>{1, 2}));
    EXPECT_EQ(mesh.valence(vertex), 4); // cut anew in the one region, five quads in the other
    EXPECT_GT(smallest_sine(quads), 0.01);
}

TEST(Quadrangulate, CurvesStay) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        Input input = lattice(10, 10, seed);
        for (std::size_t f = 0; f < input.n_faces(); f += 3)
            input.curves.push_back({input.faces[4 * f + 1], input.faces[4 * f]}); // in either direction
        const QuadArrays quads = input.quads();
        const mesh::QuadMesh mesh = expect_sound(input, quads, 2);
        for (const Edge &curve : input.curves) {
            const std::vector<Edge> edges = pieces(quads, curve);
            EXPECT_EQ(edges.front()[0], curve[0]);
            EXPECT_EQ(edges.back()[1], curve[1]);
            for (const auto &[v, w] : edges)
                EXPECT_GE(mesh.find_edge(v, w), 0);
        }
    }
}

// Between all sides being curves no triangle has a mate: those of a closed surface are split.
TEST(Quadrangulate, CurvesEverywhere) {
    for (Input input : {sphere(2), lattice(6, 5, 1)}) {
        const bool closed = input.n_points() == 2 + input.n_faces() / 2;
        const mesh::Halfedges halfedges = mesh::pair_sides(input.faces, input.n_points());
        std::set<Edge> edges;
        for (std::size_t c = 0; c < input.faces.size(); ++c)
            if (input.faces[c] >= 0)
                edges.insert({std::min(input.faces[c], input.faces[mesh::next_corner(input.faces, c)]),
                              std::max(input.faces[c], input.faces[mesh::next_corner(input.faces, c)])});
        EXPECT_EQ(edges.size(), halfedges.n_edges);
        input.curves.assign(edges.begin(), edges.end());
        const QuadArrays quads = input.quads();
        const mesh::QuadMesh mesh = expect_sound(input, quads);
        EXPECT_GT(smallest_sine(quads), 0.01);
        if (closed) {
            EXPECT_EQ(quads.origin.size(), 3 * input.n_faces());
            EXPECT_EQ(quads.midpoints.size(), halfedges.n_edges);
        } else { // the boundary stays, as their number is even
            EXPECT_TRUE(std::none_of(quads.midpoints.begin(), quads.midpoints.end(),
                                     [&](const auto &m) { return mesh.on_boundary(m.vertex); }));
        }
        for (const Edge &curve : input.curves)
            for (const auto &[v, w] : pieces(quads, curve))
                EXPECT_GE(mesh.find_edge(v, w), 0);
    }
}

TEST(Quadrangulate, GivenQuadsStay) {
    const Input input = lattice(6, 6, 5, 3);
    const QuadArrays quads = input.quads();
    EXPECT_NO_THROW(expect_sound(input, quads, 2).check());
    EXPECT_TRUE(quads.midpoints.empty());
    std::set<Quad> found;
    for (std::size_t q = 0; q < quads.origin.size(); ++q)
        found.insert(quad(quads, q));
    for (std::size_t f = 0; f < input.n_faces(); ++f)
        if (const std::int32_t *c = &input.faces[4 * f]; c[3] >= 0) {
            EXPECT_TRUE(found.contains({c[0], c[1], c[2], c[3]})) << f;
        }
}

Input prism() {
    Input input;
    input.points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1};
    input.add(0, 2, 1);
    input.add(3, 4, 5);
    input.add(0, 1, 4, 3);
    input.add(1, 2, 5, 4);
    input.add(2, 0, 3, 5);
    return input;
}

TEST(Quadrangulate, ARowOfQuadsLeadsFromTriangleToTriangle) {
    const Input input = prism();
    const QuadArrays quads = input.quads();
    const mesh::QuadMesh mesh = expect_sound(input, quads);
    EXPECT_EQ(mesh.n_faces(), 6);
    EXPECT_EQ(mesh.n_vertices(), 8);
    EXPECT_NO_THROW(mesh.check());
}

// Some faces of a mesh of quads cut in two triangles, apart from each other, and two quads.
Input scattered(const mesh::Grid &grid, unsigned seed) {
    std::mt19937 random(seed);
    Input input;
    input.points = grid.points;
    for (std::size_t f = 0; f < grid.faces.size() / 4; ++f) {
        Quad c;
        std::copy_n(grid.faces.begin() + std::ptrdiff_t(4 * f), 4, c.begin());
        input.markers.push_back(int(f / 20));
        if (random() % 8 != 0) {
            input.add(c[0], c[1], c[2], c[3]);
            continue;
        }
        std::rotate(c.begin(), c.begin() + random() % 2, c.end());
        const auto v = static_cast<std::int32_t>(input.n_points()), w = v + 1;
        const auto add_point = [&](const std::array<double, 4> &weights) {
            for (std::size_t k = 0; k < 3; ++k) {
                double x = 0;
                for (std::size_t i = 0; i < 4; ++i)
                    x += weights[i] * input.points[3 * std::size_t(c[i]) + k];
                input.points.push_back(x);
            }
        };
        add_point({0.375, 0.375, 0.125, 0.125});
        add_point({0.125, 0.125, 0.375, 0.375});
        input.add(c[0], c[1], v);
        input.add(c[1], c[2], w, v);
        input.add(c[2], c[3], w);
        input.add(c[3], c[0], v, w);
        input.markers.insert(input.markers.end(), 3, input.markers.back());
    }
    return input;
}

// Rows that turn, that cross borders and that wait for one another.
TEST(Quadrangulate, ScatteredTriangles) {
    std::size_t turns = 0, most = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        const bool closed = seed % 2 == 0;
        const Input input = scattered(closed ? mesh::torus(12, 8) : mesh::plane(12, 8), seed);
        const QuadArrays quads = input.quads();
        const mesh::QuadMesh mesh = expect_sound(input, quads);
        EXPECT_NO_THROW(mesh.check());
        const auto on_boundary = [&](const QuadArrays::Midpoint &midpoint) {
            return mesh.on_boundary(midpoint.vertex);
        };
        if (closed) {
            EXPECT_TRUE(std::none_of(quads.midpoints.begin(), quads.midpoints.end(), on_boundary));
        } else {
            expect_regions(input, quads);
        }
        turns += quads.points.size() / 3 - input.n_points() - quads.midpoints.size();
        most = std::max(most, quads.midpoints.size());
    }
    EXPECT_GT(turns, 0U);
    EXPECT_GT(most, 10U);
}

TEST(Quadrangulate, SmallestComponents) {
    Input pillow;
    pillow.points = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    pillow.add(0, 1, 2);
    Input one = pillow;
    pillow.add(2, 1, 0);
    const QuadArrays six_quads = pillow.quads();
    EXPECT_EQ(expect_sound(pillow, six_quads).n_faces(), 6);

    const QuadArrays three_quads = one.quads();
    const mesh::QuadMesh mesh = expect_sound(one, three_quads, 2);
    EXPECT_EQ(mesh.n_faces(), 3);
    EXPECT_EQ(mesh.n_vertices(), 7);
    EXPECT_NO_THROW(mesh.check());
}

TEST(Quadrangulate, Split) {
    for (Input input : {sphere(1), lattice(5, 4, 3), prism()}) {
        input.curves = {{input.faces[1], input.faces[0]}};
        const QuadArrays quads = input.quads(Quadrangulation::split);
        const mesh::QuadMesh mesh = expect_sound(input, quads);
        EXPECT_NO_THROW(mesh.check());
        std::size_t sides = 0;
        for (const std::int32_t v : input.faces)
            sides += v >= 0;
        EXPECT_EQ(quads.origin.size(), sides);
        const std::size_t n_edges = mesh::pair_sides(input.faces, input.n_points()).n_edges;
        EXPECT_EQ(quads.points.size() / 3, input.n_points() + n_edges + input.n_faces());
        EXPECT_EQ(pieces(quads, input.curves[0]).size(), 2U);
        EXPECT_GT(smallest_sine(quads), 0.2);
    }
}

TEST(Quadrangulate, SameAgain) {
    const Input input = random_sphere(9, 2000);
    const QuadArrays first = input.quads(), second = input.quads();
    EXPECT_EQ(first.faces, second.faces);
    EXPECT_EQ(first.points, second.points);
}

constexpr PairingRules cad{.sharp_angle = 40};

// Squares cut in four or in two: all sides of all boxes can do without their edges.
TEST(Quadrangulate, NoQuadIsOverASharpEdge) {
    for (const bool crosses : {false, true})
        for (int n = 1; n < 5; ++n) {
            const Input body = box(1, n, 2 * n + 1, crosses);
            const QuadArrays quads = quadrangulate(body.polygons(), Quadrangulation::pair, cad);
            expect_sound(body, quads);
            EXPECT_EQ(quads.points.size(), body.points.size());
            EXPECT_TRUE(quads.crossed.empty());
            EXPECT_GT(smallest_sine(quads), 0.5);
            for (std::size_t q = 0; q < quads.origin.size(); ++q)
                EXPECT_TRUE(is_on_one_side(body, quad(quads, q)));
        }
}

TEST(Quadrangulate, AnOddSideIsCrossedAndSaysSo) {
    const Input body = octahedron();
    const QuadArrays quads = quadrangulate(body.polygons(), Quadrangulation::pair, cad);
    expect_pairs(body, quads);
    EXPECT_EQ(quads.crossed.size(), 4U);
}

TEST(Quadrangulate, ATetrahedronIsSplit) {
    Input body;
    body.points = {1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1};
    body.add(0, 1, 3);
    body.add(0, 2, 1);
    body.add(0, 3, 2);
    body.add(1, 2, 3);
    const QuadArrays quads = quadrangulate(body.polygons(), Quadrangulation::pair, cad);
    EXPECT_EQ(expect_sound(body, quads).n_faces(), 12);
    EXPECT_GT(smallest_sine(quads), 0.4);
}

// No pairs of triangles around a round hole are convex: quads are added inside, the boundary stays.
TEST(Quadrangulate, AnEvenPlateKeepsItsBoundary) {
    for (const int around : {16, 32, 64}) {
        const Input input = plate(around, 2);
        ASSERT_EQ(input.n_faces() % 2, 0U);
        const QuadArrays quads = input.quads();
        EXPECT_NO_THROW(expect_sound(input, quads, 2).check());
        EXPECT_TRUE(quads.midpoints.empty());
        EXPECT_GT(smallest_sine(quads), 0.01);
    }
}

// Two pairs of triangles among quads that would be flat, one on the boundary and one on the border of a
// region.
TEST(Quadrangulate, EvenTrianglesAmongQuadsKeepTheBoundary) {
    const mesh::Grid grid = mesh::plane(10, 10);
    Input input;
    input.points = grid.points;
    for (std::size_t f = 0; f < grid.faces.size() / 4; ++f) {
        const std::int32_t *c = &grid.faces[4 * f];
        if (f == 4 || f == 75) {
            input.add(c[0], c[1], c[2]);
            input.add(c[2], c[3], c[0]);
        } else if (f != 5 && f != 74) {
            input.add(c[0], c[1], c[2], c[3]);
        } else {
            input.add(c[0], c[1], c[3]);
            input.add(c[1], c[2], c[3]);
        }
    }
    const QuadArrays quads = input.quads();
    const mesh::QuadMesh mesh = expect_sound(input, quads, 2);
    EXPECT_NO_THROW(mesh.check());
    for (const auto &[edge, vertex] : quads.midpoints)
        EXPECT_FALSE(mesh.on_boundary(vertex));
}

TEST(Quadrangulate, NewBoundaryVerticesCanBeForbidden) {
    const PairingRules rules{.new_boundary_vertices = false};
    Input input = lattice(6, 5, 2);
    EXPECT_EQ(quadrangulate(input.polygons(), Quadrangulation::pair, rules).origin.size(), 30U);
    EXPECT_EQ(mesh::failure_of([&] { quadrangulate(input.polygons(), Quadrangulation::split, rules); }).fault,
              Fault::argument);
    input.faces.resize(input.faces.size() - 4);
    const Failure failure =
        mesh::failure_of([&] { quadrangulate(input.polygons(), Quadrangulation::pair, rules); });
    EXPECT_EQ(failure.fault, Fault::argument);
    EXPECT_EQ(failure.entity, Entity::face);
    EXPECT_NE(failure.text.find("59"), std::string::npos);
}

Failure refusal(const Input &input) {
    return mesh::failure_of([&] { input.quads(); });
}

TEST(Quadrangulate, Refusals) {
    const std::int32_t last = 7;
    Input input = octahedron();
    input.faces[4 * last] = 3;
    Failure failure = refusal(input);
    EXPECT_EQ(failure.fault, Fault::not_quad);
    EXPECT_EQ(failure.ids, (std::vector<std::int64_t>{last, 3}));

    input = octahedron();
    input.faces[4 * last + 1] = 6;
    failure = refusal(input);
    EXPECT_EQ(failure.fault, Fault::range);
    EXPECT_EQ(failure.ids, (std::vector<std::int64_t>{last, 6}));

    input = octahedron();
    input.faces[4 * last + 2] = -1; // "none" is for the last of four only
    EXPECT_EQ(refusal(input).fault, Fault::range);

    input = octahedron();
    std::swap(input.faces[4 * last], input.faces[4 * last + 1]);
    failure = refusal(input);
    EXPECT_EQ(failure.fault, Fault::not_manifold);
    EXPECT_EQ(failure.ids.front(), last);

    input = octahedron();
    input.points.insert(input.points.end(), {1, 1, 1});
    input.add(2, 0, 6);
    EXPECT_EQ(refusal(input).fault, Fault::not_manifold);

    input = octahedron();
    input.points[4] = std::nan("");
    failure = refusal(input);
    EXPECT_EQ(failure.fault, Fault::not_finite);
    EXPECT_EQ(failure.ids, (std::vector<std::int64_t>{1}));
}

} // namespace
} // namespace alphamst::quadrangulate
