// Meshes of triangles for the tests of this folder, and what is expected of the quads made of them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "mesh/quad_mesh.h"
#include "quadrangulate/pairing.h"
#include "quadrangulate/quadrangulate.h"

namespace alphamst::quadrangulate::triangles {

using Edge = std::array<std::int32_t, 2>;
using Triangle = std::array<std::int32_t, 3>;
using Quad = std::array<std::int32_t, 4>;

inline double least_sine(mesh::Coordinates points, const Quad &quad) {
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
    QuadArrays quads(Quadrangulation how = Quadrangulation::pair) const {
        return quadrangulate(polygons(), how);
    }
};

inline Input octahedron() {
    Input input;
    input.points = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
    for (const Triangle &t :
         {Triangle{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}})
        input.add(t[0], t[1], t[2]);
    return input;
}

// Each triangle in four, vertices back on the unit sphere.
inline Input refined(const Input &coarse) {
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

inline Input sphere(int levels) {
    Input input = octahedron();
    for (int i = 0; i < levels; ++i)
        input = refined(input);
    return input;
}

// Rings of triangles between two poles of high valence.
inline Input globe(int around, int rings) {
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
            face_of[{input.faces[c], input.faces[mesh::next_corner(input.faces, c)]}] = c / 4;
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
inline Input random_sphere(unsigned seed, int n_new) {
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
inline Input lattice(int nx, int ny, unsigned seed, int whole = 1000000, double range = 0.3) {
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
inline Input disc(int nx, int ny, unsigned seed) {
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

inline double area(const std::vector<double> &points, const std::int32_t *corners, std::size_t n) {
    double twice = 0;
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t v = 3 * std::size_t(corners[k]), w = 3 * std::size_t(corners[(k + 1) % n]);
        twice += points[v] * points[w + 1] - points[v + 1] * points[w];
    }
    return twice / 2;
}

// What every result must have; the mesh of it.
inline mesh::QuadMesh expect_sound(const Input &input, const QuadArrays &quads, int dim = 3) {
    EXPECT_TRUE(std::equal(input.points.begin(), input.points.end(), quads.points.begin()));
    EXPECT_EQ(quads.origin.size(), quads.faces.size() / 4);
    EXPECT_TRUE(std::all_of(quads.origin.begin(), quads.origin.end(),
                            [&](std::int32_t f) { return f >= 0 && f < std::int32_t(input.n_faces()); }));
    return mesh::QuadMesh::build(dim, quads.points, quads.faces);
}

// Every quad is two triangles with a common side, every triangle is in one quad.
inline void expect_pairs(const Input &input, const QuadArrays &quads) {
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

inline Quad quad(const QuadArrays &quads, std::size_t q) {
    Quad result;
    std::copy_n(quads.faces.begin() + std::ptrdiff_t(4 * q), 4, result.begin());
    return result;
}

inline double smallest_sine(const QuadArrays &quads) {
    double least = 1;
    for (std::size_t q = 0; q < quads.origin.size(); ++q)
        least = std::min(least, least_sine(quads.points, quad(quads, q)));
    return least;
}

// Of each region, by its marker.
inline std::map<int, double> areas(const Input &input) {
    std::map<int, double> result;
    for (std::size_t f = 0; f < input.n_faces(); ++f)
        result[input.markers[f]] +=
            area(input.points, &input.faces[4 * f], input.faces[4 * f + 3] < 0 ? 3 : 4);
    return result;
}

inline void expect_regions(const Input &input, const QuadArrays &quads) {
    std::map<int, double> found;
    for (std::size_t q = 0; q < quads.origin.size(); ++q)
        found[input.markers[std::size_t(quads.origin[q])]] += area(quads.points, &quads.faces[4 * q], 4);
    for (const auto &[marker, size] : areas(input))
        EXPECT_NEAR(found[marker], size, 1e-9 * std::abs(size)) << marker;
}

} // namespace alphamst::quadrangulate::triangles
