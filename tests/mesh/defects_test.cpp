#include "mesh/defects.h"

#include <gtest/gtest.h>

#include <limits>

#include "grids.h"

namespace alphamst::mesh {
namespace {

using Ids = std::vector<std::int64_t>;

Failure defects(const Grid &grid) {
    return find_defects(grid.points, grid.faces, grid.points.size() / 3, true);
}

TEST(Defects, AreAllToldWithCounts) {
    Grid grid = plane(3, 3);
    grid.points[3 * 15] = grid.points[3 * 3] = std::numeric_limits<double>::quiet_NaN();
    grid.faces[4 * 8] = 16;
    grid.faces[4 * 7] = grid.faces[4 * 7 + 2];
    const Failure failure = defects(grid);
    EXPECT_EQ(failure.fault, Fault::not_finite);
    EXPECT_EQ(failure.entity, Entity::vertex);
    EXPECT_EQ(
        failure.text,
        "2 vertices have coordinates that are infinite or not numbers; the first: vertex {} has a "
        "coordinate that is infinite or not a number; give finite ones. Besides, face {} has corner {}, "
        "but the mesh has 16 vertices; correct the corner or add the vertex. Besides, face {} has vertex "
        "{} at two corners; give it three or four different corners, or leave it out");
    EXPECT_EQ(failure.ids, (Ids{3, 8, 16, 7, 14}));
}

TEST(Defects, AFaceGivenTwiceIsNamedWithTheOther) {
    Grid grid = plane(6, 6);
    grid.faces.insert(grid.faces.end(), {15, 16, 9, 8}); // face 7 begins elsewhere
    Failure failure = defects(grid);
    EXPECT_EQ(failure.fault, Fault::not_manifold);
    EXPECT_EQ(failure.text, "face {} has the vertices of face {}; leave one of the two out");
    EXPECT_EQ(failure.ids, (Ids{36, 7}));
    grid.faces.insert(grid.faces.end(), {0, 7, 8, 1}); // the other way round, too
    failure = defects(grid);
    EXPECT_EQ(failure.text, "2 faces are given twice; the first: face {} has the vertices of face {}; leave "
                            "one of the two out");
}

TEST(Defects, ThirdFacesAtEdgesBesideRepeatedOnes) {
    Grid grid = plane(2, 1); // faces 0 1 4 3 and 1 2 5 4
    grid.points.insert(grid.points.end(), {1, 0, 1, 1, 1, 1, 0, 5, 5, 1, 5, 5});
    grid.faces.insert(grid.faces.end(), {0, 1, 4, 3, 1, 6, 7, 4, 6, 7, 8, 9});
    const Failure failure = defects(grid);
    EXPECT_EQ(failure.ids, (Ids{2, 0, 3, 1, 4})); // 6-7 has two faces, which run the same way
    EXPECT_NE(failure.text.find("Besides, face {} is the third one at the edge between vertices {} and {}"),
              std::string::npos)
        << failure.text;
}

TEST(Defects, PixelsHaveCrossingCorners) {
    Grid grid = plane(4, 4);
    for (std::size_t f = 0; f < 16; ++f)
        std::swap(grid.faces[4 * f + 2], grid.faces[4 * f + 3]);
    Failure failure = defects(grid);
    EXPECT_EQ(failure.text.find("16 faces have their corners in crossing order; the first: face {} has"), 0u)
        << failure.text;
    EXPECT_EQ(failure.ids, (Ids{0, 0, 1, 5, 6}));

    grid = plane(4, 4);
    std::swap(grid.faces[4 * 5 + 2], grid.faces[4 * 5 + 3]);
    failure = defects(grid);
    EXPECT_EQ(failure.ids.front(), 5);
    EXPECT_EQ(failure.text.find("face {} has its corners in crossing order, as pixels of VTK have"), 0u);
}

TEST(Defects, AFoldedFaceInsideDoesNotCross) {
    Grid grid = plane(3, 3);
    grid.points[3 * 5] = 2.5; // beyond vertex 6
    grid.faces.insert(grid.faces.end(), {0, 16, 17, 18});
    grid.points.insert(grid.points.end(), {-1, 0, 0, -1, -1, 0, 0, -1, 0});
    const Failure failure = defects(grid);
    EXPECT_EQ(failure.text,
              "the faces at vertex {} meet there without sharing edges; give each group of them a vertex of "
              "its own");
    EXPECT_EQ(failure.ids, (Ids{0}));
}

TEST(Defects, AMoebiusStripHasOneSide) {
    const Failure failure = defects(moebius(12));
    EXPECT_EQ(failure.fault, Fault::not_manifold);
    EXPECT_NE(failure.text.find("has only one side, as a Moebius strip"), std::string::npos) << failure.text;
    EXPECT_EQ(failure.entity, Entity::face);
}

// The middle one of three squares in a row and of three rows is cut in four.
TEST(Defects, HangingVerticesAreNamed) {
    Grid grid = plane(3, 3);
    grid.faces.erase(grid.faces.begin() + 16, grid.faces.begin() + 20);
    grid.points.insert(grid.points.end(), {1.5, 1, 0, 2, 1.5, 0, 1.5, 2, 0, 1, 1.5, 0, 1.5, 1.5, 0});
    for (const auto &q : {std::array{5, 16, 20, 19}, {16, 6, 17, 20}, {20, 17, 10, 18}, {19, 20, 18, 9}})
        grid.faces.insert(grid.faces.end(), q.begin(), q.end());
    const Failure failure = defects(grid);
    EXPECT_EQ(failure.entity, Entity::vertex);
    EXPECT_EQ(failure.text.find("4 vertices hang in the middle of an edge; the first: vertex {} hangs in the "
                                "middle of the edge between vertices {} and {}, which face {} has"),
              0u)
        << failure.text;
    EXPECT_EQ(failure.ids, (Ids{16, 6, 5, 1}));
    EXPECT_EQ(failure.text.find("of its own"), std::string::npos); // that would make a slit
}

TEST(Defects, TwoFacesMayBeAPillow) {
    Grid grid{plane(1, 1).points, {0, 1, 3, 2, 2, 3, 1, 0}};
    EXPECT_EQ(defects(grid).fault, Fault::internal); // nothing
    grid.faces = {0, 1, 3, 2, 0, 1, 3, 2};
    EXPECT_EQ(defects(grid).ids, (Ids{1, 0}));
}

} // namespace
} // namespace alphamst::mesh
