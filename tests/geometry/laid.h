// Grids of quads laid on graphs of functions.
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "geometry/approximation_error.h"
#include "geometry/surface_positions.h"

namespace alphamst::geometry::samples {

using Eigen::Vector3d;
using surface::Surface;

// The graph z = height(x, y) over a square of side 8, as n x n squares of two triangles.
template <class Height> std::unique_ptr<Surface> graph(int n, const Height &height) {
    std::vector<Vector3d> points;
    std::vector<std::array<int, 3>> triangles;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const double x = 8.0 * i / n, y = 8.0 * j / n;
            points.emplace_back(x, y, height(x, y));
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
            triangles.push_back({a, b, c});
            triangles.push_back({a, c, d});
        }
    return std::make_unique<Surface>(std::move(points), std::move(triangles));
}

// An 8 x 8 grid laid on the surface, its inner vertices moved sideways by `shift`.
struct Laid {
    explicit Laid(const Surface &surface, const Vector3d &shift) {
        for (int j = 0; j <= 8; ++j)
            for (int i = 0; i <= 8; ++i) {
                const bool buffer = i % 8 == 0 || j % 8 == 0;
                fixed.push_back(buffer);
                Vector3d p(i, j, 0);
                if (!buffer)
                    p += shift;
                on_surface.add(surface.nearest(surface_point(surface, p)));
            }
        for (int j = 0; j < 8; ++j)
            for (int i = 0; i < 8; ++i) {
                const int a = 9 * j + i;
                quads.push_back({a, a + 1, a + 10, a + 9});
            }
    }

    // Above p, so that the nearest place is right there.
    static Vector3d surface_point(const Surface &surface, Vector3d p) {
        for (int k = 0; k < 40; ++k)
            p.z() = surface.nearest(p).point.z();
        return p;
    }

    double distance(const Surface &surface) const {
        ApproximationError approximation_error(surface, quads, on_surface);
        approximation_error.measure(on_surface, {});
        return std::sqrt(approximation_error.mean_square());
    }

    SurfacePositions on_surface;
    std::vector<std::array<int, 4>> quads;
    std::vector<char> fixed;
};

} // namespace alphamst::geometry::samples
