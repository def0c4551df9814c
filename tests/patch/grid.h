// Small meshes and face sets for the tests of patches.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "mesh/quad_mesh.h"
#include "patch/window.h"

namespace alphamst::patch::testing {

// nx by ny unit squares; face (i, j) is j * nx + i, vertex (i, j) is j * (nx + 1) + i.
inline mesh::QuadMesh grid(int nx, int ny) {
    std::vector<double> points;
    std::vector<std::int32_t> faces;
    for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i)
            points.insert(points.end(), {double(i), double(j), 0.0});
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) {
            const int v = j * (nx + 1) + i;
            faces.insert(faces.end(), {v, v + 1, v + nx + 2, v + nx + 1});
        }
    return mesh::QuadMesh::build(2, points, faces);
}

// Faces of columns i0 .. i1-1 and rows j0 .. j1-1 of a grid nx wide.
inline std::vector<int> block(int nx, int i0, int j0, int i1, int j1) {
    std::vector<int> faces;
    for (int j = j0; j < j1; ++j)
        for (int i = i0; i < i1; ++i)
            faces.push_back(j * nx + i);
    return faces;
}

inline std::vector<int> without(std::vector<int> faces, const std::vector<int> &dropped) {
    std::erase_if(faces,
                  [&](int f) { return std::find(dropped.begin(), dropped.end(), f) != dropped.end(); });
    return faces;
}

// n sectors of m by m faces around vertex 0, in the plane. With m = 1, vertex k + 1 is the
// end of spoke k and face k lies between the spokes k and k + 1.
inline mesh::QuadMesh star(int n, int m = 1) {
    std::vector<double> points;
    std::vector<std::int32_t> faces;
    std::map<std::array<int, 3>, int> vertices; // sector, along its spoke, along the next
    const auto vertex = [&](int k, int a, int b) {
        if (a == 0 && b == 0)
            k = 0;
        if (a == 0 && b > 0)
            std::swap(a, b), k = (k + 1) % n;
        const auto [it, fresh] = vertices.try_emplace({k, a, b}, static_cast<int>(points.size() / 3));
        if (fresh) {
            const double angle = 2 * std::numbers::pi / n;
            points.push_back(a * std::cos(k * angle) + b * std::cos((k + 1) * angle));
            points.push_back(a * std::sin(k * angle) + b * std::sin((k + 1) * angle));
            points.push_back(0);
        }
        return it->second;
    };
    for (int k = 0; k < n; ++k)
        vertex(k, 0, 0), vertex(k, 1, 0);
    for (int k = 0; k < n; ++k)
        for (int a = 0; a < m; ++a)
            for (int b = 0; b < m; ++b)
                for (const auto &[i, j] : {std::pair(a, b), {a + 1, b}, {a + 1, b + 1}, {a, b + 1}})
                    faces.push_back(vertex(k, i, j));
    return mesh::QuadMesh::build(2, points, faces);
}

// The faces of a mesh that are listed, as a mesh of their own; vertices keep their numbers.
inline mesh::QuadMesh part(const mesh::QuadMesh &mesh, const std::vector<int> &kept) {
    std::vector<double> points;
    std::vector<std::int32_t> faces;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        for (const double x : mesh.point(v))
            points.push_back(x);
    for (const int face : kept)
        for (const int v : mesh.corners(face))
            faces.push_back(v);
    return mesh::QuadMesh::build(mesh.dim(), points, faces);
}

// Quadrilaterals from their corners, equal points being one vertex.
class Soup {
public:
    void add(const std::array<std::array<double, 3>, 4> &corners) {
        for (const auto &p : corners) {
            std::array<long, 3> key;
            for (std::size_t i = 0; i < 3; ++i)
                key[i] = std::lround(p[i] * 1e6);
            const auto [it, fresh] =
                vertices_.try_emplace(key, static_cast<std::int32_t>(points_.size() / 3));
            if (fresh)
                points_.insert(points_.end(), p.begin(), p.end());
            faces_.push_back(it->second);
        }
    }

    // m by m faces between four points, counter-clockwise.
    void add(const std::array<std::array<double, 3>, 4> &block, int m) {
        const auto place = [&](int i, int j) {
            const double s = double(i) / m, t = double(j) / m;
            std::array<double, 3> p;
            for (std::size_t c = 0; c < 3; ++c)
                p[c] = (1 - t) * ((1 - s) * block[0][c] + s * block[1][c]) +
                       t * ((1 - s) * block[3][c] + s * block[2][c]);
            return p;
        };
        for (int j = 0; j < m; ++j)
            for (int i = 0; i < m; ++i)
                add({place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)});
    }

    mesh::QuadMesh mesh(int dim) const { return mesh::QuadMesh::build(dim, points_, faces_); }

private:
    std::map<std::array<long, 3>, std::int32_t> vertices_;
    std::vector<double> points_;
    std::vector<std::int32_t> faces_;
};

// n by n unit squares cut into two triangles, each cut into three blocks of m by m faces:
// valence 3 within every triangle, 6 where triangles meet.
inline mesh::QuadMesh triangles(int n, int m) {
    using P = std::array<double, 3>;
    Soup soup;
    const auto mean = [](const std::vector<P> &points) {
        P sum{0, 0, 0};
        for (const P &p : points)
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += p[c] / static_cast<double>(points.size());
        return sum;
    };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const P a{double(i), double(j), 0}, b{i + 1.0, double(j), 0}, c{i + 1.0, j + 1.0, 0},
                d{double(i), j + 1.0, 0};
            for (const std::array<P, 3> &t : {std::array<P, 3>{a, b, c}, std::array<P, 3>{a, c, d}})
                for (std::size_t k = 0; k < 3; ++k) {
                    const P &p = t[k], &q = t[(k + 1) % 3], &r = t[(k + 2) % 3];
                    soup.add({p, mean({p, q}), mean({p, q, r}), mean({r, p})}, m);
                }
        }
    return soup.mesh(2);
}

// The surface of a cube, every side of m by m faces.
inline mesh::QuadMesh cube(int m) {
    using P = std::array<double, 3>;
    const auto corner = [](int v) { return P{double(v & 1), double(v >> 1 & 1), double(v >> 2)}; };
    Soup soup;
    for (const auto &[a, b, c, d] :
         {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
        soup.add({corner(a), corner(b), corner(c), corner(d)}, m);
    return soup.mesh(3);
}

inline mesh::QuadMesh cube() {
    std::vector<double> points;
    for (int v = 0; v < 8; ++v)
        points.insert(points.end(), {double(v & 1), double(v >> 1 & 1), double(v >> 2)});
    const std::vector<std::int32_t> faces = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4,
                                             2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    return mesh::QuadMesh::build(3, points, faces);
}

// Grown from a random face by random neighbours that leave it a disk.
inline std::vector<int> random_disk(const mesh::QuadMesh &mesh, int size, std::mt19937 &random) {
    std::vector<int> disk = {static_cast<int>(random() % static_cast<unsigned>(mesh.n_faces()))};
    for (int tries = 0; tries < 20 * size && static_cast<int>(disk.size()) < size; ++tries) {
        const int next = mesh.neighbours(disk[random() % disk.size()])[random() % 4];
        if (next < 0 || std::find(disk.begin(), disk.end(), next) != disk.end())
            continue;
        disk.push_back(next);
        if (defects(mesh, disk) != 0)
            disk.pop_back();
    }
    std::sort(disk.begin(), disk.end());
    return disk;
}

} // namespace alphamst::patch::testing
