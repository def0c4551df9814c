#include "reference/size_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "adapt/meshes.h"
#include "mesh/curved.h"

namespace alphamst::reference {
namespace {

constexpr double tight = 1e-9;

geometry::Quad rectangle(double width, double height) {
    return {Eigen::Vector3d(0, 0, 1), {width, 0, 1}, {width, height, 1}, {0, height, 1}};
}

TEST(SizeError, IsInPowersOfTwo) {
    const std::vector<geometry::Quad> quads{rectangle(1, 0.5), rectangle(1, 2), rectangle(2, 2),
                                            rectangle(1, 1)};
    const std::vector<double> log_wanted{0, 0, std::log(4), 0};
    const SizeError error = size_error(quads, log_wanted);
    EXPECT_NEAR(error.rms, std::sqrt(0.5), tight);
    EXPECT_NEAR(error.least, -1, tight);
    EXPECT_NEAR(error.shortest_edge, 0.5, tight);
    ASSERT_EQ(error.each.size(), 4u);
    for (std::size_t q = 0; q < 4; ++q)
        EXPECT_NEAR(error.each[q], (std::array{-1, 1, 0, 0}[q]), tight);
}

TEST(SizeError, OfEdgesIsByTheAreaThatIsWantedThere) {
    const std::vector<geometry::Quad> quads{rectangle(0.5, 2), rectangle(1, 1)};
    const std::vector<double> log_wanted{0, std::log(16)};
    EXPECT_NEAR(size_error(quads, log_wanted).shortest_edge, 0.25, tight); // of the larger one
}

TEST(SizeError, OfAFaceThatIsAPointIsANumber) {
    const std::vector<geometry::Quad> quads{rectangle(0, 0)};
    const SizeError error = size_error(quads, std::vector<double>{0});
    EXPECT_TRUE(std::isfinite(error.rms) && std::isfinite(error.least));
    EXPECT_EQ(error.shortest_edge, 0);
}

TEST(SizeError, IsToldToOutcomes) {
    Outcome outcome;
    tell_sizes_before({0.5, -2, 0.25, {1}}, outcome);
    EXPECT_EQ(outcome.size_errors, std::vector<double>{1});
    EXPECT_EQ(outcome.size_error_after, 0.5);
    EXPECT_EQ(outcome.least_area_after, 0.25);
    EXPECT_EQ(outcome.shortest_edge_after, 0.25);
    tell_sizes_after({1, -1, 0.5, {2, 3}}, outcome);
    EXPECT_EQ(outcome.size_errors, (std::vector<double>{2, 3}));
    EXPECT_EQ(outcome.size_error_before, 0.5);
    EXPECT_EQ(outcome.least_area_before, 0.25);
    EXPECT_EQ(outcome.shortest_edge_before, 0.25);
    EXPECT_EQ(outcome.size_error_after, 1);
    EXPECT_EQ(outcome.least_area_after, 0.5);
    EXPECT_EQ(outcome.shortest_edge_after, 0.5);
}

TEST(WholeSizes, InAPlaneAreThosePresentOverAFactor) {
    for (const int dim : {2, 3})
        for (const double alpha : {0.5, 1.0, 4.0}) {
            mesh::QuadMesh mesh = adapt::samples::grid(8, 6, dim);
            WholeSizes sizes(mesh, reference_of(mesh), std::llround(48 * alpha));
            const SizeError error = sizes.error(mesh);
            EXPECT_NEAR(error.rms, std::abs(std::log2(alpha)), tight);
            EXPECT_NEAR(error.least, std::log2(alpha), tight);
            EXPECT_NEAR(error.shortest_edge, std::sqrt(alpha), tight);
        }
}

// Of another mesh of the same place, when the first is gone.
TEST(WholeSizes, JudgeWhatTheMeshBecame) {
    std::unique_ptr<WholeSizes> sizes;
    {
        mesh::QuadMesh mesh = mesh::grid(
            12, 12, [](double s, double t) { return Eigen::Vector3d(12 * s, 12 * t, 0); }, false, false, 2);
        sizes = std::make_unique<WholeSizes>(mesh, reference_of(mesh), 576);
    }
    const mesh::QuadMesh finer = mesh::grid(
        24, 24, [](double s, double t) { return Eigen::Vector3d(12 * s, 12 * t, 0); }, false, false, 2);
    const SizeError error = sizes->error(finer);
    EXPECT_NEAR(error.rms, 0, tight);
    EXPECT_NEAR(error.shortest_edge, 1, tight);
}

TEST(WholeSizes, AreThoseOfTheFieldSizeWhereThereIsOne) {
    // Columns of widths 1 and 2, where all are wanted alike.
    mesh::QuadMesh mesh = mesh::grid(
        20, 10, [](double s, double t) { return Eigen::Vector3d(s < 0.5 ? 20 * s : 40 * s - 10, 10 * t, 0); },
        false, false, 2);
    mesh::Field field{Entity::vertex, "size", 1, mesh::Carry::linear, {}};
    for (int v = 0; v < mesh.n_vertices(); ++v)
        field.values.push_back(3);
    mesh.fields.set(std::make_shared<const mesh::Field>(std::move(field)));
    WholeSizes sizes(mesh, reference_of(mesh), 300); // of area 1
    const SizeError error = sizes.error(mesh);
    EXPECT_NEAR(error.rms, std::sqrt(0.5), tight);
    EXPECT_NEAR(error.least, 0, tight);
    EXPECT_NEAR(error.shortest_edge, 1, tight);
}

// Were all areas to be the same.
double size_error_of_spheres(const mesh::QuadMesh &sphere) {
    std::vector<geometry::Quad> quads;
    double area = 0;
    for (int f = 0; f < sphere.n_faces(); ++f) {
        quads.push_back(quad_of(sphere, f));
        area += geometry::area_vector(quads.back()).norm();
    }
    const double mean = area / static_cast<double>(quads.size());
    return size_error(quads, std::vector<double>(quads.size(), std::log(mean))).rms;
}

TEST(WholeSizes, OfASphereAreEven) {
    mesh::QuadMesh sphere = mesh::sphere(16);
    WholeSizes sizes(sphere, reference_of(sphere), 4 * sphere.n_faces());
    const SizeError error = sizes.error(sphere);
    std::vector<double> areas;
    double sum = 0;
    for (int f = 0; f < sphere.n_faces(); ++f) {
        areas.push_back(geometry::area_vector(quad_of(sphere, f)).norm());
        sum += areas.back();
    }
    const double least = *std::min_element(areas.begin(), areas.end());
    const double wanted = sum / (4.0 * static_cast<double>(areas.size()));
    EXPECT_NEAR(error.least, std::log2(least / wanted), 0.3);
    EXPECT_NEAR(error.rms, 2, 0.3);
    const mesh::QuadMesh finer = mesh::sphere(32); // of which the surface is not made
    EXPECT_NEAR(sizes.error(finer).rms, size_error_of_spheres(finer), 0.1);
}

} // namespace
} // namespace alphamst::reference
