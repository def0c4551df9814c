// A roof of two halves of quads with feature lines along its ridge.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

#include "geometry/surface_positions.h"
#include "mesh/curved.h"
#include "reference/surface_of.h"

namespace alphamst::geometry::samples {

using Eigen::Vector3d;

inline std::size_t at(int i) { return static_cast<std::size_t>(i); }

inline constexpr int across = 4, along = 8; // faces; the ridge is in the middle

inline int vertex(int i, int j) { return j * (across + 1) + i; }

// A roof over [-2, 2] x [0, 8], each of its two halves turned down so many degrees; the vertices of the ridge
// are bunched at its start, the more the higher the power.
struct Roof {
    mesh::QuadMesh mesh;
    std::shared_ptr<const surface::Surface> surface;
    SurfacePositions on_surface;
    std::vector<char> fixed;
    std::vector<FeatureLine> feature_lines;

    Roof(double degrees, double power) : mesh(mesh::grid(across, along, place(degrees))) {
        surface = reference::surface_of(mesh);
        fixed.assign(at(mesh.n_vertices()), 1);
        feature_lines.resize(fixed.size());
        const surface::Line ridge{{0, -1, 0}, {0, 10, 0}};
        for (int j = 0; j <= along; ++j)
            for (int i = 0; i <= across; ++i) {
                const auto &p = mesh.point(vertex(i, j));
                const double y = i == across / 2 ? along * std::pow(p[1] / along, power) : p[1];
                on_surface.add(surface->nearest({p[0], y, p[2]}));
                if (i != across / 2 || j == 0 || j == along)
                    continue;
                fixed[at(vertex(i, j))] = 0;
                feature_lines[at(vertex(i, j))] = {{ridge}, {vertex(i, j - 1), vertex(i, j + 1)}};
            }
    }
    static std::function<Vector3d(double, double)> place(double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        return [angle](double s, double t) {
            const double x = across * (s - 0.5);
            return Vector3d(x * std::cos(angle), along * t, -std::abs(x) * std::sin(angle));
        };
    }
    Judgement improve(int steps = 20) {
        EmbedOptions options;
        options.steps = steps;
        options.feature_lines = feature_lines;
        return geometry::improve(*surface, mesh.faces(), fixed, on_surface, options);
    }
    const Vector3d &ridge(int j) const { return on_surface.points[at(vertex(across / 2, j))]; }
};

} // namespace alphamst::geometry::samples
