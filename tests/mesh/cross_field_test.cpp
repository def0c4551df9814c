#include "mesh/cross_field.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "curved.h"

namespace alphamst::mesh {
namespace {

using Eigen::Vector3d;

constexpr double pi = std::numbers::pi, degree = pi / 180;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Vector3d on_torus(double s, double t) {
    const double r = 3 + std::cos(2 * pi * t);
    return {r * std::cos(2 * pi * s), r * std::sin(2 * pi * s), std::sin(2 * pi * t)};
}

Vector3d point_of(const QuadMesh &mesh, int v) {
    const OpenMesh::Vec3d &p = mesh.point(v);
    return {p[0], p[1], p[2]};
}

Vector3d normal_of(const QuadMesh &mesh, int face) {
    const auto [a, b, c, d] = mesh.corners(face);
    return (point_of(mesh, c) - point_of(mesh, a)).cross(point_of(mesh, d) - point_of(mesh, b)).normalized();
}

Vector3d centre_of(const QuadMesh &mesh, int face) {
    Vector3d sum = Vector3d::Zero();
    for (const int v : mesh.corners(face))
        sum += point_of(mesh, v) / 4;
    return sum;
}

Vector3d cross_of(const std::vector<double> &crosses, int face) {
    return {crosses[3 * at(face)], crosses[3 * at(face) + 1], crosses[3 * at(face) + 2]};
}

// Mean and largest angle, degrees, between the crosses and what `wanted` says at the centre of each face.
template <class Wanted> std::pair<double, double> off(const QuadMesh &mesh, const Wanted &wanted) {
    const std::vector<double> crosses = cross_field(mesh, 20);
    double sum = 0, most = 0;
    for (int f = 0; f < mesh.n_faces(); ++f) {
        const Vector3d direction = wanted(centre_of(mesh, f));
        const Vector3d cross = cross_of(crosses, f);
        EXPECT_NEAR(cross.norm(), 1, 1e-12);
        EXPECT_NEAR(cross.dot(normal_of(mesh, f)), 0, 1e-12);
        const double angle = std::acos(std::min(1.0, std::abs(cross.dot(direction)))) / degree;
        sum += std::min(angle, 90 - angle);
        most = std::max(most, std::min(angle, 90 - angle));
    }
    return {sum / mesh.n_faces(), most};
}

Vector3d axis(const Vector3d &) { return Vector3d::UnitZ(); }
Vector3d around(const Vector3d &p) { return Vector3d(-p.y(), p.x(), 0).normalized(); }

double turn(const Vector3d &from, const Vector3d &to, const Vector3d &normal) {
    return std::atan2(from.cross(to).dot(normal), from.dot(to));
}

// Quarters of a turn that the cross makes around each interior vertex against what a direction does that is
// carried around it.
std::vector<int> indices(const QuadMesh &mesh, const std::vector<double> &crosses) {
    std::vector<int> result;
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        if (mesh.on_boundary(v))
            continue;
        const std::vector<int> faces = mesh.faces_around(v);
        const Vector3d start = cross_of(crosses, faces[0]);
        Vector3d carried = start;
        double sum = 0;
        for (std::size_t k = 0; k < faces.size(); ++k) {
            const int f = faces[k], g = faces[(k + 1) % faces.size()];
            const Vector3d normal = normal_of(mesh, g);
            const auto over = Eigen::Quaterniond::FromTwoVectors(normal_of(mesh, f), normal);
            sum += std::remainder(turn(over * cross_of(crosses, f), cross_of(crosses, g), normal), pi / 2);
            carried = over * carried;
        }
        const double quarters = (sum + turn(start, carried, normal_of(mesh, faces[0]))) / (pi / 2);
        EXPECT_NEAR(quarters, std::round(quarters), 1e-9);
        result.push_back(static_cast<int>(std::lround(quarters)));
    }
    return result;
}

TEST(CrossField, FollowsTheAxisOfACylinder) {
    // Without boundary edges along or around: these are spirals.
    const auto place = [](double s, double t) {
        return Vector3d(std::cos(2 * pi * (s + 0.3 * t)), std::sin(2 * pi * (s + 0.3 * t)), 4 * t);
    };
    const auto [mean, most] = off(grid(40, 40, place, true), axis);
    EXPECT_LT(mean, 0.1);
    EXPECT_LT(most, 0.5);
}

TEST(CrossField, FollowsTheCirclesOfATorus) {
    const auto [mean, most] = off(grid(90, 30, on_torus, true, true), around);
    EXPECT_LT(most, 0.1);
    // Edges that wind around the torus do not mislead it.
    const auto wound = [](double s, double t) { return on_torus(s + t, t); };
    const QuadMesh mesh = grid(300, 100, wound, true, true);
    EXPECT_LT(off(mesh, around).first, 1.5);
    EXPECT_GT(alignment(mesh, cross_field(mesh, 20)), 5);
    EXPECT_LE(mean, most);
}

TEST(CrossField, OfANoisyCylinderIsNearTheAxis) {
    std::mt19937 random(1);
    const auto place = [&](double s, double t) {
        const double r = 1 + 0.04 * (static_cast<double>(random()) / 4294967296.0 - 0.5);
        return Vector3d(r * std::cos(2 * pi * s), r * std::sin(2 * pi * s), 4 * t);
    };
    const QuadMesh mesh = grid(40, 40, place, true);
    const auto [mean, most] = off(mesh, axis);
    EXPECT_LT(mean, 0.6);
    EXPECT_LT(most, 3);
    for (const int index : indices(mesh, cross_field(mesh, 20)))
        EXPECT_EQ(index, 0);
}

TEST(CrossField, FollowsTheSidesOfATurnedSquare) {
    for (const int dim : {2, 3}) {
        const Eigen::AngleAxisd turned(33 * degree, Vector3d::UnitZ());
        // Inside the edges are bent, at the sides they are not.
        const auto place = [&](double s, double t) {
            const double bump = 0.1 * std::sin(pi * s) * std::sin(pi * t);
            return Vector3d(turned * Vector3d(s + bump, t - bump, 0));
        };
        const auto [mean, most] = off(grid(30, 30, place, false, false, dim),
                                      [&](const Vector3d &) { return Vector3d(turned * Vector3d::UnitX()); });
        EXPECT_LT(most, 1e-4);
        EXPECT_LE(mean, most);
    }
}

TEST(CrossField, OfASphereHasEightSingularities) {
    const QuadMesh mesh = sphere(20);
    int sum = 0, n = 0;
    for (const int index : indices(mesh, cross_field(mesh, 20))) {
        sum += index;
        n += index != 0;
    }
    EXPECT_EQ(sum, 8); // Poincare and Hopf: 2, in quarters
    EXPECT_EQ(n, 8);   // and no pair more
}

TEST(CrossField, FollowsFeaturesAndBordersOfMarkers) {
    // Sheared, so that the boundary above and below wants another cross than edges across.
    const int n = 12;
    const QuadMesh plain = grid(n, n, [](double s, double t) { return Vector3d(s + t / 2, t, 0); });
    const Vector3d across = Vector3d(0.5, 1, 0).normalized();
    const auto off_across = [&](const QuadMesh &mesh) { // degrees, beside the middle column of edges
        const Vector3d cross = cross_of(cross_field(mesh, 20), n * (n / 2) + n / 2);
        const double angle = std::acos(std::min(1.0, std::abs(cross.dot(across)))) / degree;
        return std::min(angle, 90 - angle);
    };
    EXPECT_GT(off_across(plain), 5);
    QuadMesh featured = plain, numbered = plain, parted = plain;
    featured.edge_flags.resize(at(plain.n_edges()));
    numbered.edge_marker.resize(at(plain.n_edges()));
    for (int e = 0; e < plain.n_edges(); ++e) {
        const auto [v, w] = plain.edge_vertices(e);
        if (v % (n + 1) == n / 2 && w % (n + 1) == n / 2) {
            featured.edge_flags[at(e)] = feature;
            numbered.edge_marker[at(e)] = 7;
        }
    }
    for (int f = 0; f < plain.n_faces(); ++f)
        parted.face_marker.push_back(f % n < n / 2 ? 1 : 2);
    for (const QuadMesh *mesh : {&featured, &numbered, &parted})
        EXPECT_LT(off_across(*mesh), 0.5);
}

TEST(CrossField, DoesNotDependOnScale) {
    const QuadMesh mesh = grid(20, 10, on_torus, true, true);
    for (const double scale : {0x1p-90, 0x1p90}) {
        const QuadMesh scaled = grid(
            20, 10, [&](double s, double t) { return Vector3d(scale * on_torus(s, t)); }, true, true);
        EXPECT_EQ(cross_field(scaled, 5), cross_field(mesh, 5));
        EXPECT_EQ(alignment(scaled, cross_field(mesh, 5)), alignment(mesh, cross_field(mesh, 5)));
    }
}

TEST(CrossField, IsFiniteWhereFacesHaveNoArea) {
    const QuadMesh points = grid(3, 3, [](double, double) { return Vector3d(1, 2, 3); });
    const QuadMesh line = grid(3, 3, [](double s, double t) { return Vector3d(s + t, 0, 0); });
    for (const QuadMesh *mesh : {&points, &line})
        for (int f = 0; f < mesh->n_faces(); ++f)
            EXPECT_NEAR(cross_of(cross_field(*mesh, 20), f).norm(), 1, 1e-12);
    EXPECT_EQ(alignment(points, cross_field(points, 20)), 0);
}

TEST(CrossField, AlignmentIsTheMeanAngle) {
    const auto place = [](double s, double t) { return Vector3d(s, 2 * t, 0); };
    const QuadMesh mesh = grid(1, 2, place);
    const auto crosses = [](double one, double other) {
        return std::vector<double>{5 * std::cos(one * degree),   5 * std::sin(one * degree),   -4,
                                   5 * std::cos(other * degree), 5 * std::sin(other * degree), 0};
    };
    EXPECT_NEAR(alignment(mesh, crosses(0, 90)), 0, 1e-12);
    EXPECT_NEAR(alignment(mesh, crosses(10, 200)), 15, 1e-12);
    EXPECT_NEAR(alignment(mesh, crosses(45, -135)), 45, 1e-12);
    EXPECT_NEAR(alignment(mesh, crosses(70, -80)), 15, 1e-12);
    EXPECT_NEAR(alignment(mesh, {{0, 0, 0, std::cos(20 * degree), std::sin(20 * degree), 0}}), 20, 1e-12);
    EXPECT_EQ(alignment(mesh, {{0, 0, 0, 0, 0, 1}}), 0);
}

} // namespace
} // namespace alphamst::mesh
