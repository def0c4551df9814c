#include "geometry/plane.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

namespace {

using alphamst::geometry::Plane;
using Eigen::Vector3d;

TEST(Plane, ThereAndBack) {
    const std::vector<Vector3d> points{{1, 0, 0}, {0, 1, 0.1}, {-1, 0, 0}, {0, -1, -0.1}, {0.2, 0.1, 0.3}};
    for (const double side : {1.0, -1.0}) {
        const Plane plane = Plane::fit(points, {0, 0, side});
        EXPECT_GT(plane.normal().z() * side, 0.9);
        double largest = 0;
        for (const auto &p : points) {
            EXPECT_LT((plane.to_space(plane.to_plane(p), plane.height(p)) - p).norm(), 1e-14);
            largest = std::max(largest, (plane.to_space(plane.to_plane(p)) - p).norm());
        }
        EXPECT_NEAR(plane.deviation(points), largest, 1e-14);
        EXPECT_GT(largest, 0.1);
    }
}

TEST(Plane, KeepsOrientationSeenFromTheNormal) {
    const std::vector<Vector3d> triangle{{0, 0, 5}, {1, 0, 6}, {0, 1, 7}};
    const Plane plane = Plane::fit(triangle, {0, 0, 1});
    const Eigen::Vector2d a = plane.to_plane(triangle[1]) - plane.to_plane(triangle[0]),
                          b = plane.to_plane(triangle[2]) - plane.to_plane(triangle[0]);
    EXPECT_NEAR(a.x() * b.y() - a.y() * b.x(),
                (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).norm(), 1e-13);
    EXPECT_LT(plane.deviation(triangle), 1e-14);
}

TEST(Plane, PointsThatDetermineNone) {
    const std::vector<Vector3d> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, one{{3, 4, 5}};
    EXPECT_LT((Plane::fit(line, {1, 0, 1}).normal() - Vector3d(0, 0, 1)).norm(), 1e-9);
    EXPECT_LT((Plane::fit(one, {0, 2, 0}).normal() - Vector3d(0, 1, 0)).norm(), 1e-12);
    EXPECT_NEAR(Plane::fit(line, {1, 0, 0}).normal().norm(), 1, 1e-12);
}

} // namespace
