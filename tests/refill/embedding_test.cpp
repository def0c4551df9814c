// Cavities that give their fillings the sizes that are wanted.
#include <gtest/gtest.h>

#include <utility>

#include "adapt/meshes.h"
#include "index.h"
#include "mesh/curved.h"
#include "refill/cavity.h"

namespace alphamst::refill {
namespace {

using adapt::samples::block;
using adapt::samples::grid;

struct Sized {
    mesh::QuadMesh mesh;
    Patch patch;
    Goal goal;
    Settings settings;
    reference::Reference reference;

    Sized(mesh::QuadMesh of, std::vector<int> faces, double alpha) : mesh(std::move(of)) {
        patch.faces = std::move(faces);
        goal.faces = std::llround(alpha * static_cast<double>(patch.faces.size()));
        goal.sizes = true;
        reference = reference::reference_of(mesh, std::vector{patch});
    }
    Cavity cavity() const { return {mesh, patch, goal, settings, reference}; }
};

Sized round(double alpha) {
    const mesh::QuadMesh mesh = adapt::samples::unstructured(14, 4);
    std::vector<int> faces;
    for (int f = 0; f < mesh.n_faces(); ++f)
        if ((adapt::samples::centre(mesh, f) - OpenMesh::Vec3d(7, 7, 0)).norm() < 4.5)
            faces.push_back(f);
    return {mesh, patch::repair(mesh, faces, std::vector<char>(at(mesh.n_faces()), 0)), alpha};
}

TEST(Embedding, HasTheSizesThatArePredictedOrBetter) {
    const Sized of = round(2);
    const Cavity cavity = of.cavity();
    int laid = 0;
    for (const Cavity::Candidate &candidate : cavity.generators().at(0)()) {
        const PlacedFilling shape = candidate.build();
        const CavityEmbedding embedding = cavity.embed(shape);
        if (!embedding.valid)
            continue;
        ++laid;
        const double error = cavity.size_error(shape.filling, embedding).rms;
        EXPECT_LT(error, cavity.predicted_size_error(shape) + 0.1);
        // What goes without sizes is farther from them.
        EXPECT_LT(error, cavity.size_error(shape.filling, cavity.embed(shape, 0.01)).rms);
        EXPECT_LE(embedding.min_scaled_jacobian, cavity.most_quality(shape.filling) + 1e-9);
    }
    EXPECT_GT(laid, 0);
}

TEST(Embedding, OfWhatIsThereHasItsSizes) {
    const Sized of(grid(8, 8), block(8, 1, 1, 7, 7), 1);
    const Cavity cavity = of.cavity();
    EXPECT_NEAR(cavity.old_size_error().rms, 0, 1e-6);
    EXPECT_NEAR(cavity.predicted_size_error({cavity.old, {}}), 0, 1e-6);
    EXPECT_NEAR(cavity.most_quality(cavity.old), 1, 1e-9);
}

TEST(Embedding, MostQualityIsThatOfAnglesSharedEvenly) {
    const Sized of(grid(8, 8), block(8, 1, 1, 3, 3), 1);
    const Cavity cavity = of.cavity();
    fill::Filling filling = cavity.old; // 2 x 2 faces: eight vertices around one
    ASSERT_EQ(filling.boundary, 8);
    // One quad of four corners and the flat vertices between them: no filling, but each vertex has its face.
    filling.quads = {{0, 2, 4, 6}, {1, 3, 5, 7}};
    EXPECT_NEAR(cavity.most_quality(filling), -1, 1e-9); // 180 degrees for one face
}

TEST(Embedding, OnASurfaceHasTheWantedAreas) {
    mesh::QuadMesh sphere = mesh::sphere(8);
    const std::vector<int> faces =
        patch::ball(sphere, {0, 0, 1}, 0.9, std::vector<char>(at(sphere.n_faces()), 0));
    Sized of(std::move(sphere), faces, 2);
    of.reference = reference::reference_of(of.mesh);
    const Cavity cavity = of.cavity();
    ASSERT_TRUE(cavity.curved());
    const PlacedFilling shape = cavity.generators().at(0)().at(0).build();
    const CavityEmbedding embedding = cavity.embed(shape);
    ASSERT_TRUE(embedding.valid);
    EXPECT_LT(cavity.size_error(shape.filling, embedding).rms, 0.8);
    const std::vector<double> areas = cavity.areas(shape.filling, embedding.on_surface);
    double sum = 0;
    for (const double area : areas)
        sum += area;
    EXPECT_NEAR(sum, geometry::total_area(shape.filling.quads, embedding.on_surface), 1e-9);
}

} // namespace
} // namespace alphamst::refill
