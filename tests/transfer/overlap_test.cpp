#include "transfer/overlap.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "adapt/meshes.h"
#include "adapt/run.h"

namespace alphamst::transfer {
namespace {

using adapt::samples::grid;
using mesh::QuadMesh;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

void expect_areas(const QuadMesh &before, const QuadMesh &after) {
    std::vector<double> olds(at(before.n_faces()), 0), news(at(after.n_faces()), 0);
    std::pair<int, int> last{-1, -1};
    for (const Overlap &overlap : overlaps(before, after)) {
        EXPECT_GT(overlap.area, 0);
        EXPECT_LT(last, std::pair(overlap.after, overlap.before));
        last = {overlap.after, overlap.before};
        olds[at(overlap.before)] += overlap.area;
        news[at(overlap.after)] += overlap.area;
    }
    for (int f = 0; f < before.n_faces(); ++f)
        EXPECT_NEAR(olds[at(f)] / Cells(before, Entity::face).area(f), 1, 1e-12);
    for (int f = 0; f < after.n_faces(); ++f)
        EXPECT_NEAR(news[at(f)] / Cells(after, Entity::face).area(f), 1, 1e-12);
}

TEST(Overlap, OfAMeshWithItselfIsEachFace) {
    const QuadMesh mesh = grid(5, 3);
    const std::vector<Overlap> found = overlaps(mesh, mesh);
    ASSERT_EQ(found.size(), 15u);
    for (std::size_t f = 0; f < found.size(); ++f) {
        EXPECT_EQ(found[f].before, static_cast<int>(f));
        EXPECT_EQ(found[f].after, static_cast<int>(f));
        EXPECT_DOUBLE_EQ(found[f].area, 1);
    }
}

TEST(Overlap, RowsSumUpToTheAreasOfBoth) {
    const QuadMesh mesh = adapt::samples::unstructured(16, 2);
    for (const double alpha : {0.5, 1.0, 2.0}) {
        QuadMesh after = mesh;
        adapt::adapt_whole(after, alpha, {}, adapt::samples::silent);
        expect_areas(mesh, after);
        expect_areas(after, mesh);
    }
}

TEST(Overlap, VerticesShareQuarters) {
    const QuadMesh mesh = grid(2, 2);
    const Cells cells(mesh, Entity::vertex);
    const reference::FaceTree tree(mesh, {0, 1, 2, 3});
    std::vector<double> areas(9, 0);
    for (const Overlap &overlap : overlaps(cells, tree, cells, {0, 1, 2, 3})) {
        EXPECT_EQ(overlap.before, overlap.after);
        areas[at(overlap.before)] += overlap.area;
    }
    EXPECT_EQ(areas, (std::vector<double>{0.25, 0.5, 0.25, 0.5, 1, 0.5, 0.25, 0.5, 0.25}));
}

TEST(Overlap, OfNothingIsNothing) {
    const QuadMesh none = QuadMesh::build(2, {}, {});
    EXPECT_TRUE(overlaps(none, grid(1, 1)).empty());
    EXPECT_TRUE(overlaps(grid(1, 1), none).empty());
}

} // namespace
} // namespace alphamst::transfer
