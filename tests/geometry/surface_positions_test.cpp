#include "geometry/surface_positions.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <memory>
#include <numeric>

#include "mesh/curved.h"
#include "reference/surface_of.h"
#include "square.h"

namespace alphamst::geometry {
namespace {

using Eigen::Vector3d;
using surface::Surface;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// In the plane through the origin with this normal.
SurfacePositions plane(const Points &points, const Vector3d &normal) {
    const Vector3d along = normal.unitOrthogonal(), across = normal.cross(along);
    SurfacePositions on_surface;
    for (const Eigen::Vector2d &p : points)
        on_surface.add({0, p.x() * along + p.y() * across, normal, 0});
    return on_surface;
}

void expect_same(const Judgement &a, const Judgement &b) {
    EXPECT_NEAR(a.min_determinant, b.min_determinant, 1e-12);
    EXPECT_NEAR(a.min_scaled_jacobian, b.min_scaled_jacobian, 1e-12);
    EXPECT_NEAR(a.min_shape, b.min_shape, 1e-12);
    EXPECT_EQ(a.inverted, b.inverted);
    EXPECT_EQ(a.poor, b.poor);
    EXPECT_EQ(a.valid, b.valid);
}

TEST(SurfacePositions, FlatOneIsJudgedAsInThePlane) {
    const Vector3d tilted = Vector3d(1, -2, 0.5).normalized();
    int inverted = 0, poor = 0, valid = 0;
    for (unsigned seed = 0; seed < 20; ++seed)
        for (const double noise : {0.2, 0.3, 0.45}) {
            const samples::Square s = samples::noisy(8, noise, seed);
            const Judgement planar = shapes_of(s.quads, s.points);
            for (const Vector3d &normal : {Vector3d(0, 0, 1), tilted})
                expect_same(judge(s.quads, plane(s.points, normal)), planar);
            inverted += planar.inverted;
            poor += planar.poor;
            valid += planar.valid;
        }
    EXPECT_GT(inverted, 20); // there is something to count
    EXPECT_GT(poor, inverted);
    EXPECT_GE(valid, 20);
}

TEST(SurfacePositions, ScaledJacobiansAreThoseOfEachQuad) {
    const samples::Square s = samples::noisy(6, 0.3, 4);
    const SurfacePositions on_surface = plane(s.points, Vector3d(2, 3, 6) / 7);
    const std::vector<double> found = scaled_jacobians(s.quads, on_surface);
    ASSERT_EQ(found.size(), s.quads.size());
    for (std::size_t q = 0; q < found.size(); ++q)
        EXPECT_NEAR(found[q], shapes_of(Quads(s.quads).subspan(q, 1), s.points).min_scaled_jacobian, 1e-12);
}

TEST(SurfacePositions, AQuadTurnedOverHasANegativeScaledJacobian) {
    const Points square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const std::vector<std::array<int, 4>> upright{{0, 1, 2, 3}}, turned{{3, 2, 1, 0}};
    const SurfacePositions on_surface = plane(square, Vector3d(0, 0, 1));
    EXPECT_NEAR(scaled_jacobians(upright, on_surface).at(0), 1, 1e-15);
    EXPECT_NEAR(scaled_jacobians(turned, on_surface).at(0), -1, 1e-15);
    const Judgement judgement = judge(turned, on_surface);
    EXPECT_EQ(judgement.inverted, 1);
    EXPECT_EQ(judgement.poor, 1);
    EXPECT_FALSE(judgement.valid);
}

// Two long quads, and between them a short one folded under the first, on a surface that looks sideways
// there.
TEST(SurfacePositions, AQuadFoldedAmongItsNeighboursIsTurnedWhateverTheSurfaceSays) {
    SurfacePositions on_surface;
    const Vector3d up(0, 0, 1), sideways(1, 0, 0);
    for (const double y : {0.0, 1.0}) {
        on_surface.add({0, {0, y, 0}, up, 0});
        on_surface.add({0, {10, y, 0}, sideways, 0});
        on_surface.add({0, {9.4, y, -0.8}, sideways, 0});
        on_surface.add({0, {20, y, -0.8}, up, 0});
    }
    const std::vector<std::array<int, 4>> quads{{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}};
    // Alone it is fine: its normal is (0.8, 0, -0.6).
    EXPECT_NEAR(scaled_jacobians(Quads(quads).subspan(1, 1), on_surface).at(0), 0.8, 1e-12);
    EXPECT_NEAR(least_jacobian(quads[1], on_surface), 0.8, 1e-12);
    EXPECT_TRUE(judge(Quads(quads).subspan(1, 1), on_surface).valid);
    EXPECT_NEAR(total_area(quads, on_surface), 10 + 1 + 10.6, 1e-12);
    // Against the mean of the normals of the mesh at its corners, by hand.
    const Vector3d mean =
        (Vector3d(0.8, 0, 9.4).normalized() + Vector3d(0.8, 0, 10).normalized()).normalized();
    const std::vector<double> found = scaled_jacobians(quads, on_surface);
    EXPECT_NEAR(found[1], mean.dot(Vector3d(0.8, 0, -0.6)), 1e-12);
    EXPECT_LT(found[1], -0.5);
    EXPECT_GT(found[0], 0.5);
    EXPECT_GT(found[2], 0.5);
    const Judgement judgement = judge(quads, on_surface);
    EXPECT_EQ(judgement.inverted, 1);
    EXPECT_EQ(judgement.min_scaled_jacobian, found[1]);
    EXPECT_FALSE(judgement.valid);
}

// One of two squares at an edge of a cube, with the normals that the other side has at two of its corners.
TEST(SurfacePositions, VerticesWithoutANormalHaveNoSay) {
    const std::vector<std::array<int, 4>> quads{{0, 1, 2, 3}, {1, 4, 5, 2}};
    SurfacePositions on_surface = plane({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, Vector3d(0, 0, 1));
    const Vector3d way = on_surface.points[1] - on_surface.points[0];
    for (const std::size_t k : {1u, 2u}) {
        on_surface.normals[k] = way;
        on_surface.add({0, on_surface.points[k] - Vector3d(0, 0, 1), way, 0});
    }
    const double misled = least_jacobian(quads[0], on_surface);
    EXPECT_NEAR(misled, std::sqrt(0.5), 1e-12);
    on_surface.normals[1] = on_surface.normals[2] = Vector3d::Zero();
    EXPECT_NEAR(least_jacobian(quads[0], on_surface), 1, 1e-12);
    EXPECT_NEAR(least_jacobian(quads[1], on_surface), 1, 1e-12);
    // The others still tell that a quad is inverted; without any it goes by itself.
    on_surface.normals[0] = on_surface.normals[3] = Vector3d(0, 0, -1);
    EXPECT_NEAR(least_jacobian(quads[0], on_surface), -1, 1e-12);
    on_surface.normals[0] = on_surface.normals[3] = Vector3d::Zero();
    EXPECT_NEAR(least_jacobian(quads[0], on_surface), 1, 1e-12);
}

// A sphere with its vertices moved at random along it, but for a few, which are fixed.
struct Ball {
    mesh::QuadMesh mesh;
    std::shared_ptr<const Surface> surface;
    std::vector<char> fixed;
    SurfacePositions on_surface;

    explicit Ball(int n, double noise) : mesh(mesh::sphere(n)), surface(reference::surface_of(mesh)) {
        std::mt19937 random(7);
        const auto shift = [&] {
            return noise / n * (2.0 * static_cast<double>(random()) / std::mt19937::max() - 1);
        };
        for (int v = 0; v < mesh.n_vertices(); ++v) {
            fixed.push_back(random() % 10 == 0);
            const double x = shift(), y = shift(), z = shift();
            const Vector3d p = Vector3d(mesh.point(v).data()) + (fixed.back() ? 0 : 1) * Vector3d(x, y, z);
            on_surface.add(surface->nearest(p));
        }
    }
    Quads quads() const { return mesh.faces(); }
    double area(std::size_t quad) const {
        const auto &q = quads()[quad];
        const auto &p = on_surface.points;
        return (p[at(q[2])] - p[at(q[0])]).cross(p[at(q[3])] - p[at(q[1])]).norm() / 2;
    }
    double height(std::size_t quad) const {
        double sum = 0;
        for (const int v : quads()[quad])
            sum += on_surface.points[at(v)].z() / 4;
        return sum;
    }
};

TEST(SurfacePositions, ImprovingMovesFreeVerticesAlongTheSurfaceForBetterQuads) {
    for (const double noise : {0.5, 0.8, 1.2}) {
        Ball ball(12, noise);
        const SurfacePositions before = ball.on_surface;
        const Judgement bad = judge(ball.quads(), before);
        const Judgement good = improve(*ball.surface, ball.quads(), ball.fixed, ball.on_surface, {});
        expect_same(judge(ball.quads(), ball.on_surface), good);
        EXPECT_GT(good.min_scaled_jacobian, bad.min_scaled_jacobian + 0.1);
        EXPECT_GT(good.min_scaled_jacobian, 0.7);
        EXPECT_LE(good.poor, bad.poor);
        EXPECT_TRUE(good.valid);
        int moved = 0;
        for (std::size_t v = 0; v < before.points.size(); ++v) {
            const Vector3d &p = ball.on_surface.points[v], &old = before.points[v];
            if (ball.fixed[v]) {
                EXPECT_EQ(std::memcmp(p.data(), old.data(), 3 * sizeof(double)), 0);
                EXPECT_EQ(ball.on_surface.surface_triangles[v], before.surface_triangles[v]);
                continue;
            }
            moved += p != old;
            EXPECT_LT(ball.surface->nearest(p).distance, 1e-12);
            const surface::Spot there = ball.surface->follow(p, ball.on_surface.surface_triangles[v]);
            EXPECT_LT(there.distance, 1e-12);
            EXPECT_LT((there.normal - ball.on_surface.normals[v]).norm(), 0.02);
        }
        EXPECT_GT(10 * moved, 8 * static_cast<int>(before.points.size()));
    }
}

TEST(SurfacePositions, ImprovingTurnsOverWhatIsInverted) {
    Ball ball(12, 2);
    const Judgement bad = judge(ball.quads(), ball.on_surface);
    EXPECT_GT(bad.inverted, 10);
    const Judgement good = improve(*ball.surface, ball.quads(), ball.fixed, ball.on_surface, {});
    EXPECT_EQ(good.inverted, 0);
    EXPECT_TRUE(good.valid);
}

// The areas of the quads on the upper half of a sphere over those on the lower one, where they are wanted so
// many times as large.
double upper_over_lower(double wanted) {
    Ball ball(4, 0);
    std::fill(ball.fixed.begin(), ball.fixed.end(), char(0));
    std::vector<char> is_upper;
    std::vector<double> area;
    double sum = 0, total = 0;
    for (std::size_t q = 0; q < ball.quads().size(); ++q) {
        is_upper.push_back(ball.height(q) > 0);
        area.push_back(is_upper[q] ? wanted : 1);
        sum += area[q];
        total += ball.area(q);
    }
    for (double &a : area)
        a *= total / sum;
    EmbedOptions options;
    options.steps = 100;
    if (wanted != 1)
        options.area = area;
    EXPECT_TRUE(improve(*ball.surface, ball.quads(), ball.fixed, ball.on_surface, options).valid);
    double upper = 0, lower = 0;
    for (std::size_t q = 0; q < area.size(); ++q)
        (is_upper[q] ? upper : lower) += ball.area(q);
    return upper / lower;
}

// Without areas all are to be equal; with them, the shapes have a say, too.
TEST(SurfacePositions, ImprovingApproachesTheWantedAreas) {
    EXPECT_NEAR(upper_over_lower(1), 1, 0.02);
    for (const double wanted : {2.0, 4.0}) {
        EXPECT_GT(upper_over_lower(wanted), 0.65 * wanted);
        EXPECT_LT(upper_over_lower(wanted), wanted);
    }
}

TEST(SurfacePositions, ImprovingDoesNotDependOnTheOrderOfItsPieces) {
    const Ball start(24, 1);
    const auto improved = [&](const geometry::Run &run) {
        Ball ball = start;
        EmbedOptions options;
        options.steps = 4;
        options.run = run;
        improve(*ball.surface, ball.quads(), ball.fixed, ball.on_surface, options);
        return ball.on_surface;
    };
    using Work = std::function<void(std::size_t)>;
    std::size_t most = 0;
    const SurfacePositions forward = improved([&](std::size_t n, const Work &work) {
        most = std::max(most, n);
        for (std::size_t i = 0; i < n; ++i)
            work(i);
    });
    EXPECT_GT(most, 2u);
    EXPECT_NE(forward.points, start.on_surface.points);
    std::mt19937 random(1);
    const SurfacePositions backward = improved([](std::size_t n, const Work &work) {
        for (std::size_t i = n; i-- > 0;)
            work(i);
    });
    const SurfacePositions mixed = improved([&](std::size_t n, const Work &work) {
        std::vector<std::size_t> order(n);
        std::iota(order.begin(), order.end(), std::size_t(0));
        for (std::size_t i = n; i > 1; --i)
            std::swap(order[i - 1], order[random() % i]);
        for (const std::size_t i : order)
            work(i);
    });
    for (const SurfacePositions *other : {&backward, &mixed}) {
        EXPECT_EQ(other->points, forward.points);
        EXPECT_EQ(other->normals, forward.normals);
        EXPECT_EQ(other->surface_triangles, forward.surface_triangles);
    }
}

} // namespace
} // namespace alphamst::geometry
