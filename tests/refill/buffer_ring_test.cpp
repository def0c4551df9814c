#include "refill/buffer_ring.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "adapt/meshes.h"
#include "index.h"
#include "mesh/curved.h"
#include "patch/grow.h"
#include "patch/region.h"
#include "reference/locate.h"
#include "smooth/shaping.h"

namespace alphamst::refill {
namespace {

using adapt::samples::block;
using adapt::samples::grid;

// A window of a mesh with layers of faces around it.
struct Ringed {
    mesh::QuadMesh mesh;
    Patch patch;
    std::vector<int> buffer;
    Goal goal;
    Settings settings;
    reference::Reference reference;
    std::optional<Cavity> cavity;

    Ringed(mesh::QuadMesh of, std::vector<int> faces, int layers) : mesh(std::move(of)) {
        const std::vector<int> all = patch::Growth(mesh).surround(faces, layers);
        buffer.assign(all.begin() + std::ssize(faces), all.end());
        patch.faces = std::move(faces);
        goal.any_count = true;
        reference = reference::reference_of(mesh);
        cavity.emplace(mesh, patch, goal, settings, reference);
    }
    Ringed(const Ringed &) = delete;
    Ringed &operator=(const Ringed &) = delete;
    BufferRing ring(bool stays) const { return {mesh, *cavity, buffer, stays}; }

