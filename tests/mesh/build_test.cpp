#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "grids.h"

namespace alphamst::mesh {
namespace {

using Ids = std::vector<std::int64_t>;

Failure build_failure(const Grid &grid, int dim = 3) {
    return failure_of([&] { grid.build(dim); });
}

// Every {} must have an id.
void expect(const Failure &failure, Fault fault, Entity entity, const Ids &ids) {
    EXPECT_EQ(failure.fault, fault) << failure.text;
    EXPECT_EQ(failure.entity, entity) << failure.text;
    EXPECT_EQ(failure.ids, ids) << failure.text;
    std::size_t holes = 0;
    for (std::size_t at = failure.text.find("{}"); at != std::string::npos;
         at = failure.text.find("{}", at + 1))
        ++holes;
    EXPECT_EQ(holes, ids.size()) << failure.text;
}

TEST(Build, EmptyMesh) {
    const QuadMesh mesh = Grid{}.build();
    EXPECT_EQ(mesh.n_vertices() + mesh.n_edges() + mesh.n_faces(), 0);
    EXPECT_NO_THROW(mesh.check());
}

TEST(Build, VerticesWithoutFaces) {
    Grid grid = plane(2, 1);
    grid.points.insert(grid.points.end(), {9, 9, 0, 8, 8, 0});
    const QuadMesh mesh = grid.build();
    EXPECT_EQ(mesh.n_vertices(), 8);
    EXPECT_TRUE(mesh.isolated(6));
    EXPECT_TRUE(mesh.isolated(7));
    EXPECT_FALSE(mesh.isolated(5));
    EXPECT_NO_THROW(mesh.check());

    const QuadMesh cloud = Grid{{0, 0, 0, 1, 1, 1}, {}}.build(3);
    EXPECT_EQ(cloud.n_vertices(), 2);
    EXPECT_NO_THROW(cloud.check());
}

TEST(Build, KeepsCornerOrderAlsoForOpenMesh) {
    Grid grid = plane(3, 3);
    std::rotate(grid.faces.begin() + 16, grid.faces.begin() + 18, grid.faces.begin() + 20);
    const QuadMesh mesh = grid.build();
    for (int f = 0; f < mesh.n_faces(); ++f) {
        std::array<int, 4> given;
        std::copy_n(grid.faces.begin() + 4 * f, 4, given.begin());
        EXPECT_EQ(mesh.corners(f), given);
        std::size_t i = 0;
        for (const auto v : mesh.kernel().fv_range(Kernel::FaceHandle(f)))
            EXPECT_EQ(v.idx(), given[i++]);
    }
}

TEST(Build, EdgesAscendByVertices) {
    const QuadMesh mesh = torus(5, 4).build(3);
    for (int e = 1; e < mesh.n_edges(); ++e)
        EXPECT_LT(mesh.edge_vertices(e - 1), mesh.edge_vertices(e));
}

TEST(Build, AnyFaceOrderGivesTheSameEdges) {
    std::mt19937 random(1);
    const Grid grid = plane(9, 7);
    const QuadMesh mesh = grid.build();
    for (int run = 0; run < 20; ++run) {
        std::vector<int> order(63);
        for (int f = 0; f < 63; ++f)
            order[std::size_t(f)] = f;
        std::shuffle(order.begin(), order.end(), random);
        Grid shuffled{grid.points, {}};
        for (const int f : order) {
            auto corners = mesh.corners(f);
            std::rotate(corners.begin(), corners.begin() + random() % 4, corners.end());
            shuffled.faces.insert(shuffled.faces.end(), corners.begin(), corners.end());
        }
        const QuadMesh other = shuffled.build();
        EXPECT_NO_THROW(other.check());
        ASSERT_EQ(other.n_edges(), mesh.n_edges());
        for (int e = 0; e < mesh.n_edges(); ++e) {
            EXPECT_EQ(other.edge_vertices(e), mesh.edge_vertices(e));
            auto faces = other.edge_faces(e);
            for (int &f : faces)
                f = f < 0 ? -1 : order[std::size_t(f)];
            EXPECT_EQ(faces, mesh.edge_faces(e));
        }
    }
}

TEST(Build, BadArguments) {
    EXPECT_EQ(build_failure(plane(1, 1), 4).fault, Fault::argument);
    EXPECT_EQ(build_failure({{0, 0}, {}}).fault, Fault::argument);
    EXPECT_EQ(build_failure({{0, 0, 0}, {0, 0, 0}}).fault, Fault::argument);
}

TEST(Build, NotFinite) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
        Grid grid = plane(2, 2);
        grid.points[3 * 5 + 1] = bad;
        expect(build_failure(grid), Fault::not_finite, Entity::vertex, {5});
    }
}

