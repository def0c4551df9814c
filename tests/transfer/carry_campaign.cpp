// Random operations on random plane meshes whose boundary is straight: linear functions stay what they are,
// means keep their integral and their range. The cases are the same in every run.
#include <array>
#include <cmath>
#include <iostream>

#include "adapt/run.h"
#include "chord/table.h"
#include "chords/edit.h"
#include "patch/grow.h"
#include "reference/locate.h"
#include "reference/projection.h"
#include "transfer/carry.h"
#include "transfer/cell.h"

namespace alphamst::transfer {
namespace {

using adapt::samples::chance;
using adapt::samples::silent;
using mesh::Carry;
using mesh::QuadMesh;

#ifdef ALPHAMST_FULL_CAMPAIGN
constexpr int n_runs = 100;
#else
constexpr int n_runs = 8;
#endif
constexpr int n_operations = 10; // on each mesh

constexpr std::array<double, 6> alphas{0.5, 0.7, 1, 1, 1.5, 3};

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double linear(const OpenMesh::Vec3d &p) { return 3 - 2 * p[0] + 0.5 * p[1]; }

void set(QuadMesh &mesh, Entity entity, const char *name, Carry carry, std::vector<double> values) {
    mesh.fields.set(
        std::make_shared<const mesh::Field>(mesh::Field{entity, name, 1, carry, std::move(values)}));
}

// A sheared unstructured mesh; inside its vertices are where chance puts them.
QuadMesh sample(std::mt19937 &random) {
    QuadMesh mesh =
        adapt::samples::unstructured(7 + static_cast<int>(random() % 7), static_cast<unsigned>(random()));
    const double shear = chance(random), height = 0.5 + chance(random);
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        OpenMesh::Vec3d p = mesh.point(v);
        if (!mesh.on_boundary(v))
            p += OpenMesh::Vec3d(0.3 * chance(random) - 0.15, 0.3 * chance(random) - 0.15, 0);
        mesh.set_point(v, {p[0] + shear * p[1], height * p[1], 0});
        if (mesh.valence(v) == 2) // so that blunt ones stay, too
            mesh.vertex_flags[at(v)] = mesh::corner;
    }
    std::vector<double> at_vertices, at_faces, exact;
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        at_vertices.push_back(random() % 4 == 0 ? 5 : chance(random));
        exact.push_back(linear(mesh.point(v)));
    }
    for (int f = 0; f < mesh.n_faces(); ++f)
        at_faces.push_back(random() % 4 == 0 ? 5 : chance(random));
    set(mesh, Entity::vertex, "linear", Carry::linear, exact);
    set(mesh, Entity::vertex, "conserve", Carry::conserve, at_vertices);
    set(mesh, Entity::vertex, "average", Carry::average, at_vertices);
    set(mesh, Entity::face, "conserve", Carry::conserve, at_faces);
    set(mesh, Entity::face, "average", Carry::average, at_faces);
    return mesh;
}

std::vector<Patch> some_patch(const QuadMesh &mesh, std::mt19937 &random) {
    patch::GrowthPlan plan;
    plan.start = static_cast<int>(random() % static_cast<unsigned>(mesh.n_vertices()));
    plan.most = 8 + static_cast<int>(random() % 40);
    std::vector<Patch> patches(1);
    patches[0].faces = patch::Growth(mesh).disk(plan);
    return patches;
}

void edit_chord(QuadMesh &mesh, std::mt19937 &random, const Settings &settings) {
    const int edge = static_cast<int>(random() % static_cast<unsigned>(mesh.n_edges()));
    const QuadMesh before = mesh;
    try {
        if (random() % 2 == 0)
            chords::collapse_chord(mesh, edge, {}, settings, silent);
        else
            chords::split_chord(mesh, edge, 1, 4000, {true}, settings, silent);
    } catch (const Failure &) { // a chord that may not go
        mesh = before;
    }
}

void change(QuadMesh &mesh, std::mt19937 &random) {
    Settings settings;
    settings.seed = random();
    settings.edit_boundary = random() % 2 == 0;
    const double alpha = mesh.n_faces() > 400 ? 0.5 : alphas[random() % alphas.size()];
    if (settings.edit_boundary)
        reference::keep_boundary(mesh, {}, settings.tolerance);
    std::vector<Patch> patches = some_patch(mesh, random);
    const std::vector<char> none(at(mesh.n_faces()), 0);
    const bool whole = patches[0].faces.empty() || random() % 2 == 0;
    switch (random() % 7) {
    case 0:
        smooth::smooth(mesh, whole ? nullptr : &patches, settings, silent);
        return;
    case 1:
        adapt::clean(mesh, settings, silent);
        return;
    case 2:
        edit_chord(mesh, random, settings);
        return;
    case 3:
        if (whole)
            adapt::reduce_whole(mesh, settings, silent);
        else
            adapt::reduce_singularities(mesh, patches, settings, silent);
        return;
    case 4: {
        const int middle = static_cast<int>(random() % static_cast<unsigned>(mesh.n_vertices()));
        patches[0].faces = patch::repair(mesh, patch::rings(mesh, middle, 2, none), none);
        chords::insert_chords(mesh, patches, 1, settings, silent);
        return;
    }
    default:
        if (whole)
            adapt::adapt_whole(mesh, alpha, settings, silent);
        else
            adapt::adapt(mesh, patches, alpha, settings, silent);
    }
}

void expect_conserved(const QuadMesh &before, const QuadMesh &after, Entity entity, const char *name) {
    const std::vector<double> &old = *before.field(entity, name), &now = *after.field(entity, name);
    const auto integral = [&](const QuadMesh &mesh, const std::vector<double> &values) {
        const Cells cells(mesh, entity);
        double sum = 0;
        for (int i = 0; i < cells.count(); ++i)
            sum += values[at(i)] * cells.area(i);
        return sum;
    };
    EXPECT_NEAR(integral(after, now) / integral(before, old), 1, 1e-12);
    const auto [low, high] = std::ranges::minmax(old);
    const auto [least, largest] = std::ranges::minmax(now);
    EXPECT_GE(least, low);
    EXPECT_LE(largest, high);
}

void expect_carried(const QuadMesh &before, const QuadMesh &after) {
    for (const Entity entity : {Entity::vertex, Entity::face})
        for (const char *name : {"conserve", "average"})
            expect_conserved(before, after, entity, name);
    const std::vector<double> &values = *after.field(Entity::vertex, "linear");
    double most = 0;
    for (int v = 0; v < after.n_vertices(); ++v)
        most = std::max(most, std::abs(values[at(v)] - linear(after.point(v))));
    EXPECT_LT(most, 1e-12);
}

TEST(CarryCampaign, LinearFunctionsStayAndIntegralsAreKept) {
    std::mt19937 random(11);
    int changed = 0;
    for (int run = 0; run < n_runs && !testing::Test::HasFailure(); ++run) {
        QuadMesh mesh = sample(random);
        for (int i = 0; i < n_operations; ++i) {
            SCOPED_TRACE("run " + std::to_string(run) + ", operation " + std::to_string(i));
            QuadMesh after = mesh;
            after.reset_origins();
            after.begun = std::make_shared<const QuadMesh>(mesh);
            change(after, random);
            after.begun.reset();
            carry(mesh, after, silent);
            expect_carried(mesh, after);
            changed += after.checksum() != mesh.checksum();
            mesh = std::move(after);
        }
    }
    std::cout << changed << " of " << n_runs * n_operations << " changed\n";
    EXPECT_GT(changed, n_runs * n_operations / 2);
}

} // namespace
} // namespace alphamst::transfer