    // Those with all faces in the window or around it, and one around it.
    std::set<int> free() const {
        std::set<int> faces(buffer.begin(), buffer.end()), vertices;
        for (const int f : buffer)
            for (const int v : mesh.corners(f)) {
                const std::vector<int> around = mesh.faces_around(v);
                if (!mesh.on_boundary(v) && std::all_of(around.begin(), around.end(), [&](int g) {
                        return faces.contains(g) || patch::contains(patch.faces, g);
                    }))
                    vertices.insert(v);
            }
        return vertices;
    }
};

// Of the plane with a vertex of the loop pulled aside.
mesh::QuadMesh pulled() {
    mesh::QuadMesh mesh = grid(10, 10);
    mesh.set_point(4 * 11 + 4, OpenMesh::Vec3d(4.4, 4.3, 0));
    return mesh;
}

// Three by three faces with that vertex at their lower left corner.
std::vector<int> middle() { return block(10, 4, 4, 7, 7); }

std::set<int> vertices_of(const Moved &moved) {
    std::set<int> vertices;
    for (const auto &[v, point] : moved.vertices)
        vertices.insert(v);
    EXPECT_EQ(vertices.size(), moved.vertices.size());
    return vertices;
}

TEST(ShapeBounds, OfBothAreTheWorseOnesAndTheSums) {
    const ShapeBounds a{0.5, 0.8, 3, 1}, b{0.6, 0.2, 4, 2}, sum = both(a, b);
    EXPECT_EQ(sum.scaled_jacobian, 0.5);
    EXPECT_EQ(sum.shape, 0.2);
    EXPECT_EQ(sum.poor, 7);
    EXPECT_EQ(sum.inverted, 3);
    geometry::Judgement judgement;
    judgement.min_scaled_jacobian = 0.3;
    judgement.min_shape = 0.4;
    judgement.poor = 5;
    judgement.inverted = 6;
    const ShapeBounds shape = shape_of(judgement);
    EXPECT_EQ(shape.scaled_jacobian, 0.3);
    EXPECT_EQ(shape.shape, 0.4);
    EXPECT_EQ(shape.poor, 5);
    EXPECT_EQ(shape.inverted, 6);
}

TEST(ShapeBounds, AreReachedOnlyInAllOfThem) {
    const ShapeBounds wanted{0.5, 0.4, 3, 1};
    EXPECT_TRUE(reaches(wanted, wanted));
    EXPECT_TRUE(reaches({0.6, 0.5, 0, 0}, wanted));
    EXPECT_FALSE(reaches({0.49, 0.4, 3, 1}, wanted));
    EXPECT_FALSE(reaches({0.5, 0.39, 3, 1}, wanted));
    EXPECT_FALSE(reaches({0.5, 0.4, 4, 1}, wanted));
    EXPECT_FALSE(reaches({0.5, 0.4, 3, 2}, wanted));
}

TEST(BufferRing, ThatStaysMovesNothing) {
    const Ringed ringed(pulled(), middle(), 2);
    const BufferRing ring = ringed.ring(true);
    EXPECT_TRUE(ring.stays());
    EXPECT_EQ(ring.faces(), ringed.buffer);
    EXPECT_EQ(ring.shape().scaled_jacobian, 1); // whatever it is like
    EXPECT_EQ(ring.shape().poor, 0);
    const CavityEmbedding improved =
        ring.improve(ringed.cavity->old, ringed.cavity->embed({ringed.cavity->old, {}}), {});
    EXPECT_TRUE(ring.moved(ringed.cavity->old, improved).vertices.empty());
    for (std::size_t i = 0; i < ringed.cavity->window.loop.size(); ++i)
        EXPECT_EQ(improved.flat[i], ringed.cavity->flat(ringed.cavity->window.loop)[i]);
}

TEST(BufferRing, TellsTheShapeOfItsFaces) {
    mesh::QuadMesh mesh = grid(10, 10);
    mesh.set_point(4 * 11 + 4, OpenMesh::Vec3d(4.8, 4.8, 0));
    const Ringed ringed(std::move(mesh), middle(), 2);
    const ShapeBounds shape = ringed.ring(false).shape();
    double least = 1;
    const std::vector<double> each = ringed.reference.scaled_jacobians(ringed.mesh);
    for (const int f : ringed.buffer)
        least = std::min(least, each[at(f)]);
    EXPECT_NEAR(shape.scaled_jacobian, least, 1e-12);
    EXPECT_LT(least, 0.9);
    EXPECT_EQ(shape.poor, 3); // those around it
    EXPECT_EQ(shape.inverted, 0);
}

TEST(BufferRing, MovesWhatHasNoFacesElsewhere) {
    Ringed ringed(pulled(), middle(), 2);
    const BufferRing ring = ringed.ring(false);
    const fill::Filling &old = ringed.cavity->old;
    const CavityEmbedding improved = ring.improve(old, ringed.cavity->embed({old, {}}), {});
    const Moved moved = ring.moved(old, improved);
    EXPECT_EQ(vertices_of(moved), ringed.free());
    EXPECT_EQ(moved.vertices.size(), 12u + 20u); // the loop, and a ring around it
    EXPECT_TRUE(moved.surface_triangles.empty());
    // Put into the mesh they are as they were judged.
    mesh::QuadMesh after = ringed.mesh;
    for (const auto &[v, point] : moved.vertices)
        after.set_point(v, point);
    after.replace_disk(ringed.cavity->window.faces, ringed.cavity->window.loop, old.quads,
                       std::vector<OpenMesh::Vec3d>{
                           ringed.cavity->lift(improved.flat[12]), ringed.cavity->lift(improved.flat[13]),
                           ringed.cavity->lift(improved.flat[14]), ringed.cavity->lift(improved.flat[15])});
    EXPECT_NO_THROW(after.check());
    const std::vector<double> each = ringed.reference.scaled_jacobians(after);
    EXPECT_NEAR(*std::min_element(each.begin(), each.end()), improved.min_scaled_jacobian, 1e-12);
    EXPECT_GT(improved.min_scaled_jacobian, 0.9);
}

TEST(BufferRing, KeepsWhatIsFlaggedAndTheBorderOfTheMesh) {
    mesh::QuadMesh mesh = pulled();
    mesh.vertex_flags[4 * 11 + 4] = mesh::fixed;
    const Ringed inside(std::move(mesh), middle(), 2);
    const fill::Filling &old = inside.cavity->old;
    const std::set<int> moved = vertices_of(
        inside.ring(false).moved(old, inside.ring(false).improve(old, inside.cavity->embed({old, {}}), {})));
    EXPECT_EQ(moved.size(), 31u);
    EXPECT_FALSE(moved.contains(4 * 11 + 4));

    const Ringed corner(grid(10, 10), block(10, 0, 0, 3, 3), 2);
    const BufferRing ring = corner.ring(false);
    const CavityEmbedding embedding =
        ring.improve(corner.cavity->old, corner.cavity->embed({corner.cavity->old, {}}), {});
    EXPECT_EQ(vertices_of(ring.moved(corner.cavity->old, embedding)), corner.free());
}

Ringed cap() {
    mesh::QuadMesh sphere = mesh::sphere(10);
    const std::vector<char> none(at(sphere.n_faces()), 0);
    std::vector<int> faces = patch::ball(sphere, {0.4, 0.3, 0.8}, 0.4, none);
    return {std::move(sphere), std::move(faces), 2};
}

TEST(BufferRing, MovesOverTheSurface) {
    const Ringed ringed = cap();
    const BufferRing ring = ringed.ring(false);
    const fill::Filling &old = ringed.cavity->old;
    const CavityEmbedding improved = ring.improve(old, ringed.cavity->embed({old, {}}), {});
    const Moved moved = ring.moved(old, improved);
    EXPECT_EQ(vertices_of(moved), ringed.free());
    ASSERT_EQ(moved.surface_triangles.size(), moved.vertices.size());
    for (const auto &[v, p] : moved.vertices)
        EXPECT_LT(ringed.reference.surface->nearest({p[0], p[1], p[2]}).distance, 1e-12);
    // The loop is where the mesh has it, whether as part of the filling or of the buffer.
    for (std::size_t i = 0; i < ringed.cavity->window.loop.size(); ++i)
        EXPECT_EQ(moved.vertices[i].first, ringed.cavity->window.loop[i]);
}

TEST(BufferRing, QuadsAreThoseOfTheFillingThenItsOwn) {
    const Ringed ringed = cap();
    const BufferRing ring = ringed.ring(false);
    const fill::Filling &old = ringed.cavity->old;
    const CavityEmbedding there = ringed.cavity->start({old, {}});
    for (const CavityEmbedding &embedding : {there, ring.improve(old, there, {})}) {
        const std::vector<geometry::Quad> quads = ring.quads(old, embedding);
        ASSERT_EQ(quads.size(), old.quads.size() + ringed.buffer.size());
        EXPECT_EQ(quads[0][1], embedding.on_surface.points[at(old.quads[0][1])]);
    }
    // With the buffer where it is.
    const std::vector<geometry::Quad> quads = ring.quads(old, there);
    for (std::size_t q = 0; q < ringed.buffer.size(); ++q)
        for (std::size_t k = 0; k < 4; ++k)
            EXPECT_EQ(quads[old.quads.size() + q][k], reference::quad_of(ringed.mesh, ringed.buffer[q])[k]);
    // In a plane nothing outside the filling is asked for.
    const Ringed flat(grid(10, 10), middle(), 2);
    EXPECT_EQ(flat.ring(false).quads(flat.cavity->old, flat.cavity->embed({flat.cavity->old, {}})).size(),
              9u);
}

// A roof with its ridge a feature, along the side of the window.
TEST(BufferRing, CountsWhatIsInvertedAcrossFeatures) {
    mesh::QuadMesh roof = mesh::grid(8, 6, [](double s, double t) {
        return Eigen::Vector3d(8 * s, 6 * t, 4 - std::abs(8 * s - 4) + 0.05 * std::sin(6 * t));
    });
    for (int j = 0; j < 6; ++j)
        roof.edge_flags[at(roof.find_edge(9 * j + 4, 9 * j + 13))] = mesh::feature;
    const Ringed ringed(std::move(roof), block(8, 4, 2, 6, 4), 1);
    ASSERT_TRUE(ringed.mesh.curves);
    const BufferRing ring = ringed.ring(false);
    fill::Filling filling = ringed.cavity->old;
    std::vector<int> vertices = ringed.cavity->window.loop;
    vertices.insert(vertices.end(), ringed.cavity->window.interior.begin(),
                    ringed.cavity->window.interior.end());
    const geometry::SurfacePositions positions = ringed.cavity->on_surface(vertices);
    EXPECT_EQ(ring.inverted(filling, positions), 0);
    std::swap(filling.quads[0][1], filling.quads[0][3]);
    EXPECT_EQ(ring.inverted(filling, positions), 1);
}

} // namespace
} // namespace alphamst::refill
