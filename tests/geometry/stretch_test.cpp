#include "geometry/parametrise.h"

#include <gtest/gtest.h>

#include <limits>

#include "sheet.h"

namespace alphamst::geometry {
namespace {

using namespace samples;

TEST(Stretch, StretchIsTheRootMeanSquareOfSingularValues) {
    const Sheet sheet(4, 4, [](double s, double t) { return Vector3d(6 * s, 2 * t, 0); });
    Points square; // 3 times as long as wide
    for (const Vector3d &p : sheet.points)
        square.emplace_back(p.x() / 3, p.y());
    // Singular values 3 and 1: root of (9 + 1) / 2, over the root of the growth of area.
    EXPECT_NEAR(stretch(sheet.disk(), square), std::sqrt(5.0 / 3), 1e-12);
    for (const double s : vertex_stretch(sheet.disk(), square))
        EXPECT_NEAR(s, std::sqrt(5.0), 1e-12);
}

TEST(Stretch, IsOneForASimilarity) {
    const Sheet sheet = flat(3);
    Points positions = conformal(sheet.disk());
    for (Vector2d &p : positions)
        p = Vector2d(2 - 5 * p.y(), 5 * p.x());
    EXPECT_NEAR(stretch(sheet.disk(), positions), 1, 1e-9);
    for (const double s : vertex_stretch(sheet.disk(), positions))
        EXPECT_NEAR(s, 0.2, 1e-9); // without the scale
}

TEST(Stretch, IsInfiniteWhereAQuadHasNoArea) {
    const Sheet sheet(2, 1, [](double s, double t) { return Vector3d(2 * s, t, 0); });
    Points positions;
    for (const Vector3d &p : sheet.points)
        positions.emplace_back(std::min(p.x(), 1.0), p.y()); // the second quad is on a line
    const std::vector<double> of_vertex = vertex_stretch(sheet.disk(), positions);
    for (std::size_t v = 0; v < sheet.points.size(); ++v)
        if (sheet.points[v].x() == 0) {
            EXPECT_NEAR(of_vertex[v], 1, 1e-12);
        } else {
            EXPECT_EQ(of_vertex[v], std::numeric_limits<double>::infinity());
        }
}

} // namespace
} // namespace alphamst::geometry
