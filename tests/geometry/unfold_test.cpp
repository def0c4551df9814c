#include "geometry/unfold.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "roof.h"

namespace alphamst::geometry {
namespace {

using namespace samples;

TEST(Unfold, LaysASharpCreaseFlat) {
    for (const double degrees : {10.0, 60.0, 89.0}) {
        const Roof roof(degrees, 2);
        const Stars stars(roof.mesh.faces(), roof.mesh.n_vertices());
        const int v = vertex(2, 4);
        std::vector<Sector> sectors;
        Points flat;
        unfold(stars.at(v), roof.on_surface.points, v, roof.feature_lines[at(v)], sectors, flat);
        ASSERT_EQ(sectors.size(), 4u);
        EXPECT_EQ(flat[0], Eigen::Vector2d(0, 0));
        const double here = roof.ridge(4).y();
        for (const Sector &s : sectors) {
            const auto &quad = roof.mesh.faces()[at(s.quad)];
            const auto k = static_cast<std::size_t>(std::find(quad.begin(), quad.end(), v) - quad.begin());
            std::size_t step = 1;
            for (const int point : {s.next, s.opposite, s.previous}) {
                const int w = quad[(k + step++) % 4];
                // Ahead is to the right, so that the columns to the right of the ridge are below.
                EXPECT_NEAR(flat[at(point)].x(), roof.on_surface.points[at(w)].y() - here, 1e-12);
                EXPECT_NEAR(flat[at(point)].y(), across / 2 - w % (across + 1), 1e-12);
            }
        }
    }
}

TEST(Unfold, NeedsAllQuadsAround) {
    const Roof roof(30, 1);
    const Quads some = Quads(roof.mesh.faces()).subspan(0, 4 * across - 2); // not both behind row 3
    const Stars stars(some, roof.mesh.n_vertices());
    std::vector<Sector> sectors;
    Points flat;
    unfold(stars.at(vertex(2, 2)), roof.on_surface.points, vertex(2, 2), roof.feature_lines[at(vertex(2, 2))],
           sectors, flat);
    EXPECT_EQ(sectors.size(), 4u);
    unfold(stars.at(vertex(2, 3)), roof.on_surface.points, vertex(2, 3), roof.feature_lines[at(vertex(2, 3))],
           sectors, flat);
    EXPECT_TRUE(sectors.empty());
    const FeatureLine wrong{roof.feature_lines[at(vertex(2, 2))].lines,
                            {vertex(2, 1), vertex(2, 4)}}; // no neighbour
    unfold(stars.at(vertex(2, 2)), roof.on_surface.points, vertex(2, 2), wrong, sectors, flat);
    EXPECT_TRUE(sectors.empty());
}

} // namespace
} // namespace alphamst::geometry
