#include "adapt/commit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "index.h"
#include "mesh/curved.h"
#include "meshes.h"
#include "patch/grow.h"
#include "patch/region.h"
#include "reference/locate.h"
#include "refill/window.h"

namespace alphamst::adapt {
namespace {

// A mesh and windows found for it, all in its numbers at the start. They and their buffers are apart.
struct Windows {
    mesh::QuadMesh start, mesh;
    reference::Reference reference;
    std::vector<refill::Place> places;
    std::vector<refill::Replacement> found;

    explicit Windows(mesh::QuadMesh of) : start(std::move(of)), mesh(start) {
        reference = reference::reference_of(mesh);
        if (reference.surface)
            reference.surface_distance =
                reference::surface_distance_of(mesh, *reference.surface, mesh.n_faces(), 0.5);
    }
    // Around a place, with so many faces more.
    void find(const std::array<double, 3> &centre, double radius, int more) {
        const std::vector<char> none(at(mesh.n_faces()), 0);
        refill::Place place;
        place.faces = patch::repair(mesh, patch::ball(mesh, centre, radius, none), none);
        const std::vector<int> all = patch::Growth(mesh).surround(place.faces, 2);
        place.buffer.assign(all.begin() + std::ssize(place.faces), all.end());
        refill::Goal goal;
        goal.faces = std::ssize(place.faces) + more;
        refill::Trace trace;
        auto replacement =
            refill::refill_window(mesh, place, goal, {0.2, 0.05, 100, 0}, {}, reference, trace);
        ASSERT_TRUE(replacement);
        ASSERT_EQ(std::ssize(replacement->filling.quads), goal.faces);
        found.push_back(std::move(*replacement));
        places.push_back(std::move(place));
    }
    void put(Commits &commits) {
        for (std::size_t i = 0; i < found.size(); ++i)
            commits.put(found[i], places[i].buffer);
    }
    bool replaced(int face) const {
        return std::any_of(places.begin(), places.end(),
                           [&](const refill::Place &place) { return patch::contains(place.faces, face); });
    }
};

// By the names that the commits give, all outside the windows is what it was.
void expect_followed(const Windows &windows, const Commits &commits) {
    const mesh::QuadMesh &start = windows.start, &mesh = windows.mesh;
    std::vector<char> seen(at(mesh.n_faces()), 0);
    for (int f = 0; f < start.n_faces(); ++f) {
        const int now = commits.faces.now(f);
        if (windows.replaced(f)) {
            EXPECT_EQ(now, -1);
            continue;
        }
        ASSERT_GE(now, 0);
        ASSERT_LT(now, mesh.n_faces());
        EXPECT_FALSE(std::exchange(seen[at(now)], 1));
        std::array<int, 4> corners = start.corners(f);
        for (int &v : corners)
            v = commits.vertices.now(v);
        EXPECT_EQ(mesh.corners(now), corners);
        EXPECT_EQ(mesh.face_origin[at(now)], f);
    }
    std::size_t added = 0;
    for (const refill::Replacement &found : windows.found)
        added += found.filling.quads.size();
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 0), static_cast<std::ptrdiff_t>(added));
}

TEST(Commits, FollowTheNumbersWhileManyArePut) {
    for (const std::array<int, 3> &more : {std::array{-8, -8, -8}, {-8, 6, -4}, {9, -12, 0}}) {
        Windows windows(samples::unstructured(24, 3));
        windows.find({5, 5, 0}, 3.2, more[0]);
        windows.find({18, 18, 0}, 3.2, more[1]);
        windows.find({5, 18, 0}, 3.2, more[2]);
        Commits commits(windows.mesh, windows.reference);
        windows.put(commits);
        EXPECT_NO_THROW(windows.mesh.check());
        EXPECT_EQ(windows.mesh.n_faces(), windows.start.n_faces() + more[0] + more[1] + more[2]);
        int change = 0;
        for (const refill::Replacement &found : windows.found)
            change += found.singular_change;
        EXPECT_EQ(std::ssize(windows.mesh.singularities()),
                  std::ssize(windows.start.singularities()) + change);
        expect_followed(windows, commits);
    }
}

