#include "mesh/quadrangulate.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <set>

#include "grids.h"
#include "mesh/halve.h"
#include "mesh/pairing.h"

namespace alphamst::mesh {
namespace {

using Edge = std::array<std::int32_t, 2>;
using Triangle = std::array<std::int32_t, 3>;
using Quad = std::array<std::int32_t, 4>;

double least_sine(Points points, const Quad &quad) {
    const std::array<double, 4> sine = sines(points, quad);
    return *std::min_element(sine.begin(), sine.end());
}

struct Input {
    std::vector<double> points;
    std::vector<std::int32_t> faces, markers;
    std::vector<Edge> curves;

    void add(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d = -1) {
        faces.insert(faces.end(), {a, b, c, d});
    }
    std::size_t n_faces() const { return faces.size() / 4; }
    std::size_t n_points() const { return points.size() / 3; }
    Polygons polygons() const { return {points, faces, markers, curves}; }
    Quads quads(Quadrangulation how = Quadrangulation::pair) const { return quadrangulate(polygons(), how); }
};

Input octahedron() {
    Input input;
    input.points = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
    for (const Triangle &t :
         {Triangle{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}})
        input.add(t[0], t[1], t[2]);
    return input;
}

// Each triangle in four, vertices back on the unit sphere.
Input refined(const Input &coarse) {
    Input fine;
    fine.points = coarse.points;
    std::map<Edge, std::int32_t> midpoints;
    const auto midpoint = [&](std::int32_t v, std::int32_t w) {
        const auto [place, is_new] = midpoints.try_emplace({std::min(v, w), std::max(v, w)});
        if (is_new) {
            place->second = static_cast<std::int32_t>(fine.n_points());
            OpenMesh::Vec3d p(0, 0, 0);
            for (std::size_t k = 0; k < 3; ++k)
                p[k] = fine.points[3 * std::size_t(v) + k] + fine.points[3 * std::size_t(w) + k];
            p.normalize();
            fine.points.insert(fine.points.end(), {p[0], p[1], p[2]});
        }
        return place->second;
    };
    for (std::size_t f = 0; f < coarse.n_faces(); ++f) {
        const std::int32_t *t = &coarse.faces[4 * f];
        const std::int32_t ab = midpoint(t[0], t[1]), bc = midpoint(t[1], t[2]), ca = midpoint(t[2], t[0]);
        fine.add(t[0], ab, ca);
        fine.add(ab, t[1], bc);
        fine.add(ca, bc, t[2]);
        fine.add(ab, bc, ca);
    }
    return fine;
}

Input sphere(int levels) {
    Input input = octahedron();
    for (int i = 0; i < levels; ++i)
        input = refined(input);
    return input;
}

// Rings of triangles between two poles of high valence.
Input globe(int around, int rings) {
    Input input;
    const double pi = 3.141592653589793;
    for (int j = 1; j <= rings; ++j)
        for (int i = 0; i < around; ++i) {
            const double b = pi * j / (rings + 1), a = 2 * pi * i / around;
            input.points.insert(input.points.end(),
                                {std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b)});
        }
    input.points.insert(input.points.end(), {0, 0, 1, 0, 0, -1});
    const int north = around * rings, south = north + 1;
    const auto at = [&](int i, int j) { return j * around + i % around; };
    for (int i = 0; i < around; ++i) {
        input.add(north, at(i, 0), at(i + 1, 0));
        input.add(south, at(i + 1, rings - 1), at(i, rings - 1));
        for (int j = 0; j + 1 < rings; ++j) {
            input.add(at(i, j), at(i, j + 1), at(i + 1, j));
            input.add(at(i + 1, j), at(i, j + 1), at(i + 1, j + 1));
        }
    }
    return input;
}

// Turns random edges within the two triangles at them: the quad runs from one end of the edge.
template <class May> void turn_edges(Input &input, std::mt19937 &random, int n, May may) {
    std::map<Edge, std::size_t> face_of;
    for (std::size_t c = 0; c < input.faces.size(); ++c)
        if (input.faces[c] >= 0)
            face_of[{input.faces[c], input.faces[next_corner(input.faces, c)]}] = c / 4;
    const auto opposite = [&](std::size_t face, std::int32_t v, std::int32_t w) {
        for (std::size_t k = 0; k < 3; ++k)
            if (const std::int32_t u = input.faces[4 * face + k]; u != v && u != w)
                return u;
        return -1;
    };
    for (int i = 0; i < n; ++i) {
        const std::size_t f = random() % input.n_faces(), k = random() % 3;
        const std::int32_t v = input.faces[4 * f + k], w = input.faces[4 * f + (k + 1) % 3];
        const auto beyond = face_of.find({w, v});
        if (beyond == face_of.end())
            continue;
        const std::size_t g = beyond->second;
        const std::int32_t a = opposite(f, v, w), b = opposite(g, v, w);
        if (face_of.contains({a, b}) || face_of.contains({b, a}) || !may(Quad{v, b, w, a}))
            continue;
        face_of.erase({v, w});
        face_of.erase({w, v});
        for (const auto &[face, t] : {std::pair{f, Triangle{a, v, b}}, std::pair{g, Triangle{b, w, a}}})
            for (std::size_t k = 0; k < 3; ++k) {
                input.faces[4 * face + k] = t[k];
                face_of[{t[k], t[(k + 1) % 3]}] = face;
            }
    }
}

// Random vertices put into triangles, then random edges turned: valences from 3 upward.
Input random_sphere(unsigned seed, int n_new) {
    std::mt19937 random(seed);
    Input input = octahedron();
    for (int i = 0; i < n_new; ++i) {
        const std::size_t f = random() % input.n_faces();
        const std::array<std::int32_t, 3> t{input.faces[4 * f], input.faces[4 * f + 1],
                                            input.faces[4 * f + 2]};
        OpenMesh::Vec3d p(0, 0, 0);
        for (const std::int32_t v : t)
            for (std::size_t k = 0; k < 3; ++k)
                p[k] += (1 + double(random() % 100) / 50) * input.points[3 * std::size_t(v) + k];
        p.normalize();
        const auto v = static_cast<std::int32_t>(input.n_points());
        input.points.insert(input.points.end(), {p[0], p[1], p[2]});
        input.faces[4 * f + 2] = v;
        input.add(t[1], t[2], v);
        input.add(t[2], t[0], v);
    }
    turn_edges(input, random, 3 * n_new, [](const Quad &) { return true; });
    return input;
}

// nx * ny rhombi of the triangular lattice, each in two triangles but for one in `whole`, interior
// vertices moved a bit.
Input lattice(int nx, int ny, unsigned seed, int whole = 1000000, double range = 0.3) {
    std::mt19937 random(seed);
    const auto jitter = [&] { return range * (double(random() % 1000) / 1000 - 0.5); };
    Input input;
    for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i) {
            const bool inside = i > 0 && j > 0 && i < nx && j < ny;
            const double x = i + 0.5 * (j % 2), y = j * std::sqrt(0.75);
            input.points.insert(input.points.end(),
                                {x + (inside ? jitter() : 0), y + (inside ? jitter() : 0), 0});
        }
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) {
            const int a = j * (nx + 1) + i, b = a + 1, c = a + nx + 2, d = a + nx + 1;
            if ((j * nx + i) % whole == whole - 1) {
                input.add(a, b, c, d);
            } else if (j % 2 == 0) {
                input.add(a, b, d);
                input.add(b, c, d);
            } else {
                input.add(a, b, c);
                input.add(a, c, d);
            }
        }
    return input;
}

