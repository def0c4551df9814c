#include "mesh/components.h"

#include <gtest/gtest.h>

#include "grids.h"

namespace alphamst::mesh {
namespace {

Components components_of(const Grid &grid) {
    return find_components(grid.faces,
                           neighbours(grid.faces, sort_sides(grid.faces, grid.points.size() / 3)));
}

TEST(Components, AreNumberedByTheirFirstFaces) {
    Grid grid = plane(5, 1);
    grid.faces.erase(grid.faces.begin() + 4, grid.faces.begin() + 8);        // the second
    std::rotate(grid.faces.begin(), grid.faces.end() - 4, grid.faces.end()); // the last comes first
    const Components components = components_of(grid);
    EXPECT_EQ(components.of_face, (std::vector<std::int32_t>{0, 1, 0, 0}));
    EXPECT_EQ(components.against, std::vector<bool>(4));
    EXPECT_EQ(components.one_sided, (std::vector<std::int32_t>{-1, -1}));
}

TEST(Components, KnowWhichFacesRunAgainstTheFirst) {
    Grid grid = plane(3, 2);
    std::swap(grid.faces[4 * 4 + 1], grid.faces[4 * 4 + 3]);
    EXPECT_EQ(components_of(grid).against, (std::vector<bool>{false, false, false, false, true, false}));
}

TEST(Components, ThreeFacesAtAnEdgeDoNotHangTogether) {
    Grid grid = plane(2, 1);
    grid.points.insert(grid.points.end(), {1, 0, 1, 1, 1, 1});
    grid.faces.insert(grid.faces.end(), {1, 6, 7, 4});
    EXPECT_EQ(components_of(grid).of_face, (std::vector<std::int32_t>{0, 1, 2}));
}

TEST(Components, PinchedVertices) {
    Grid grid = plane(2, 2);
    const auto pinched = [&] { return find_pinched(grid.faces, sort_sides(grid.faces, 9), 9); };
    EXPECT_EQ(pinched(), std::vector<bool>(9));
    grid.faces = {0, 1, 4, 3, 4, 5, 8, 7};
    std::vector<bool> expected(9);
    expected[4] = true;
    EXPECT_EQ(pinched(), expected);
}

TEST(Components, LoneFaces) {
    EXPECT_EQ(count_lone_faces(plane(3, 3).build()), 0);
    EXPECT_EQ(count_lone_faces(plane(1, 1).build()), 1);
    Grid grid = plane(5, 1);
    grid.faces.erase(grid.faces.begin() + 4, grid.faces.begin() + 8);
    EXPECT_EQ(count_lone_faces(grid.build()), 1);
}

} // namespace
} // namespace alphamst::mesh
