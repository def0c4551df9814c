#include "reference/locate.h"

#include <gtest/gtest.h>

#include <random>

#include "adapt/meshes.h"

namespace alphamst::reference {
namespace {

using Eigen::Vector3d;

TEST(PointTree, NearestIsThatOfASearchThroughAll) {
    std::mt19937 random(2);
    std::vector<Vector3d> points;
    for (int i = 0; i < 300; ++i) // many of them twice
        points.emplace_back(random() % 12, random() % 12, random() % 2);
    const PointTree tree(points);
    for (int i = 0; i < 500; ++i) {
        const Vector3d p(adapt::samples::chance(random) * 14 - 1, static_cast<double>(random() % 24) / 2,
                         0.5);
        std::size_t best = 0;
        for (std::size_t k = 1; k < points.size(); ++k)
            if ((points[k] - p).squaredNorm() < (points[best] - p).squaredNorm())
                best = k;
        EXPECT_EQ(tree.nearest(p), best);
    }
}

TEST(FaceTree, NearestIsThatOfASearchThroughAll) {
    std::mt19937 random(3);
    const mesh::QuadMesh mesh = adapt::samples::unstructured(15, 4);
    std::vector<int> faces = adapt::samples::all_faces(mesh);
    std::erase_if(faces, [](int f) { return f % 3 == 0; });
    const FaceTree tree(mesh, faces);
    for (int i = 0; i < 500; ++i) {
        Vector3d p(adapt::samples::chance(random) * 20 - 2, adapt::samples::chance(random) * 20 - 2, 0);
        if (i % 4 == 0) // a corner of several
            p = point_of(mesh, static_cast<int>(random() % static_cast<unsigned>(mesh.n_vertices())));
        int best = -1;
        double least = HUGE_VAL;
        for (const int f : faces)
            if (const double distance = geometry::closest_point(quad_of(mesh, f), p).distance;
                distance < least) {
                least = distance;
                best = f;
            }
        const FaceTree::Place place = tree.nearest(p);
        EXPECT_EQ(place.face, best);
        EXPECT_EQ(place.spot.distance, least);
    }
}

TEST(FaceTree, AroundAQuadAreAllThatItTouches) {
    const mesh::QuadMesh mesh = adapt::samples::grid(6, 6);
    const FaceTree tree(mesh, adapt::samples::all_faces(mesh));
    std::vector<int> found{99};
    tree.around(quad_of(mesh, 14), found);
    EXPECT_EQ(found, (std::vector{7, 8, 9, 13, 14, 15, 19, 20, 21}));
    const geometry::Quad small{Vector3d(0.2, 0.2, 0), Vector3d(0.4, 0.2, 0), Vector3d(0.4, 0.4, 0),
                               Vector3d(0.2, 0.4, 0)};
    tree.around(small, found);
    EXPECT_EQ(found, std::vector{0});
    geometry::Quad lifted = small; // in the plane but for rounding, where boxes are flat
    for (Vector3d &corner : lifted)
        corner.z() = 1e-16;
    tree.around(lifted, found);
    EXPECT_EQ(found, std::vector{0});
}

} // namespace
} // namespace alphamst::reference
