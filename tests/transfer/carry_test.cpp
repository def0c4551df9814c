#include "transfer/carry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "adapt/meshes.h"
#include "adapt/run.h"
#include "reference/locate.h"

namespace alphamst::transfer {
namespace {

using adapt::samples::silent;
using mesh::Carry;
using mesh::Field;
using mesh::QuadMesh;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

void set(QuadMesh &mesh, Entity entity, const char *name, Carry carry, std::vector<double> values,
         int components = 1) {
    mesh.fields.set(std::make_shared<const Field>(Field{entity, name, components, carry, std::move(values)}));
}

const std::vector<double> &get(const QuadMesh &mesh, Entity entity, const char *name) {
    return *mesh.field(entity, name);
}

// One value from the coordinates of each vertex.
std::vector<double> of_vertices(const QuadMesh &mesh,
                                const std::function<double(const OpenMesh::Vec3d &)> &f) {
    std::vector<double> values;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        values.push_back(f(mesh.point(v)));
    return values;
}

std::vector<double> random_values(int n, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<double> values(at(n));
    for (double &value : values)
        value = 2 * adapt::samples::chance(random) - 1;
    return values;
}

double area(const QuadMesh &mesh, int face) {
    return quality::measure(quality::Metric::area, reference::quad_of(mesh, face), 0);
}

double integral(const QuadMesh &mesh, const std::vector<double> &values, bool absolute = false) {
    double sum = 0;
    for (int f = 0; f < mesh.n_faces(); ++f)
        sum += (absolute ? std::abs(values[at(f)]) : values[at(f)]) * area(mesh, f);
    return sum;
}

// What adapt makes of some patches of the mesh; its fields have been carried.
QuadMesh adapted(const QuadMesh &before, const std::vector<std::vector<int>> &patches, double alpha) {
    QuadMesh after = before;
    after.reset_origins();
    std::vector<Patch> regions;
    for (const std::vector<int> &faces : patches)
        regions.push_back({faces, {}, 0});
    for (const Outcome &outcome : adapt::adapt(after, regions, alpha, {}, silent))
        EXPECT_FALSE(outcome.fault) << outcome.text;
    carry(before, after, silent);
    return after;
}

QuadMesh smoothed(const QuadMesh &before) {
    QuadMesh after = before;
    after.reset_origins();
    EXPECT_FALSE(smooth::smooth(after, nullptr, {}, silent).at(0).fault);
    carry(before, after, silent);
    return after;
}

class CarryByAlpha : public testing::TestWithParam<double> {
protected:
    CarryByAlpha() {
        const std::vector<char> none(at(mesh.n_faces()), 0);
        for (const int v : {5 * 25 + 6, 16 * 25 + 15})
            patches.push_back(patch::repair(mesh, patch::rings(mesh, v, 4, none), none));
    }
    QuadMesh mesh = adapt::samples::unstructured(24, 7);
    std::vector<std::vector<int>> patches;
};

TEST_P(CarryByAlpha, KeptEntitiesKeepTheirValues) {
    set(mesh, Entity::vertex, "v", Carry::linear, random_values(3 * mesh.n_vertices(), 1), 3);
    set(mesh, Entity::edge, "e", Carry::inherit, random_values(2 * mesh.n_edges(), 2), 2);
    set(mesh, Entity::face, "f", Carry::conserve, random_values(mesh.n_faces(), 3));
    const QuadMesh after = adapted(mesh, patches, GetParam());
    const auto expect = [&](Entity entity, const char *name, std::size_t width,
                            const std::vector<std::int32_t> &origin) {
        const std::vector<double> &old = get(mesh, entity, name), &now = get(after, entity, name);
        ASSERT_EQ(now.size(), width * origin.size());
        int kept = 0;
        for (std::size_t i = 0; i < origin.size(); ++i)
            for (std::size_t c = 0; origin[i] >= 0 && c < width; ++c, ++kept)
                EXPECT_EQ(now[i * width + c], old[at(origin[i]) * width + c]);
        EXPECT_GT(kept, 0);
        EXPECT_LT(kept, static_cast<int>(now.size()));
    };
    expect(Entity::vertex, "v", 3, after.vertex_origin);
    expect(Entity::edge, "e", 2, after.edge_origin);
    expect(Entity::face, "f", 1, after.face_origin);
}

TEST_P(CarryByAlpha, LinearFunctionsAreReproduced) {
    const auto f = [](const OpenMesh::Vec3d &p) { return 3 - 2 * p[0] + 0.5 * p[1]; };
    const auto g = [](const OpenMesh::Vec3d &p) { return p[0] + 7 * p[1]; };
    std::vector<double> both;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        both.insert(both.end(), {f(mesh.point(v)), g(mesh.point(v))});
    set(mesh, Entity::vertex, "both", Carry::linear, both, 2);
    const QuadMesh after = adapted(mesh, patches, GetParam());
    const std::vector<double> &now = get(after, Entity::vertex, "both");
    for (int v = 0; v < after.n_vertices(); ++v) {
        EXPECT_NEAR(now[2 * at(v)], f(after.point(v)), 1e-12);
        EXPECT_NEAR(now[2 * at(v) + 1], g(after.point(v)), 1e-12);
    }
}

TEST_P(CarryByAlpha, InterpolationStaysInItsRange) {
    std::vector<double> values = random_values(mesh.n_vertices(), 4);
    for (double &value : values)
        value = 1e-9 + std::abs(value);
    set(mesh, Entity::vertex, "size", Carry::linear, values);
    const QuadMesh after = adapted(mesh, patches, GetParam());
    for (const double value : get(after, Entity::vertex, "size"))
        EXPECT_GE(value, 1e-9);
}

TEST_P(CarryByAlpha, IntegralsAreConserved) {
    const std::vector<double> values = random_values(mesh.n_faces(), 5);
    set(mesh, Entity::face, "f", Carry::conserve, values);
    const QuadMesh after = adapted(mesh, patches, GetParam());
    const std::vector<double> &now = get(after, Entity::face, "f");
    EXPECT_NEAR(integral(after, now), integral(mesh, values), 1e-12 * integral(mesh, values, true));
    for (const std::vector<int> &patch : patches) { // each on its own, too
        double before = 0, behind = 0, size = 0;
        Eigen::Vector3d low = Eigen::Vector3d::Constant(HUGE_VAL), high = -low;
        for (const int f : patch) {
            before += values[at(f)] * area(mesh, f);
            size += std::abs(values[at(f)]) * area(mesh, f);
            for (const Eigen::Vector3d &corner : reference::quad_of(mesh, f)) {
                low = low.cwiseMin(corner);
                high = high.cwiseMax(corner);
            }
        }
        for (int f = 0; f < after.n_faces(); ++f) {
            const geometry::Quad quad = reference::quad_of(after, f);
            const Eigen::Vector3d centre = (quad[0] + quad[1] + quad[2] + quad[3]) / 4;
            // A patch that cannot be bettered keeps its faces.
            const int old = after.face_origin[at(f)];
            if ((old < 0 || std::binary_search(patch.begin(), patch.end(), old)) &&
                (centre.array() >= low.array()).all() && (centre.array() <= high.array()).all())
                behind += now[at(f)] * area(after, f);
        }
        EXPECT_NEAR(behind, before, 1e-12 * size);
    }
}

TEST_P(CarryByAlpha, ConstantsAndBoundsAreConserved) {
    std::vector<double> step;
    for (int f = 0; f < mesh.n_faces(); ++f)
        step.push_back(adapt::samples::centre(mesh, f)[0] < 6 ? 0 : 4);
    set(mesh, Entity::face, "constant", Carry::conserve, std::vector<double>(at(mesh.n_faces()), 0.1));
    set(mesh, Entity::face, "step", Carry::conserve, step);
    const QuadMesh after = adapted(mesh, patches, GetParam());
    for (const double value : get(after, Entity::face, "constant"))
        EXPECT_EQ(value, 0.1);
    int between = 0;
    for (const double value : get(after, Entity::face, "step")) {
        EXPECT_GE(value, 0);
        EXPECT_LE(value, 4);
        between += value > 0 && value < 4;
    }
    EXPECT_GT(between, 0);
}

TEST_P(CarryByAlpha, InheritedIsTheNearestOfThoseReplaced) {
    const auto numbers = [](int n) {
        std::vector<double> values;
        for (int i = 0; i < n; ++i)
            values.push_back(i);
        return values;
    };
    set(mesh, Entity::vertex, "v", Carry::inherit, numbers(mesh.n_vertices()));
    set(mesh, Entity::edge, "e", Carry::inherit, numbers(mesh.n_edges()));
    set(mesh, Entity::face, "f", Carry::inherit, numbers(mesh.n_faces()));
    const QuadMesh after = adapted(mesh, patches, GetParam());
    std::set<int> vertices, edges, faces;
    for (const std::vector<int> &patch : patches)
        for (const int f : patch) {
            const std::array<int, 4> corners = mesh.corners(f);
            faces.insert(f);
            for (std::size_t i = 0; i < 4; ++i) {
                vertices.insert(corners[i]);
                edges.insert(mesh.find_edge(corners[i], corners[(i + 1) % 4]));
            }
        }
    const auto middle = [](const QuadMesh &of, int e) {
        return (of.point(of.edge_vertices(e)[0]) + of.point(of.edge_vertices(e)[1])) / 2.0;
    };
    const auto point = [](const QuadMesh &of, int v) { return of.point(v); };
    const auto expect = [&](const std::vector<double> &now, const std::vector<std::int32_t> &origin,
                            const std::set<int> &candidates, const auto &place) {
        int fresh = 0;
        for (int i = 0; i < static_cast<int>(origin.size()); ++i) {
            if (origin[at(i)] >= 0)
                continue;
            ++fresh;
            ASSERT_EQ(candidates.count(static_cast<int>(now[at(i)])), 1u);
            const double told = (place(mesh, static_cast<int>(now[at(i)])) - place(after, i)).norm();
            for (const int candidate : candidates)
                ASSERT_LE(told, (place(mesh, candidate) - place(after, i)).norm() + 1e-14);
        }
        EXPECT_GT(fresh, 0);
    };
    expect(get(after, Entity::vertex, "v"), after.vertex_origin, vertices, point);
    expect(get(after, Entity::edge, "e"), after.edge_origin, edges, middle);
    expect(get(after, Entity::face, "f"), after.face_origin, faces, adapt::samples::centre);
}

TEST_P(CarryByAlpha, DroppedFieldsAreGone) {
    set(mesh, Entity::vertex, "gone", Carry::drop, random_values(mesh.n_vertices(), 6));
    set(mesh, Entity::vertex, "stays", Carry::inherit, random_values(mesh.n_vertices(), 6));
    const QuadMesh after = adapted(mesh, patches, GetParam());
    EXPECT_EQ(after.field(Entity::vertex, "gone"), nullptr);
    EXPECT_NE(after.field(Entity::vertex, "stays"), nullptr);
    EXPECT_NE(mesh.field(Entity::vertex, "gone"), nullptr);
}

INSTANTIATE_TEST_SUITE_P(Carry, CarryByAlpha, testing::Values(0.5, 1.0, 2.5),
                         [](const auto &info) { return std::to_string(static_cast<int>(10 * info.param)); });

TEST(CarryThroughSmooth, FieldsFollowThePoints) {
    QuadMesh mesh = adapt::samples::grid(10, 10);
    std::mt19937 random(8);
    for (int v = 0; v < mesh.n_vertices(); ++v)
        if (!mesh.on_boundary(v))
            mesh.set_point(v, mesh.point(v) + OpenMesh::Vec3d(0.6 * adapt::samples::chance(random) - 0.3,
                                                              0.6 * adapt::samples::chance(random) - 0.3, 0));
    const std::vector<double> values = random_values(mesh.n_faces(), 9);
    const auto f = [](const OpenMesh::Vec3d &p) { return 3 - 2 * p[0] + 0.5 * p[1]; };
    set(mesh, Entity::face, "mass", Carry::conserve, values);
    set(mesh, Entity::face, "label", Carry::inherit, values);
    set(mesh, Entity::vertex, "linear", Carry::linear, of_vertices(mesh, f));
    set(mesh, Entity::vertex, "random", Carry::linear, random_values(mesh.n_vertices(), 10));
    set(mesh, Entity::vertex, "drop", Carry::drop, random_values(mesh.n_vertices(), 11));
    const QuadMesh after = smoothed(mesh);
    EXPECT_EQ(get(after, Entity::face, "label"), values);
    EXPECT_EQ(get(after, Entity::vertex, "drop"), get(mesh, Entity::vertex, "drop"));
    EXPECT_NE(get(after, Entity::face, "mass"), values);
    EXPECT_NEAR(integral(after, get(after, Entity::face, "mass")), integral(mesh, values), 1e-12 * 100);
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        EXPECT_NEAR(get(after, Entity::vertex, "linear")[at(v)], f(after.point(v)), 1e-12);
        if (after.point(v) == mesh.point(v)) {
            EXPECT_EQ(get(after, Entity::vertex, "linear")[at(v)],
                      get(mesh, Entity::vertex, "linear")[at(v)]);
            EXPECT_EQ(get(after, Entity::vertex, "random")[at(v)],
                      get(mesh, Entity::vertex, "random")[at(v)]);
        }
    }
}

// Patches in 3D have a plane of their own; a mesh may be clockwise.
TEST(CarryInAnyPlane, RulesHold) {
    for (const bool clockwise : {false, true}) {
        const QuadMesh flat = adapt::samples::unstructured(12, 3);
        std::vector<double> points;
        std::vector<std::int32_t> corners;
        for (int v = 0; v < flat.n_vertices(); ++v) {
            const OpenMesh::Vec3d &p = flat.point(v);
            if (clockwise)
                points.insert(points.end(), {p[0], -p[1], 0});
            else
                points.insert(points.end(), {0.6 * p[0] + 100, p[1] - 40, 0.8 * p[0]});
        }
        for (int f = 0; f < flat.n_faces(); ++f)
            for (const int v : flat.corners(f))
                corners.push_back(v);
        QuadMesh mesh = QuadMesh::build(clockwise ? 2 : 3, points, corners);
        const std::vector<double> values = random_values(mesh.n_faces(), 12);
        const auto f = [](const OpenMesh::Vec3d &p) { return 1 + p[0] - 2 * p[1] + p[2]; };
        set(mesh, Entity::face, "mass", Carry::conserve, values);
        set(mesh, Entity::vertex, "linear", Carry::linear, of_vertices(mesh, f));
        const std::vector<char> none(at(mesh.n_faces()), 0);
        const QuadMesh after =
            adapted(mesh, {patch::repair(mesh, patch::rings(mesh, 6 * 13 + 6, 4, none), none)}, 2);
        EXPECT_NEAR(integral(after, get(after, Entity::face, "mass")), integral(mesh, values), 1e-12 * 144);
        const std::vector<double> &now = get(after, Entity::vertex, "linear");
        for (int v = 0; v < after.n_vertices(); ++v)
            EXPECT_NEAR(now[at(v)], f(after.point(v)), 1e-11);
    }
}

// The frame of such a plane is rounded, so that the new faces are a hair off the old ones.
TEST(CarryInAnyPlane, AveragesAreThoseOfOverlaps) {
    const QuadMesh flat = adapt::samples::unstructured(12, 3);
    for (const int axis : {0, 2}) {
        std::vector<double> points;
        std::vector<std::int32_t> corners;
        for (int v = 0; v < flat.n_vertices(); ++v) {
            const double x = flat.point(v)[0] / 10, y = flat.point(v)[1] / 10;
            if (axis == 0)
                points.insert(points.end(), {0.7, x, y});
            else
                points.insert(points.end(), {x, y, 0.3});
        }
        for (const std::array<int, 4> &face : flat.faces())
            corners.insert(corners.end(), face.begin(), face.end());
        QuadMesh mesh = QuadMesh::build(3, points, corners);
        const std::vector<double> values = random_values(mesh.n_faces(), 18);
        set(mesh, Entity::face, "mass", Carry::average, values);
        const std::vector<char> none(at(mesh.n_faces()), 0);
        const std::vector<int> patch = patch::repair(mesh, patch::rings(mesh, 6 * 13 + 6, 4, none), none);
        const QuadMesh after = adapted(mesh, {patch}, 2);
        const std::vector<double> &now = get(after, Entity::face, "mass");
        for (int f = 0; f < after.n_faces(); ++f) {
            if (after.face_origin[at(f)] >= 0)
                continue;
            double sum = 0;
            for (const int old : patch)
                sum += values[at(old)] *
                       geometry::overlap(reference::quad_of(after, f), reference::quad_of(mesh, old)).area;
            EXPECT_NEAR(now[at(f)], sum / area(after, f), 1e-12);
        }
    }
}

// The block i, j in 1..3 of a grid is filled with the same quads turned, by hand: so a curved
// region and one with all its vertices new can be made, too.
QuadMesh refilled(const QuadMesh &before, const OpenMesh::Vec3d &middle) {
    QuadMesh after = before;
    after.reset_origins();
    const std::vector<int> faces = adapt::samples::block(4, 1, 1, 3, 3);
    const std::vector<int> loop{6, 7, 8, 13, 18, 17, 16, 11};
    const std::vector<std::array<int, 4>> quads{{0, 1, 8, 7}, {1, 2, 3, 8}, {8, 3, 4, 5}, {7, 8, 5, 6}};
    after.replace_disk(faces, loop, quads, std::vector{middle});
    carry(before, after, silent);
    return after;
}

TEST(CarryOnASurface, TheIntegralIsKeptWhereTheAreaIsNot) {
    QuadMesh mesh = adapt::samples::grid(4, 4, 3);
    mesh.set_point(12, {2, 2, 0.5});
    std::vector<double> values(16, 0.0);
    values[5] = 3;
    values[10] = 1;
    set(mesh, Entity::face, "mass", Carry::conserve, values);
    set(mesh, Entity::face, "none", Carry::conserve, std::vector<double>(16, 0.0));
    const QuadMesh after = refilled(mesh, {2.1, 1.9, -0.2});
    EXPECT_GT(std::abs(area(mesh, 5) - area(after, 5)), 1e-3);
    const std::vector<double> &now = get(after, Entity::face, "mass");
    EXPECT_NEAR(integral(after, now), integral(mesh, values), 1e-12);
    for (const double value : now)
        EXPECT_GE(value, 0);
    EXPECT_EQ(get(after, Entity::face, "none"), std::vector<double>(16, 0.0));
}

TEST(CarryOnASurface, AClosedMeshMayBeAllNew) {
    std::vector<double> points;
    std::vector<std::int32_t> faces;
    const int n = 6, m = 5; // a torus
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const double a = 2 * std::numbers::pi * i / n, b = 2 * std::numbers::pi * j / m;
            points.insert(points.end(),
                          {(3 + std::cos(b)) * std::cos(a), (3 + std::cos(b)) * std::sin(a), std::sin(b)});
            const auto v = [&](int k, int l) { return l % m * n + k % n; };
            faces.insert(faces.end(), {v(i, j), v(i + 1, j), v(i + 1, j + 1), v(i, j + 1)});
        }
    QuadMesh mesh = QuadMesh::build(3, points, faces);
    const std::vector<double> values = random_values(mesh.n_faces(), 13);
    set(mesh, Entity::face, "mass", Carry::conserve, values);
    set(mesh, Entity::vertex, "linear", Carry::linear, random_values(mesh.n_vertices(), 14));
    set(mesh, Entity::edge, "inherit", Carry::inherit, random_values(mesh.n_edges(), 15));
    for (double &p : points)
        p *= 1.05;
    QuadMesh after = QuadMesh::build(3, points, faces);
    for (std::vector<std::int32_t> *origin : {&after.vertex_origin, &after.edge_origin, &after.face_origin})
        std::fill(origin->begin(), origin->end(), -1);
    carry(mesh, after, silent);
    EXPECT_NEAR(integral(after, get(after, Entity::face, "mass")), integral(mesh, values), 1e-12 * 100);
    for (const double value : get(after, Entity::vertex, "linear"))
        EXPECT_NE(value, 0);
    EXPECT_EQ(get(after, Entity::edge, "inherit"), get(mesh, Entity::edge, "inherit"));
}

TEST(CarryStops, AndChangesNothing) {
    QuadMesh mesh = adapt::samples::grid(4, 4);
    set(mesh, Entity::face, "first", Carry::inherit, random_values(16, 16));
    set(mesh, Entity::face, "second", Carry::inherit, random_values(16, 17));
    QuadMesh after = mesh;
    after.reset_origins();
    after.face_origin[3] = -1;
    int calls = 0;
    const auto stop = [&](double, const char *stage) {
        EXPECT_STREQ(stage, "carry");
        if (++calls == 2)
            throw Failure(Fault::cancelled, "enough");
    };
    EXPECT_THROW(carry(mesh, after, stop), Failure);
    EXPECT_EQ(calls, 2);
    EXPECT_EQ(get(after, Entity::face, "first"), get(mesh, Entity::face, "first"));
    EXPECT_EQ(get(after, Entity::face, "second"), get(mesh, Entity::face, "second"));
}

TEST(CarryOfNothing, AsksForNothing) {
    const QuadMesh mesh = adapt::samples::grid(2, 2);
    QuadMesh after = mesh;
    carry(mesh, after, [](double, const char *) { FAIL(); });
    EXPECT_TRUE(after.fields.empty());
}

} // namespace
} // namespace alphamst::transfer
