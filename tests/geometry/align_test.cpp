#include "geometry/align.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesh/cross_field.h"
#include "mesh/curved.h"
#include "reference/surface_of.h"

namespace alphamst::geometry {
namespace {

using Eigen::Vector3d;

constexpr double turn = 2 * std::numbers::pi;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Vector3d ring(double u, double v) {
    return {(2 + std::cos(turn * v)) * std::cos(turn * u), (2 + std::cos(turn * v)) * std::sin(turn * u),
            std::sin(turn * v)};
}

// A torus whose rows waver about the parallels, and the directions of these.
struct Waves {
    mesh::QuadMesh mesh = mesh::grid(
        60, 30, [](double u, double v) { return ring(u, v + 0.02 * std::sin(3 * turn * u)); }, true, true);
    std::vector<Vector3d> directions;
    std::vector<double> cross_field;
    SurfacePositions on_surface;
    std::shared_ptr<const surface::Surface> surface = reference::surface_of(mesh);

    Waves() {
        for (int v = 0; v < mesh.n_vertices(); ++v) {
            const auto &p = mesh.point(v);
            on_surface.add(surface->nearest({p[0], p[1], p[2]}));
        }
        for (const auto &quad : mesh.faces()) {
            Vector3d middle = Vector3d::Zero();
            for (const int v : quad)
                middle += on_surface.points[at(v)] / 4;
            directions.push_back(Vector3d(-middle.y(), middle.x(), 0).normalized());
            cross_field.insert(cross_field.end(), directions.back().data(), directions.back().data() + 3);
        }
    }

    double angle() {
        for (int v = 0; v < mesh.n_vertices(); ++v) {
            const Vector3d &p = on_surface.points[at(v)];
            mesh.set_point(v, {p.x(), p.y(), p.z()});
        }
        return mesh::alignment(mesh, cross_field);
    }
};

TEST(Align, TurnsSidesTowardsTheDirections) {
    Waves waves;
    const double before = waves.angle();
    const std::vector<char> fixed(waves.on_surface.points.size(), 0);
    EmbedOptions options;
    options.steps = 100;
    align(*waves.surface, waves.mesh.faces(), fixed, waves.directions, waves.on_surface, options);
    EXPECT_LT(waves.angle(), 0.6 * before);
    EXPECT_GT(judge(waves.mesh.faces(), waves.on_surface).min_scaled_jacobian, 0.4);
    for (const Vector3d &p : waves.on_surface.points)
        EXPECT_LT(waves.surface->nearest(p).distance, 1e-12);
}

TEST(Align, FixedVerticesStay) {
    Waves waves;
    const SurfacePositions before = waves.on_surface;
    std::vector<char> fixed(before.points.size(), 0);
    for (std::size_t v = 0; v < fixed.size(); v += 3)
        fixed[v] = 1;
    align(*waves.surface, waves.mesh.faces(), fixed, waves.directions, waves.on_surface, {});
    bool moved = false;
    for (std::size_t v = 0; v < fixed.size(); ++v) {
        if (fixed[v]) {
            EXPECT_EQ(waves.on_surface.points[v], before.points[v]);
        }
        moved |= waves.on_surface.points[v] != before.points[v];
    }
    EXPECT_TRUE(moved);
}

TEST(Align, LeavesWhatIsAligned) {
    Waves waves;
    EmbedOptions options;
    options.steps = 200;
    const std::vector<char> fixed(waves.on_surface.points.size(), 0);
    align(*waves.surface, waves.mesh.faces(), fixed, waves.directions, waves.on_surface, options);
    const SurfacePositions once = waves.on_surface;
    options.steps = 1;
    align(*waves.surface, waves.mesh.faces(), fixed, waves.directions, waves.on_surface, options);
    for (std::size_t v = 0; v < once.points.size(); ++v)
        EXPECT_LT((waves.on_surface.points[v] - once.points[v]).norm(), 1e-2);
}

} // namespace
} // namespace alphamst::geometry