TEST(Commits, TurnTheNumbersOfAReplacementIntoThoseOfTheMeshBefore) {
    Windows windows(samples::unstructured(24, 3));
    windows.find({5, 5, 0}, 3.2, -8);
    windows.find({19, 20.8, 0}, 3.4, -8); // with the last faces of the mesh
    Commits commits(windows.mesh, windows.reference);
    const refill::Replacement first = windows.found[0], second = windows.found[1];
    commits.put(windows.found[0], windows.places[0].buffer);
    EXPECT_EQ(windows.found[0].window.faces, first.window.faces);
    std::vector<int> faces = second.window.faces, loop = second.window.loop;
    for (int &f : faces)
        f = commits.faces.now(f);
    for (int &v : loop)
        v = commits.vertices.now(v);
    EXPECT_NE(faces, second.window.faces); // the last faces have moved into gaps
    const std::vector<OpenMesh::Vec3d> points = second.points;
    const auto replaced = commits.put(windows.found[1], windows.places[1].buffer);
    EXPECT_EQ(windows.found[1].window.faces, faces);
    EXPECT_EQ(windows.found[1].window.loop, loop);
    ASSERT_EQ(replaced.faces.size(), second.filling.quads.size());
    // A new face, seen from its quad; those of the loop have names of the start.
    for (std::size_t q = 0; q < replaced.faces.size(); ++q) {
        const auto moved = std::find_if(replaced.moved_faces.begin(), replaced.moved_faces.end(),
                                        [&](const auto &move) { return move[0] == replaced.faces[q]; });
        ASSERT_EQ(moved, replaced.moved_faces.end());
        const std::array<int, 4> corners = windows.mesh.corners(replaced.faces[q]);
        for (std::size_t k = 0; k < 4; ++k)
            if (const int v = second.filling.quads[q][k]; v < second.filling.boundary) {
                EXPECT_EQ(corners[k], commits.vertices.now(second.window.loop[at(v)]));
            } else {
                EXPECT_EQ(windows.mesh.point(corners[k]), points[at(v - second.filling.boundary)]);
            }
    }
}

TEST(Commits, MoveTheVerticesOfTheBuffer) {
    mesh::QuadMesh pulled = samples::grid(12, 12);
    pulled.set_point(4 * 13 + 4, OpenMesh::Vec3d(4.4, 4.3, 0));
    Windows windows(std::move(pulled));
    refill::Place place;
    place.faces = samples::block(12, 4, 4, 7, 7);
    const std::vector<int> all = patch::Growth(windows.mesh).surround(place.faces, 2);
    place.buffer.assign(all.begin() + 9, all.end());
    refill::Goal goal;
    goal.faces = 9;
    refill::Trace trace;
    goal.any_count = true;
    goal.forbid_old = true;
    auto found =
        refill::refill_window(windows.mesh, place, goal, {0.95, 0.5, 3, 0}, {}, windows.reference, trace);
    ASSERT_TRUE(found);
    ASSERT_FALSE(found->moved.vertices.empty());
    Commits commits(windows.mesh, windows.reference);
    commits.put(*found, place.buffer);
    for (const auto &[v, point] : found->moved.vertices)
        EXPECT_EQ(windows.mesh.point(commits.vertices.now(v)), point);
    EXPECT_NO_THROW(windows.mesh.check());
}

// Every sample has one owner, as far off as the distance says; every vertex has its triangle.
void expect_on_surface(const Windows &windows) {
    const mesh::QuadMesh &mesh = windows.mesh;
    const auto &triangles = windows.reference.surface_triangles;
    ASSERT_EQ(std::ssize(triangles), mesh.n_vertices());
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        const Eigen::Vector3d p = reference::point_of(mesh, v);
        EXPECT_LT(windows.reference.surface->follow(p, triangles[at(v)]).distance, 1e-9);
        EXPECT_LT((windows.reference.surface->follow(p, triangles[at(v)]).point - p).norm(), 1e-9);
    }
    const reference::SurfaceDistance &distance = *windows.reference.surface_distance;
    ASSERT_EQ(distance.faces(), mesh.n_faces());
    std::vector<int> samples;
    for (int f = 0; f < mesh.n_faces(); ++f) {
        const geometry::Quad quad = reference::quad_of(mesh, f);
        const double extent = std::max((quad[0] - quad[2]).norm(), (quad[1] - quad[3]).norm());
        for (const int sample : distance.samples(f)) {
            samples.push_back(sample);
            const Eigen::Vector3d middle = (quad[0] + quad[1] + quad[2] + quad[3]) / 4;
            EXPECT_LT((distance.point(sample) - middle).norm(), extent + distance.allowed(sample));
        }
    }
    std::sort(samples.begin(), samples.end());
    std::vector<int> all(samples.size());
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(samples, all);
    EXPECT_TRUE(distance.complete());
}

TEST(Commits, TakeTheSurfaceAlong) {
    for (const std::array<int, 2> &more : {std::array{-5, -5}, {6, 6}, {-6, 4}}) {
        Windows windows(mesh::sphere(10));
        expect_on_surface(windows);
        windows.find({0, 0.1, 1}, 0.6, more[0]);
        windows.find({0, 0.1, -1}, 0.6, more[1]);
        Commits commits(windows.mesh, windows.reference);
        windows.put(commits);
        EXPECT_NO_THROW(windows.mesh.check());
        EXPECT_EQ(windows.mesh.n_faces(), 600 + more[0] + more[1]);
        expect_on_surface(windows);
        expect_followed(windows, commits);
    }
}

// A filling in a plane of its own knows no triangles; they are looked up.
TEST(Commits, FindTheSurfaceUnderAFlatFilling) {
    Windows windows(mesh::cube(6, [](const Eigen::Vector3d &p) { return p; }));
    windows.reference.planes_first = true;
    windows.find({3, 3, 6}, 2.4, 6);
    ASSERT_TRUE(windows.found[0].surface_triangles.empty());
    Commits commits(windows.mesh, windows.reference);
    windows.put(commits);
    expect_on_surface(windows);
}

} // namespace
} // namespace alphamst::adapt