// The Delaunay triangulation of the lattice with its interior vertices moved far: edges are turned while the
// angles across from them are more than 180 degrees together (Lawson 1977).
Input disc(int nx, int ny, unsigned seed) {
    Input input = lattice(nx, ny, seed, 1000000, 0.6);
    std::mt19937 random(seed);
    const auto point = [&](std::int32_t v) {
        return OpenMesh::Vec2d(input.points[3 * std::size_t(v)], input.points[3 * std::size_t(v) + 1]);
    };
    turn_edges(input, random, 200 * nx * ny, [&](const Quad &q) {
        double sine[2], cosine[2];
        for (std::size_t k = 0; k < 2; ++k) {
            const OpenMesh::Vec2d apex = point(q[2 * k + 1]), d = point(q[2 * k]) - apex,
                                  e = point(q[(2 * k + 2) % 4]) - apex;
            sine[k] = std::abs(d[0] * e[1] - d[1] * e[0]);
            cosine[k] = d | e;
        }
        return sine[0] * cosine[1] + cosine[0] * sine[1] < -1e-9;
    });
    return input;
}

double area(const std::vector<double> &points, const std::int32_t *corners, std::size_t n) {
    double twice = 0;
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t v = 3 * std::size_t(corners[k]), w = 3 * std::size_t(corners[(k + 1) % n]);
        twice += points[v] * points[w + 1] - points[v + 1] * points[w];
    }
    return twice / 2;
}

