// Meshes for the benchmarks, and handles of the C interface that end themselves.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <memory>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <alphamst/alphamst.h>

namespace alphamst::benchmarks {

inline void must(amst_status status) {
    if (status < 0)
        throw std::runtime_error(std::string(amst_status_name(status)) + ": " + amst_last_error());
}

template <auto destroy> struct Destroy {
    template <typename T> void operator()(T *handle) const { destroy(handle); }
};
using Context = std::unique_ptr<amst_context, Destroy<amst_context_destroy>>;
using Mesh = std::unique_ptr<amst_mesh, Destroy<amst_mesh_destroy>>;
using Patches = std::unique_ptr<amst_patches, Destroy<amst_patches_destroy>>;
using Report = std::unique_ptr<amst_report, Destroy<amst_report_destroy>>;

struct Arrays {
    std::vector<double> points; // x y z
    std::vector<std::int32_t> faces;

    std::int64_t n_points() const { return static_cast<std::int64_t>(points.size() / 3); }
    std::int64_t n_faces() const { return static_cast<std::int64_t>(faces.size() / 4); }
};

// n x n unit squares, row by row.
inline Arrays grid(int n) {
    Arrays mesh;
    for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x)
            mesh.points.insert(mesh.points.end(), {double(x), double(y), 0});
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const int a = y * (n + 1) + x;
            mesh.faces.insert(mesh.faces.end(), {a, a + 1, a + n + 2, a + n + 1});
        }
    return mesh;
}

// Moves every vertex inside the square of that side to the mean of its neighbours.
inline void smooth(Arrays &mesh, double side, int sweeps) {
    const auto n = static_cast<std::size_t>(mesh.n_points());
    auto inside = [side](double x) { return x > 0 && x < side; };
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        std::vector<std::array<double, 3>> sum(n, {0, 0, 0}); // x, y, neighbours
        for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
            // Every edge inside is met from both ends.
            const auto v = static_cast<std::size_t>(mesh.faces[i]);
            const auto w = static_cast<std::size_t>(mesh.faces[i % 4 == 3 ? i - 3 : i + 1]);
            sum[v][0] += mesh.points[3 * w];
            sum[v][1] += mesh.points[3 * w + 1];
            sum[v][2] += 1;
        }
        for (std::size_t v = 0; v < n; ++v)
            if (inside(mesh.points[3 * v]) && inside(mesh.points[3 * v + 1]))
                for (std::size_t k = 0; k < 2; ++k)
                    mesh.points[3 * v + k] = sum[v][k] / sum[v][2];
    }
}

// An unstructured mesh of about n faces on a square: a grid of moved points is cut into
// triangles along random diagonals and every triangle into three quads, then smoothed. It has
// far more singularities than a frontal mesh: one for every triangle at least.
inline Arrays unstructured(std::int64_t n_faces) {
    const int n = std::max(2, static_cast<int>(std::lround(std::sqrt(static_cast<double>(n_faces) / 6))));
    std::mt19937 random(5489);
    auto chance = [&random] { return static_cast<double>(random()) / 4294967296.0; };
    Arrays mesh;
    for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x) {
            const bool inside = x > 0 && y > 0 && x < n && y < n;
            const double dx = chance() - 0.5, dy = chance() - 0.5;
            mesh.points.insert(mesh.points.end(),
                               {x + (inside ? 0.6 * dx : 0), y + (inside ? 0.6 * dy : 0), 0});
        }
    std::map<std::pair<int, int>, int> middles;
    auto mean = [&mesh](std::initializer_list<int> vertices) {
        for (int k = 0; k < 3; ++k) {
            double sum = 0;
            for (const int v : vertices)
                sum += mesh.points[static_cast<std::size_t>(3 * v + k)];
            mesh.points.push_back(sum / static_cast<double>(vertices.size()));
        }
        return static_cast<int>(mesh.n_points()) - 1;
    };
    auto middle = [&](int v, int w) {
        const auto [place, is_new] = middles.try_emplace(std::minmax(v, w), 0);
        if (is_new)
            place->second = mean({v, w});
        return place->second;
    };
    auto add_triangle = [&](int a, int b, int c) {
        const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a), centre = mean({a, b, c});
        mesh.faces.insert(mesh.faces.end(), {a, ab, centre, ca, b, bc, centre, ab, c, ca, centre, bc});
    };
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const int a = y * (n + 1) + x, b = a + 1, c = a + n + 2, d = a + n + 1;
            if (chance() < 0.5) {
                add_triangle(a, b, c);
                add_triangle(a, c, d);
            } else {
                add_triangle(a, b, d);
                add_triangle(b, c, d);
            }
        }
    smooth(mesh, n, 10);
    return mesh;
}

inline Context new_context() {
    amst_context *context = nullptr;
    must(amst_context_create(0, &context)); // one thread, as every context at its creation
    return Context(context);
}

inline Mesh create(const Context &context, const Arrays &mesh, int dim = 3) {
    amst_mesh *handle = nullptr;
    must(amst_mesh_create(context.get(), dim, mesh.points.data(), mesh.n_points(), 3, 1, mesh.faces.data(),
                          mesh.n_faces(), 0, 0, 4, nullptr, &handle));
    return Mesh(handle);
}

inline Mesh clone(const Mesh &mesh) {
    amst_mesh *handle = nullptr;
    must(amst_mesh_clone(mesh.get(), &handle));
    return Mesh(handle);
}

inline Arrays arrays(const Mesh &mesh) {
    std::int64_t n_points = 0, n_faces = 0, needed = 0;
    std::int32_t dim = 0;
    must(amst_mesh_get_dim(mesh.get(), &dim));
    must(amst_mesh_get_count(mesh.get(), AMST_VERTEX, &n_points));
    must(amst_mesh_get_count(mesh.get(), AMST_FACE, &n_faces));
    std::vector<double> packed(static_cast<std::size_t>(dim * n_points));
    Arrays result{std::vector<double>(static_cast<std::size_t>(3 * n_points)),
                  std::vector<std::int32_t>(static_cast<std::size_t>(4 * n_faces))};
    must(amst_mesh_get_points(mesh.get(), packed.data(), dim * n_points, &needed));
    must(amst_mesh_get_faces(mesh.get(), result.faces.data(), 4 * n_faces, &needed));
    for (std::size_t i = 0; i < packed.size(); ++i)
        result.points[3 * (i / static_cast<std::size_t>(dim)) + i % static_cast<std::size_t>(dim)] =
            packed[i];
    return result;
}

// The files named in ALPHAMST_BENCHMARK_MESHES, separated by colons: of the first small patches are
// taken, of the last large ones.
inline std::vector<std::string> mesh_files() {
    const char *list = std::getenv("ALPHAMST_BENCHMARK_MESHES");
    std::vector<std::string> files;
    std::istringstream stream(list == nullptr ? "" : list);
    for (std::string file; std::getline(stream, file, ':');)
        files.push_back(file);
    return files;
}

inline Mesh read(const Context &context, const std::string &path) {
    amst_mesh *handle = nullptr;
    must(amst_mesh_read(context.get(), path.c_str(), nullptr, &handle));
    return Mesh(handle);
}

inline double median(std::vector<double> values) {
    if (values.empty())
        return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace alphamst::benchmarks
