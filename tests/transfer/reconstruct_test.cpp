#include "transfer/reconstruct.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>

#include "adapt/meshes.h"
#include "adapt/run.h"
#include "reference/locate.h"
#include "transfer/carry.h"

namespace alphamst::transfer {
namespace {

using mesh::QuadMesh;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// The mean over a quad, of each of its two triangles by seven points (Radon 1948; exact for degree 5).
template <class Function> double mean(const geometry::Quad &quad, const Function &f) {
    const double a = (6 - std::sqrt(15)) / 21, b = (6 + std::sqrt(15)) / 21, of_a = (155 - std::sqrt(15)) / 1200,
                 of_b = (155 + std::sqrt(15)) / 1200;
    double sum = 0, area = 0;
    for (const std::array<std::size_t, 3> &corners : {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 3}}) {
        const Eigen::Vector3d &p = quad[corners[0]], &q = quad[corners[1]], &r = quad[corners[2]];
        const double size = (q - p).cross(r - p)[2] / 2;
        double value = 9.0 / 40 * f((p + q + r) / 3);
        for (const auto &[place, weight] : {std::pair(a, of_a), std::pair(b, of_b)})
            for (const auto &[u, v] : {std::pair(place, place), std::pair(1 - 2 * place, place),
                                       std::pair(place, 1 - 2 * place)})
                value += weight * f(Eigen::Vector3d(p + u * (q - p) + v * (r - p)));
        sum += size * value;
        area += size;
    }
    return sum / area;
}

template <class Function> std::vector<double> means(const QuadMesh &mesh, const Function &f) {
    std::vector<double> values;
    for (int face = 0; face < mesh.n_faces(); ++face)
        values.push_back(mean(reference::quad_of(mesh, face), f));
    return values;
}

TEST(Reconstruct, AGaussianSurvivesSixRemaps) {
    QuadMesh mesh = adapt::samples::unstructured(55, 3);
    const double W = atof(getenv("W"));
    const auto bell = [&](const Eigen::Vector3d &p) {
        return std::exp(-((p - Eigen::Vector3d(25, 29, 0)).squaredNorm()) / (2 * W * W));
    };
    for (const auto &[name, carry] : {std::pair("linear", mesh::Carry::conserve), std::pair("constant", mesh::Carry::average)})
        mesh.fields.set(std::make_shared<const mesh::Field>(
            mesh::Field{Entity::face, name, 1, carry, means(mesh, bell)}));
    std::mt19937 random(5);
    for (unsigned seed = 1; seed <= 6; ++seed) {
        QuadMesh moved = mesh;
        moved.reset_origins();
        moved.begun = std::make_shared<const QuadMesh>(mesh);
        if (getenv("TURN")) adapt::samples::turn_edges(moved, adapt::samples::all_faces(moved), 100, random);
        adapt::samples::relax(moved, 2);
        for (int v = 0; v < mesh.n_vertices(); ++v)
            if (!moved.on_boundary(v))
                moved.set_point(v, moved.point(v) + OpenMesh::Vec3d(0.4 * adapt::samples::chance(random) - 0.2,
                                                              0.4 * adapt::samples::chance(random) - 0.2, 0));
        transfer::carry(mesh, moved, adapt::samples::silent);
        mesh = std::move(moved);
        Settings settings;
        settings.seed = seed;
        QuadMesh after = mesh;
        after.reset_origins();
        after.begun = std::make_shared<const QuadMesh>(mesh);
        adapt::adapt_whole(after, 1, settings, adapt::samples::silent);
        transfer::carry(mesh, after, adapt::samples::silent);
        int kept = 0;
        for (const int o : after.face_origin) kept += o >= 0;
        mesh = std::move(after);
        std::cout << seed << " faces " << mesh.n_faces() << " kept " << kept;
    const std::vector<double> exact = means(mesh, bell);
    for (const char *name : {"linear", "constant"}) {
        double error = 0, sum = 0;
        for (int f = 0; f < mesh.n_faces(); ++f) {
            const double area = geometry::area_vector(reference::quad_of(mesh, f)).norm();
            error += area * std::abs((*mesh.field(Entity::face, name))[at(f)] - exact[at(f)]);
            sum += area * exact[at(f)];
        }
        std::cout << " " << name << " " << error / sum;
    }
        std::cout << "\n";
    }
}

} // namespace
} // namespace alphamst::transfer
