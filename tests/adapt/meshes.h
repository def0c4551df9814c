// Meshes and patches for the tests of this folder.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <numbers>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "io/arrays.h"
#include "mesh/quad_mesh.h"
#include "patch/patches.h"
#include "patch/window.h"

namespace alphamst::adapt::samples {

// 0 .. 1, the same with every standard library.
inline double chance(std::mt19937 &random) { return static_cast<double>(random()) / 4294967296.0; }

// nx by ny unit squares; face (i, j) is j * nx + i, vertex (i, j) is j * (nx + 1) + i.
inline mesh::QuadMesh grid(int nx, int ny, int dim = 2) {
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
    return mesh::QuadMesh::build(dim, points, faces);
}

// Faces of columns i0 .. i1-1 and rows j0 .. j1-1 of a grid nx wide.
inline std::vector<int> block(int nx, int i0, int j0, int i1, int j1) {
    std::vector<int> faces;
    for (int j = j0; j < j1; ++j)
        for (int i = i0; i < i1; ++i)
            faces.push_back(j * nx + i);
    return faces;
}

// n sectors of m by m rhombi around vertex 0: a polygon of n sides of 2 m edges. Sector k has
// the faces k * m * m + a * m + b, a and b away from the middle.
inline mesh::QuadMesh star(int n, int m) {
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
        for (int a = 0; a < m; ++a)
            for (int b = 0; b < m; ++b)
                for (const auto &[i, j] : {std::pair(a, b), {a + 1, b}, {a + 1, b + 1}, {a, b + 1}})
                    faces.push_back(vertex(k, i, j));
    return mesh::QuadMesh::build(2, points, faces);
}

// Every vertex inside goes to the mean of its neighbours, again and again.
inline void relax(mesh::QuadMesh &mesh, int sweeps) {
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (int v = 0; v < mesh.n_vertices(); ++v) {
            if (mesh.isolated(v) || mesh.on_boundary(v))
                continue;
            OpenMesh::Vec3d sum(0, 0, 0);
            const std::vector<int> around = mesh.vertices_around(v);
            for (const int w : around)
                sum += mesh.point(w);
            mesh.set_point(v, sum / static_cast<double>(around.size()));
        }
}

// Turns so many edges between two faces of the set: their ends lose an edge, two other
// vertices win one. All four are inside the set and keep a valence of 3 to 5.
inline void turn_edges(mesh::QuadMesh &mesh, std::vector<int> faces, int turns, std::mt19937 &random) {
    std::vector<char> inside(static_cast<std::size_t>(mesh.n_faces()), 0);
    for (const int f : faces)
        inside[static_cast<std::size_t>(f)] = 1;
    const auto may = [&](int v, int valence) {
        const std::vector<int> around = mesh.faces_around(v);
        return !mesh.on_boundary(v) && valence >= 3 && valence <= 5 &&
               std::all_of(around.begin(), around.end(),
                           [&](int f) { return inside[static_cast<std::size_t>(f)] != 0; });
    };
    for (int tries = 0; turns > 0 && tries < 100000; ++tries) {
        const int f = faces[random() % faces.size()], g = mesh.neighbours(f)[random() % 4];
        if (g < 0 || patch::defects(mesh, std::vector{f, g}) != 0)
            continue;
        const std::vector<int> loop = patch::make_window(mesh, std::vector{f, g}).loop;
        std::size_t k = 0; // from loop[k] to loop[k + 3] runs the edge
        while (k < 3 && mesh.find_edge(loop[k], loop[k + 3]) < 0)
            ++k;
        if (k == 3 || loop.size() != 6)
            continue;
        const auto at = [&](std::size_t i) { return loop[(k + i) % 6]; };
        if (!may(at(0), mesh.valence(at(0)) - 1) || !may(at(3), mesh.valence(at(3)) - 1) ||
            !may(at(1), mesh.valence(at(1)) + 1) || !may(at(4), mesh.valence(at(4)) + 1) ||
            mesh.find_edge(at(1), at(4)) >= 0)
            continue;
        const auto place = [&](std::size_t i) { return static_cast<int>((k + i) % 6); };
        mesh.replace_disk(std::vector{f, g}, loop,
                          std::vector<std::array<int, 4>>{{place(1), place(2), place(3), place(4)},
                                                          {place(4), place(5), place(0), place(1)}},
                          {});
        --turns;
    }
}

inline std::vector<int> all_faces(const mesh::QuadMesh &mesh) {
    std::vector<int> faces;
    for (int f = 0; f < mesh.n_faces(); ++f)
        faces.push_back(f);
    return faces;
}

// n by n quads on a square, about one vertex in eight singular.
inline mesh::QuadMesh unstructured(int n, unsigned seed) {
    std::mt19937 random(seed);
    mesh::QuadMesh mesh = grid(n, n);
    turn_edges(mesh, all_faces(mesh), n * n / 28, random);
    relax(mesh, 100);
    mesh.reset_origins();
    return mesh;
}

// The coast of examples/data, meshed by gmsh; nothing if gmsh is not here.
inline std::optional<mesh::QuadMesh> coast() {
    namespace fs = std::filesystem;
    const fs::path outline = fs::path(__FILE__).parent_path() / "../../examples/data/coast.geo";
    static std::mt19937 names{std::random_device{}()}; // several tests may run at once
    const fs::path file = fs::temp_directory_path() / ("alphamst_coast_" + std::to_string(names()) + ".msh");
    const std::string command =
        "gmsh -2 \"" + outline.string() + "\" -o \"" + file.string() + "\" -v 0 > /dev/null 2>&1";
    const bool made = fs::exists(outline) && std::system(command.c_str()) == 0 && fs::exists(file);
    std::optional<mesh::QuadMesh> mesh;
    if (made) {
        const io::Arrays arrays = io::read(file.string());
        mesh = mesh::QuadMesh::build(arrays.dim, arrays.points, arrays.faces);
        mesh->face_marker = arrays.face_marker;
        mesh->edge_marker.resize(static_cast<std::size_t>(mesh->n_edges()));
        for (const auto &[vertices, marker] : arrays.marked_edges)
            if (const int e = mesh->find_edge(vertices[0], vertices[1]); e >= 0)
                mesh->edge_marker[static_cast<std::size_t>(e)] = marker;
    }
    std::error_code ignored;
    fs::remove(file, ignored);
    return mesh;
}

inline OpenMesh::Vec3d centre(const mesh::QuadMesh &mesh, int face) {
    OpenMesh::Vec3d sum(0, 0, 0);
    for (const int v : mesh.corners(face))
        sum += mesh.point(v);
    return sum / 4.0;
}

// A disk of at least 20 and about least .. most faces, sizes evenly spread on a logarithmic
// scale. It grows from a random face by distance, disturbed so that the boundary is nearly
// round to ragged.
inline std::vector<int> random_patch(const mesh::QuadMesh &mesh, double least, double most,
                                     std::mt19937 &random) {
    const std::vector<char> none(static_cast<std::size_t>(mesh.n_faces()), 0);
    most = std::min(most, mesh.n_faces() * 2.0 / 3.0);
    for (;;) {
        const double size = least * std::pow(most / least, chance(random));
        const double a = chance(random), ragged = a * chance(random) * 0.6 * std::sqrt(size);
        const int seed = static_cast<int>(random() % static_cast<unsigned>(mesh.n_faces()));
        const OpenMesh::Vec3d from = centre(mesh, seed);
        std::set<std::pair<double, int>> front{{0.0, seed}};
        std::set<int> seen{seed};
        std::vector<int> faces;
        while (static_cast<double>(faces.size()) < size && !front.empty()) {
            const int f = front.begin()->second;
            front.erase(front.begin());
            faces.push_back(f);
            for (const int g : mesh.neighbours(f)) {
                if (g < 0 || !seen.insert(g).second)
                    continue;
                const auto corners = mesh.corners(g);
                const double edge = (mesh.point(corners[0]) - mesh.point(corners[2])).norm() / std::sqrt(2.0);
                front.insert({(centre(mesh, g) - from).norm() + ragged * edge * chance(random), g});
            }
        }
        std::sort(faces.begin(), faces.end());
        faces = patch::repair(mesh, std::move(faces), none);
        if (faces.size() >= 20)
            return faces;
    }
}

} // namespace alphamst::adapt::samples
