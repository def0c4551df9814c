#include "transfer/cell.h"

#include <gtest/gtest.h>

#include <numeric>

#include "adapt/meshes.h"
#include "reference/locate.h"

namespace alphamst::transfer {
namespace {

using adapt::samples::grid;
using mesh::QuadMesh;

TEST(Cells, CoverTheMesh) {
    const QuadMesh mesh = adapt::samples::unstructured(12, 4);
    for (const Entity entity : {Entity::vertex, Entity::face}) {
        const Cells cells(mesh, entity);
        double sum = 0;
        Eigen::Vector3d moment = Eigen::Vector3d::Zero();
        for (int i = 0; i < cells.count(); ++i) {
            sum += cells.area(i);
            moment += cells.area(i) * cells.place(i).centroid;
            EXPECT_NEAR(cells.place(i).normal.norm(), cells.area(i), 1e-13);
        }
        EXPECT_NEAR(sum, 144, 1e-11);
        EXPECT_LT((moment / sum - Eigen::Vector3d(6, 6, 0)).norm(), 1e-12);
    }
}

TEST(Cells, AVertexHasAQuarterOfEachFace) {
    const QuadMesh mesh = grid(3, 2);
    const Cells cells(mesh, Entity::vertex);
    EXPECT_EQ(cells.area(0), 0.25);
    EXPECT_EQ(cells.area(1), 0.5);
    EXPECT_EQ(cells.area(5), 1);
    EXPECT_LT((cells.place(0).centroid - Eigen::Vector3d(0.25, 0.25, 0)).norm(), 1e-15);
    EXPECT_LT((cells.place(1).centroid - Eigen::Vector3d(1, 0.25, 0)).norm(), 1e-15);
    EXPECT_EQ(cells.of({0, 1}), (std::vector<int>{0, 1, 2, 4, 5, 6}));
    EXPECT_EQ(cells.neighbours(5), (std::vector<int>{0, 1, 2, 4, 6, 8, 9, 10}));
}

TEST(Cells, FacesAroundCornersAreNeighboursToo) {
    QuadMesh mesh = grid(4, 4);
    EXPECT_EQ(Cells(mesh, Entity::face).neighbours(5), (std::vector<int>{0, 1, 2, 4, 6, 8, 9, 10}));
    EXPECT_EQ(Cells(mesh, Entity::face).neighbours(0), (std::vector<int>{1, 4, 5}));
    const QuadMesh star = adapt::samples::star(5, 2); // of valence 5
    EXPECT_EQ(Cells(star, Entity::face).neighbours(0).size(), 9u);
}

TEST(Cells, NoneIsBeyondALine) {
    const QuadMesh plain = grid(4, 4);
    const auto left = [](QuadMesh mesh) { return Cells(mesh, Entity::face).neighbours(5); };
    const std::vector<int> wanted{0, 1, 4, 8, 9}; // of face (1, 1), where x = 2 is a line
    QuadMesh regions = plain, features = plain, numbers = plain;
    regions.face_marker.assign(16, 3);
    numbers.edge_marker.assign(static_cast<std::size_t>(plain.n_edges()), 0);
    for (const int f : adapt::samples::block(4, 2, 0, 4, 4))
        regions.face_marker[static_cast<std::size_t>(f)] = 4;
    for (int j = 0; j < 4; ++j) {
        const auto edge = static_cast<std::size_t>(plain.find_edge(5 * j + 2, 5 * j + 7));
        features.edge_flags[edge] = mesh::feature;
        numbers.edge_marker[edge] = 1;
    }
    for (const QuadMesh &mesh : {regions, features, numbers})
        EXPECT_EQ(left(mesh), wanted);
}

} // namespace
} // namespace alphamst::transfer
