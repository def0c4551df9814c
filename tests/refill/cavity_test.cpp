#include "refill/cavity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "adapt/meshes.h"
#include "index.h"
#include "mesh/curved.h"
#include "reference/locate.h"
#include "reference/statistics.h"

namespace alphamst::refill {
namespace {

using adapt::samples::block;
using adapt::samples::grid;

// A patch of a mesh, and all that its cavity needs to be there.
struct Laid {
    mesh::QuadMesh mesh;
    Patch patch;
    Goal goal;
    Settings settings;
    reference::Reference reference;

    Laid(mesh::QuadMesh of, std::vector<int> faces) : mesh(std::move(of)) {
        patch.faces = std::move(faces);
        goal.faces = std::ssize(patch.faces);
        goal.any_count = true;
        reference = reference::reference_of(mesh);
    }
    Cavity cavity() const { return {mesh, patch, goal, settings, reference}; }
};

template <class Call> Refusal refusal_of(Call call) {
    try {
        call();
    } catch (const Refusal &refusal) {
        return refusal;
    }
    return {Fault::cancelled, "nothing was refused"};
}

// A round patch away from the border of a mesh of many singularities.
Laid round() {
    const mesh::QuadMesh mesh = adapt::samples::unstructured(14, 4);
    std::vector<int> faces;
    for (int f = 0; f < mesh.n_faces(); ++f)
        if ((adapt::samples::centre(mesh, f) - OpenMesh::Vec3d(7, 7, 0)).norm() < 4.5)
            faces.push_back(f);
    return {mesh, patch::repair(mesh, faces, std::vector<char>(at(mesh.n_faces()), 0))};
}

fill::Filling first_filling(const Cavity &cavity) {
    return cavity.generators().at(0)().at(0).build().filling;
}

TEST(Cavity, RefusesWhatIsNoDiskAndSaysWhy) {
    std::vector<int> ring = block(6, 1, 1, 4, 4);
    std::erase(ring, 2 * 6 + 2);
    const Refusal refusal = refusal_of([&] { Laid(grid(6, 6), ring).cavity(); });
    EXPECT_EQ(refusal.fault, Fault::patch);
    EXPECT_NE(refusal.text.find("it has a hole"), std::string::npos) << refusal.text;
    EXPECT_EQ(refusal.text.find("not connected"), std::string::npos) << refusal.text;
    const Refusal apart = refusal_of([&] { Laid(grid(6, 6), {0, 20}).cavity(); });
    EXPECT_NE(apart.text.find("not connected"), std::string::npos) << apart.text;
}

TEST(Cavity, RefusesACornerThatIsNotOnTheBoundary) {
    Laid laid(grid(6, 6), block(6, 1, 1, 4, 4));
    laid.patch.corners = {8, 11, 32, 29};
    const Cavity cavity = laid.cavity();
    EXPECT_EQ(std::count(cavity.window.wanted.begin(), cavity.window.wanted.end(), 1), 4);
    laid.patch.corners.back() = 16; // inside
    EXPECT_EQ(refusal_of([&] { laid.cavity(); }).fault, Fault::patch);
}

TEST(Cavity, GivenCornersAreWhatIsWanted) {
    Laid laid(grid(6, 6), block(6, 1, 1, 4, 4));
    laid.patch.corners = {8, 11, 32};
    const Cavity cavity = laid.cavity();
    for (std::size_t i = 0; i < cavity.window.loop.size(); ++i) {
        const bool corner = std::find(laid.patch.corners.begin(), laid.patch.corners.end(),
                                      cavity.window.loop[i]) != laid.patch.corners.end();
        EXPECT_EQ(cavity.window.wanted[i], corner ? 1 : 2);
    }
}

TEST(Cavity, TheOldFillingIsTheMeshThere) {
    const Laid laid = round();
    const Cavity cavity = laid.cavity();
    std::vector<int> vertices = cavity.window.loop;
    vertices.insert(vertices.end(), cavity.window.interior.begin(), cavity.window.interior.end());
    ASSERT_EQ(cavity.old.vertices, std::ssize(vertices));
    ASSERT_EQ(cavity.old.quads.size(), laid.patch.faces.size());
    for (std::size_t q = 0; q < cavity.old.quads.size(); ++q)
        for (std::size_t k = 0; k < 4; ++k)
            EXPECT_EQ(vertices[at(cavity.old.quads[q][k])], laid.mesh.corners(laid.patch.faces[q])[k]);
    std::map<int, std::int64_t> valences;
    int singular = 0;
    for (const int v : vertices) {
        ++valences[laid.mesh.valence(v)];
        singular += laid.mesh.singular(v);
    }
    EXPECT_EQ(cavity.valences(cavity.old), valences);
    EXPECT_EQ(cavity.old_singular_all, singular);
    EXPECT_GT(singular, 3);
    EXPECT_EQ(cavity.old_quality, cavity.old_shape.min_scaled_jacobian);
}

// Around a notch of one face: its missing side is an edge outside.
TEST(Cavity, NoEdgeMayDoubleOneOutside) {
    std::vector<int> faces = block(5, 1, 1, 4, 3);
    std::erase(faces, 2 * 5 + 2);
    const Laid laid(grid(5, 4), faces);
    const Cavity cavity = laid.cavity();
    const auto place = [&](int i, int j) {
        const auto &loop = cavity.window.loop;
        return static_cast<int>(std::find(loop.begin(), loop.end(), j * 6 + i) - loop.begin());
    };
    EXPECT_TRUE(cavity.fits(cavity.old));
    fill::Filling filling = cavity.old;
    filling.quads.push_back({place(2, 2), place(3, 2), place(3, 3), place(2, 3)});
    EXPECT_FALSE(cavity.fits(filling));
    // Across the inside of the patch, where an old edge goes, one may be again.
    filling.quads.back() = {place(2, 1), place(3, 1), place(3, 2), place(2, 2)};
    EXPECT_TRUE(cavity.fits(filling));
}

TEST(Cavity, NumbersAgreeWithTheMeshAfterwards) {
    const Laid laid = round();
    const Cavity cavity = laid.cavity();
    const fill::Filling filling = first_filling(cavity);
    mesh::QuadMesh after = laid.mesh;
    const std::vector<OpenMesh::Vec3d> points = cavity.lift(cavity.embed({filling, {}}));
    ASSERT_EQ(std::ssize(points), filling.vertices - filling.boundary);
    const auto replaced = after.replace_disk(cavity.window.faces, cavity.window.loop, filling.quads, points);
    const patch::Window now = patch::make_window(after, replaced.faces);
    std::map<int, std::int64_t> valences;
    for (const auto *list : {&now.loop, &now.interior})
        for (const int v : *list)
            ++valences[after.valence(v)];
    EXPECT_EQ(cavity.valences(filling), valences);
    EXPECT_LT(cavity.singular_all(filling), cavity.old_singular_all);
    EXPECT_EQ(cavity.singular_all(filling) - cavity.old_singular_all,
              std::ssize(after.singularities()) - std::ssize(laid.mesh.singularities()));
}

TEST(Cavity, SingularOnesOfTheMeshBoundaryCountInSingularAll) {
    const Laid laid(grid(4, 4), block(4, 0, 0, 4, 2)); // on three sides of the mesh
    const Cavity cavity = laid.cavity();
    EXPECT_EQ(cavity.old_singular_all, 0);
    EXPECT_EQ(cavity.valences(cavity.old), (std::map<int, std::int64_t>{{4, 6}}));
    // One face more at a corner of the mesh, one less beside it.
    fill::Filling filling = cavity.old;
    const auto corner = static_cast<int>(std::find(cavity.window.loop.begin(), cavity.window.loop.end(), 0) -
                                         cavity.window.loop.begin());
    for (auto &quad : filling.quads)
        for (int &v : quad)
            if (v == (corner + 1) % filling.boundary) {
                v = corner;
                EXPECT_EQ(cavity.singular_all(filling), 2);
                EXPECT_EQ(cavity.valences(filling), cavity.valences(cavity.old)); // no interior vertex
                return;
            }
}

TEST(Cavity, AFlatLoopStaysBitForBit) {
    const Laid laid = round();
    const Cavity cavity = laid.cavity();
    ASSERT_FALSE(cavity.curved());
    const geometry::Points loop = cavity.flat(cavity.window.loop);
    for (const PlacedFilling &shape :
         {PlacedFilling{first_filling(cavity), {}}, cavity.present().value().build()}) {
        const CavityEmbedding embedding = cavity.embed(shape);
        EXPECT_TRUE(embedding.valid);
        ASSERT_EQ(embedding.flat.size(), at(shape.filling.vertices));
        for (std::size_t i = 0; i < loop.size(); ++i)
            EXPECT_EQ(embedding.flat[i], loop[i]);
        EXPECT_EQ(embedding.min_scaled_jacobian,
                  geometry::shapes_of(shape.filling.quads, embedding.flat).min_scaled_jacobian);
    }
    for (std::size_t i = 0; i < loop.size(); ++i)
        EXPECT_EQ(cavity.lift(loop[i]), laid.mesh.point(cavity.window.loop[i]));
}

TEST(Cavity, ACurvedLoopStaysBitForBitAndNewVerticesAreOnTheSurface) {
    mesh::QuadMesh sphere = mesh::sphere(8);
    const std::vector<int> faces =
        patch::ball(sphere, {0.4, 0.3, 0.8}, 0.8, std::vector<char>(at(sphere.n_faces()), 0));
    Laid laid(std::move(sphere), faces);
    laid.goal.any_count = false;
    laid.goal.faces = std::ssize(faces) + 6;
    const Cavity cavity = laid.cavity();
    ASSERT_TRUE(cavity.curved());
    const fill::Filling filling = first_filling(cavity);
    const CavityEmbedding embedding = cavity.embed({filling, {}});
    EXPECT_TRUE(embedding.valid);
    EXPECT_TRUE(embedding.flat.empty());
    ASSERT_EQ(embedding.on_surface.points.size(), at(filling.vertices));
    const auto &points = embedding.on_surface.points;
    for (std::size_t i = 0; i < cavity.window.loop.size(); ++i)
        EXPECT_EQ(points[i], reference::point_of(laid.mesh, cavity.window.loop[i]));
    for (const Eigen::Vector3d &p : points)
        EXPECT_LT(cavity.surface().nearest(p).distance, 1e-12);
    // In two steps it is the same.
    EXPECT_EQ(cavity.smooth(filling, cavity.start({filling, {}})).on_surface.points, points);
}

TEST(Cavity, AFlatPatchOfACurvedMeshMayLieInItsPlane) {
    mesh::QuadMesh box = mesh::cube(4, [](const Eigen::Vector3d &p) { return p; });
    std::vector<int> faces;
    for (int f = 0; f < box.n_faces(); ++f)
        if (adapt::samples::centre(box, f)[2] > 3.9)
            faces.push_back(f);
    ASSERT_EQ(faces.size(), 16u);
    Laid laid(std::move(box), faces);
    EXPECT_TRUE(laid.cavity().curved());
    laid.reference.planes_first = true;
    EXPECT_FALSE(laid.cavity().curved());
}

TEST(Cavity, ThePresentFillingIsAnAnswerIfItHasTheWantedNumbers) {
    Laid laid = round();
    for (const bool any : {true, false}) {
        laid.goal.any_count = any;
        const Cavity cavity = laid.cavity();
        const auto present = cavity.present();
        ASSERT_TRUE(present);
        EXPECT_EQ(present->faces, std::ssize(laid.patch.faces));
        EXPECT_EQ(present->singularities, cavity.old_singular_all);
        EXPECT_EQ(present->build().filling.quads, cavity.old.quads);
    }
    ++laid.goal.faces;
    EXPECT_FALSE(laid.cavity().present());
    laid.goal.any_count = true;
    EXPECT_TRUE(laid.cavity().present());
    laid.goal.forbid_old = true;
    EXPECT_FALSE(laid.cavity().present());
}

TEST(Cavity, IsRaggedWhereTheBoundaryIsLong) {
    EXPECT_FALSE(Laid(grid(6, 6), block(6, 1, 1, 5, 5)).cavity().ragged());
    EXPECT_TRUE(Laid(grid(18, 3), block(18, 1, 1, 17, 2)).cavity().ragged());
    Laid few(grid(6, 6), block(6, 1, 1, 5, 5));
    few.goal.faces = 4; // 16 * 16 > 52 * 4
    EXPECT_TRUE(few.cavity().ragged());
}

} // namespace
} // namespace alphamst::refill