// What every result must have; the mesh of it.
QuadMesh expect_sound(const Input &input, const Quads &quads, int dim = 3) {
    EXPECT_TRUE(std::equal(input.points.begin(), input.points.end(), quads.points.begin()));
    EXPECT_EQ(quads.origin.size(), quads.faces.size() / 4);
    EXPECT_TRUE(std::all_of(quads.origin.begin(), quads.origin.end(),
                            [&](std::int32_t f) { return f >= 0 && f < std::int32_t(input.n_faces()); }));
    return QuadMesh::build(dim, quads.points, quads.faces);
}

// Every quad is two triangles with a common side, every triangle is in one quad.
void expect_pairs(const Input &input, const Quads &quads) {
    EXPECT_EQ(quads.points.size(), input.points.size());
    EXPECT_EQ(2 * quads.origin.size(), input.n_faces());
    std::map<Triangle, int> left;
    const auto key = [](std::int32_t a, std::int32_t b, std::int32_t c) {
        Triangle t{a, b, c};
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        return t;
    };
    for (std::size_t f = 0; f < input.n_faces(); ++f)
        ++left[key(input.faces[4 * f], input.faces[4 * f + 1], input.faces[4 * f + 2])];
    for (std::size_t q = 0; q < quads.origin.size(); ++q) {
        const std::int32_t *c = &quads.faces[4 * q];
        const bool first = left[key(c[0], c[1], c[2])] > 0 && left[key(c[0], c[2], c[3])] > 0;
        --left[first ? key(c[0], c[1], c[2]) : key(c[0], c[1], c[3])];
        --left[first ? key(c[0], c[2], c[3]) : key(c[1], c[2], c[3])];
    }
    EXPECT_TRUE(std::all_of(left.begin(), left.end(), [](const auto &entry) { return entry.second == 0; }));
}

Quad quad(const Quads &quads, std::size_t q) {
    Quad result;
    std::copy_n(quads.faces.begin() + std::ptrdiff_t(4 * q), 4, result.begin());
    return result;
}

double smallest_sine(const Quads &quads) {
    double least = 1;
    for (std::size_t q = 0; q < quads.origin.size(); ++q)
        least = std::min(least, least_sine(quads.points, quad(quads, q)));
    return least;
}

// Of each region, by its marker.
std::map<int, double> areas(const Input &input) {
    std::map<int, double> result;
    for (std::size_t f = 0; f < input.n_faces(); ++f)
        result[input.markers[f]] +=
            area(input.points, &input.faces[4 * f], input.faces[4 * f + 3] < 0 ? 3 : 4);
    return result;
}

void expect_regions(const Input &input, const Quads &quads) {
    std::map<int, double> found;
    for (std::size_t q = 0; q < quads.origin.size(); ++q)
        found[input.markers[std::size_t(quads.origin[q])]] += area(quads.points, &quads.faces[4 * q], 4);
    for (const auto &[marker, size] : areas(input))
        EXPECT_NEAR(found[marker], size, 1e-9 * std::abs(size)) << marker;
}

TEST(Quadrangulate, ClosedSurfacesLeaveNoTriangle) {
    std::vector<Input> inputs{octahedron(), sphere(1), sphere(4), globe(7, 4), globe(60, 31), globe(3, 2)};
    for (unsigned seed = 0; seed < 60; ++seed)
        inputs.push_back(random_sphere(seed, 3 + 11 * int(seed)));
    for (const Input &input : inputs) {
        const Quads quads = input.quads();
        const QuadMesh mesh = expect_sound(input, quads);
        expect_pairs(input, quads);
        EXPECT_NO_THROW(mesh.check());
    }
}

TEST(Quadrangulate, ASmoothSphereHasConvexQuads) { EXPECT_GT(smallest_sine(sphere(4).quads()), 0.05); }