TEST(Build, CornerOutOfRange) {
    for (const std::int32_t bad :
         {-1, 9, std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::min()}) {
        Grid grid = plane(2, 2);
        grid.faces[4 * 3 + 2] = bad;
        expect(build_failure(grid), Fault::range, Entity::face, {3, bad});
    }
}

TEST(Build, RepeatedCorner) {
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            if (i == j)
                continue;
            Grid grid = plane(2, 2);
            grid.faces[std::size_t(8 + i)] = grid.faces[std::size_t(8 + j)];
            expect(build_failure(grid), Fault::not_quad, Entity::face, {2, grid.faces[std::size_t(8 + j)]});
        }
}

TEST(Build, ThreeFacesAtAnEdge) {
    Grid grid = plane(2, 1); // faces 0 1 4 3 and 1 2 5 4; a third one at 1-4
    grid.points.insert(grid.points.end(), {1, 0, 1, 1, 1, 1});
    grid.faces.insert(grid.faces.end(), {1, 6, 7, 4});
    expect(build_failure(grid), Fault::not_manifold, Entity::face, {2, 1, 4});
}

TEST(Build, TwoFacesInOneDirection) {
    Grid grid = plane(2, 1);
    std::reverse(grid.faces.begin() + 4, grid.faces.end());
    expect(build_failure(grid), Fault::not_manifold, Entity::face, {1, 0, 1, 4});

    Grid doubled = plane(1, 1);
    doubled.faces.insert(doubled.faces.end(), {3, 0, 1, 2});
    EXPECT_EQ(build_failure(doubled).fault, Fault::not_manifold);
}

TEST(Build, MoebiusStripIsRefused) {
    Grid strip;
    for (int i = 0; i < 5; ++i)
        strip.points.insert(strip.points.end(), {double(i), 0, 0, double(i), 1, 0});
    for (int i = 0; i < 4; ++i)
        strip.faces.insert(strip.faces.end(), {2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
    strip.faces.insert(strip.faces.end(), {8, 1, 0, 9});
    EXPECT_EQ(build_failure(strip).fault, Fault::not_manifold);
}

TEST(Build, TwoOpenFansAtAVertex) {
    Grid grid = plane(2, 2);
    grid.faces = {0, 1, 4, 3, 4, 5, 8, 7};
    expect(build_failure(grid), Fault::not_manifold, Entity::vertex, {4});
}

TEST(Build, OpenFanBesideAClosedOneAtAVertex) {
    Grid grid = plane(2, 2); // closed fan at 4
    grid.points.insert(grid.points.end(), {1, 1, 1, 2, 1, 1, 1, 2, 1});
    grid.faces.insert(grid.faces.end(), {4, 9, 10, 11});
    expect(build_failure(grid), Fault::not_manifold, Entity::vertex, {4});
}

TEST(Build, TwoClosedFansAtAVertex) {
    Grid one = plane(2, 2), both = one;
    both.points.insert(both.points.end(), one.points.begin(), one.points.end());
    for (const auto v : one.faces)
        both.faces.push_back(v == 4 ? 4 : v + 9);
    expect(build_failure(both), Fault::not_manifold, Entity::vertex, {4});
}

TEST(Build, PillowIsAManifold) {
    const QuadMesh mesh = Grid{plane(1, 1).points, {0, 1, 3, 2, 2, 3, 1, 0}}.build(3);
    EXPECT_EQ(mesh.n_edges(), 4);
    EXPECT_NO_THROW(mesh.check());
    EXPECT_EQ(mesh.valence(0), 2);
}

// A vertex of very many faces must not cost the square of their number.
TEST(Build, HighValence) {
    Grid star{{0, 0, 0}, {}};
    const int n = 100000;
    for (int i = 0; i < 2 * n; ++i)
        star.points.insert(star.points.end(), {std::cos(i), std::sin(i), double(i)});
    for (int i = 0; i < n; ++i)
        star.faces.insert(star.faces.end(), {0, 1 + 2 * i, 2 + 2 * i, 1 + (2 * i + 2) % (2 * n)});
    const QuadMesh mesh = star.build(3);
    EXPECT_EQ(mesh.valence(0), n);
    EXPECT_NO_THROW(mesh.check());
}

} // namespace
} // namespace alphamst::mesh
