#include "reference/projection.h"

#include <gtest/gtest.h>

#include "../mesh/grids.h"

namespace alphamst::reference {
namespace {

using Points = std::vector<Eigen::Vector3d>;

// The lower side of a grid belongs to a parabola.
Points to_parabola(std::span<const std::int32_t>, const Points &points) {
    Points projected = points;
    for (Eigen::Vector3d &p : projected)
        if (p.y() < 0.5 && p.x() > 0 && p.x() < 4)
            p.y() = -0.02 * p.x() * (4 - p.x());
    return projected;
}

mesh::QuadMesh bent() {
    mesh::Grid grid = mesh::plane(4, 3);
    for (std::size_t v = 1; v < 4; ++v)
        grid.points[3 * v + 1] = -0.02 * grid.points[3 * v] * (4 - grid.points[3 * v]);
    return grid.build();
}

TEST(Projection, CurvesAreFinerBetweenTheVertices) {
    mesh::QuadMesh mesh = bent();
    keep_boundary(mesh, to_parabola, 0.5);
    const Boundary boundary = boundary_of(mesh, 1);
    EXPECT_EQ(boundary.curves, mesh.boundary);
    const surface::CurvePlace from = boundary.places[1], to = boundary.places[2];
    const Eigen::Vector3d middle =
        boundary.curves->at(boundary.curves->advance(from, boundary.curves->way(from, to) / 2));
    EXPECT_NEAR(middle.y(), -0.02 * 1.5 * 2.5, 1e-5);
}

TEST(Projection, WithoutOneTheEdgesAreTheCurve) {
    mesh::QuadMesh mesh = bent();
    keep_boundary(mesh, {}, 0.5);
    const auto first = mesh.boundary;
    EXPECT_DOUBLE_EQ(first->length(0), curves_of_boundary(mesh)->length(0));
    keep_boundary(mesh, {}, 0.5);
    EXPECT_EQ(mesh.boundary, first);
    mesh.set_point(2, {2, -0.5, 0}); // no longer on it
    keep_boundary(mesh, {}, 0.5);
    EXPECT_NE(mesh.boundary, first);
}

TEST(Projection, NewVerticesGoWhereItSays) {
    mesh::QuadMesh mesh = bent();
    mesh.vertex_origin[2] = -1;
    mesh.vertex_origin[6] = -1; // inside
    mesh.set_point(2, {2, -0.05, 0});
    project_new_vertices(mesh, to_parabola, 0.5);
    EXPECT_DOUBLE_EQ(mesh.point(2)[1], -0.08);
    EXPECT_EQ(mesh.point(6)[1], 1);
}

TEST(Projection, WhatIsFarOrNotANumberIsRefused) {
    for (const double y : {-0.6, std::numeric_limits<double>::quiet_NaN()}) {
        mesh::QuadMesh mesh = bent();
        const Project bad = [&](std::span<const std::int32_t> markers, const Points &points) {
            Points projected = to_parabola(markers, points);
            projected.back().y() = y;
            return projected;
        };
        const Failure failure = mesh::failure_of([&] { keep_boundary(mesh, bad, 0.5); });
        EXPECT_EQ(failure.fault, Fault::projection) << failure.text;
        EXPECT_EQ(mesh.boundary, nullptr);
    }
}

TEST(Projection, FacesMustNotTurnOver) {
    mesh::QuadMesh mesh = bent();
    mesh.vertex_origin[2] = -1;
    const Project up = [](std::span<const std::int32_t>, const Points &points) {
        return Points(points.size(), Eigen::Vector3d(2, 1.1, 0));
    };
    EXPECT_EQ(mesh::failure_of([&] { project_new_vertices(mesh, up, 2); }).fault, Fault::projection);
}

} // namespace
} // namespace alphamst::reference