TEST(Quadrangulate, AnEvenDiscKeepsItsBoundary) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Input input = lattice(5 + int(seed), 7, seed);
        const Quads quads = input.quads();
        expect_pairs(input, quads);
        EXPECT_NO_THROW(expect_sound(input, quads, 2).check());
        EXPECT_GT(smallest_sine(quads), 0.2);
    }
}

// Whether the triangles that are not taken make convex quads in pairs, by trying everything.
bool can_be_convex(const Input &input, const std::vector<std::int32_t> &across, std::vector<bool> &taken) {
    const auto first = std::find(taken.begin(), taken.end(), false);
    if (first == taken.end())
        return true;
    const auto f = static_cast<std::size_t>(first - taken.begin());
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t c = across[4 * f + k];
        if (c < 0 || taken[std::size_t(c / 4)])
            continue;
        const std::size_t g = std::size_t(c / 4), l = std::size_t(c % 4);
        const std::int32_t *t = &input.faces[4 * f], *u = &input.faces[4 * g];
        if (least_sine(input.points, {t[k], u[(l + 2) % 3], t[(k + 1) % 3], t[(k + 2) % 3]}) < 0.01)
            continue;
        taken[f] = taken[g] = true;
        if (can_be_convex(input, across, taken))
            return true;
        taken[f] = taken[g] = false;
    }
    return false;
}

TEST(Quadrangulate, QuadsAreConvexIfTheyCanBe) {
    int can = 0, trials = 100;
    for (int seed = 0; seed < trials; ++seed) {
        const Input input = disc(6, 4, unsigned(seed));
        std::vector<bool> taken(input.n_faces());
        if (!can_be_convex(input, across_edges(input.faces, pair_sides(input.faces, input.n_points())),
                           taken))
            continue;
        ++can;
        const Quads quads = input.quads();
        expect_pairs(input, quads);
        EXPECT_NO_THROW(expect_sound(input, quads, 2).check()) << seed;
    }
    EXPECT_GT(can, trials / 4);
    EXPECT_LT(can, trials);
}

TEST(Quadrangulate, AnOddDiscGetsOneVertexOnItsBoundary) {
    int without_flat_corner = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
        Input input = seed % 2 == 0 ? lattice(5 + int(seed), 7, seed) : disc(5 + int(seed), 14, seed);
        input.faces.resize(input.faces.size() - 4);
        input.markers.assign(input.n_faces(), 3);
        const Quads quads = input.quads();
        const QuadMesh mesh = expect_sound(input, quads, 2);
        expect_regions(input, quads);
        ASSERT_EQ(quads.points.size(), input.points.size() + 3 * quads.midpoints.size());
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
            without_flat_corner += mesh.valence(vertex) == 3;
        }
    }
    EXPECT_GE(without_flat_corner, 6);
}

TEST(Quadrangulate, RegionsStayApart) {
    for (unsigned seed = 0; seed < 30; ++seed) {
        Input input = disc(12, 9, seed);
        // Borders cut through the rhombi, so that regions are odd or even as it happens.
        for (std::size_t f = 0; f < input.n_faces(); ++f)
            input.markers.push_back(f % 24 < 7 + seed ? 1 : f / 24 < 4 ? 2 : 5);
        const Quads quads = input.quads();
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
    const Quads quads = input.quads();
    const QuadMesh mesh = expect_sound(input, quads);
    ASSERT_EQ(quads.midpoints.size(), 1U);
    const auto [edge, vertex] = quads.midpoints.front();
    std::set<int> markers;
    for (const int face : mesh.faces_around(vertex))
        markers.insert(input.markers[std::size_t(quads.origin[std::size_t(face)])]);
    EXPECT_EQ(markers, (std::set<int>{1, 2}));
    EXPECT_EQ(mesh.valence(vertex), 3); // cut anew in the region that has more than this triangle
}

TEST(Quadrangulate, CurvesStay) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        Input input = lattice(10, 10, seed);
        for (std::size_t f = 0; f < input.n_faces(); f += 3)
            input.curves.push_back({input.faces[4 * f + 1], input.faces[4 * f]}); // in either direction
        const Quads quads = input.quads();
        const QuadMesh mesh = expect_sound(input, quads, 2);
        for (const Edge &curve : input.curves) {
            const std::vector<Edge> edges = pieces(quads, curve);
            EXPECT_EQ(edges.front()[0], curve[0]);
            EXPECT_EQ(edges.back()[1], curve[1]);
            for (const auto &[v, w] : edges)
                EXPECT_GE(mesh.find_edge(v, w), 0);
        }
    }
}

// Between all sides being curves no triangle has a mate: each goes out, or on in a row.
TEST(Quadrangulate, CurvesEverywhere) {
    for (Input input : {sphere(2), lattice(6, 5, 1)}) {
        const Halfedges halfedges = pair_sides(input.faces, input.n_points());
        std::set<Edge> edges;
        for (std::size_t c = 0; c < input.faces.size(); ++c)
            if (input.faces[c] >= 0)
                edges.insert({std::min(input.faces[c], input.faces[next_corner(input.faces, c)]),
                              std::max(input.faces[c], input.faces[next_corner(input.faces, c)])});
        EXPECT_EQ(edges.size(), halfedges.n_edges);
        input.curves.assign(edges.begin(), edges.end());
        const Quads quads = input.quads();
        const QuadMesh mesh = expect_sound(input, quads);
        EXPECT_EQ(quads.origin.size(), input.n_faces());
        // One for each two triangles, but for those that leave by the boundary.
        const auto leave = std::count_if(quads.midpoints.begin(), quads.midpoints.end(),
                                         [&](const auto &m) { return mesh.on_boundary(m.vertex); });
        EXPECT_EQ(2 * quads.midpoints.size() - std::size_t(leave), input.n_faces());
        for (const Edge &curve : input.curves)
            for (const auto &[v, w] : pieces(quads, curve))
                EXPECT_GE(mesh.find_edge(v, w), 0);
    }
}

TEST(Quadrangulate, GivenQuadsStay) {
    const Input input = lattice(6, 6, 5, 3);
    const Quads quads = input.quads();
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
    const Quads quads = input.quads();
    const QuadMesh mesh = expect_sound(input, quads);
    EXPECT_EQ(mesh.n_faces(), 6);
    EXPECT_EQ(mesh.n_vertices(), 8);
    EXPECT_NO_THROW(mesh.check());
}

// Some faces of a mesh of quads cut in two triangles, apart from each other, and two quads.
Input scattered(const Grid &grid, unsigned seed) {
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
        const Input input = scattered(closed ? torus(12, 8) : plane(12, 8), seed);
        const Quads quads = input.quads();
        const QuadMesh mesh = expect_sound(input, quads);
        EXPECT_NO_THROW(mesh.check());
        const auto on_boundary = [&](const Quads::Midpoint &midpoint) {
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
    const Quads two_quads = pillow.quads();
    EXPECT_EQ(expect_sound(pillow, two_quads).n_faces(), 2);

    const Quads three_quads = one.quads();
    const QuadMesh mesh = expect_sound(one, three_quads, 2);
    EXPECT_EQ(mesh.n_faces(), 3);
    EXPECT_EQ(mesh.n_vertices(), 7);
    EXPECT_NO_THROW(mesh.check());
}

TEST(Quadrangulate, Split) {
    for (Input input : {sphere(1), lattice(5, 4, 3), prism()}) {
        input.curves = {{input.faces[1], input.faces[0]}};
        const Quads quads = input.quads(Quadrangulation::split);
        const QuadMesh mesh = expect_sound(input, quads);
        EXPECT_NO_THROW(mesh.check());
        std::size_t sides = 0;
        for (const std::int32_t v : input.faces)
            sides += v >= 0;
        EXPECT_EQ(quads.origin.size(), sides);
        const std::size_t n_edges = pair_sides(input.faces, input.n_points()).n_edges;
        EXPECT_EQ(quads.points.size() / 3, input.n_points() + n_edges + input.n_faces());
        EXPECT_EQ(pieces(quads, input.curves[0]).size(), 2U);
        EXPECT_GT(smallest_sine(quads), 0.2);
    }
}

TEST(Quadrangulate, SameAgain) {
    const Input input = random_sphere(9, 2000);
    const Quads first = input.quads(), second = input.quads();
    EXPECT_EQ(first.faces, second.faces);
    EXPECT_EQ(first.points, second.points);
}

Failure refusal(const Input &input) {
    return failure_of([&] { input.quads(); });
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
} // namespace alphamst::mesh
