#include "run.h"

#include <atomic>
#include <functional>
#include <thread>

namespace alphamst::adapt::samples {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Outcome adapt_one(mesh::QuadMesh &mesh, std::vector<int> faces, double alpha, const Settings &settings = {}) {
    std::vector<Patch> regions(1);
    regions[0].faces = std::move(faces);
    return adapt(mesh, regions, alpha, settings, silent).at(0);
}

// A sheet of n by n faces with a block of 6 by 6 in the middle.
struct Middle {
    mesh::QuadMesh mesh = grid(12, 12);
    std::vector<int> faces = block(12, 3, 3, 9, 9);
    int inside = 6 * 13 + 6, buffer = 3 * 13 + 6; // vertices
};

// What the boundary does not allow comes as near as can be, and says so.
void expect_count_or_nearest(const Outcome &outcome) {
    const auto [few, many] = std::minmax(outcome.faces_before, outcome.faces_wanted);
    if (std::abs(outcome.faces_after - outcome.faces_wanted) <= 2)
        return;
    EXPECT_GT(outcome.faces_after, few);
    EXPECT_LT(outcome.faces_after, many);
    EXPECT_NE(outcome.text.find("the nearest number of faces is"), std::string::npos) << outcome.text;
}

TEST(Adapt, KeepsEverythingOutside) {
    mesh::QuadMesh mesh = unstructured(30, 3);
    std::mt19937 random(4);
    mesh.vertex_flags[0] = mesh.edge_flags[0] = mesh.face_flags[0] = mesh::fixed;
    int done = 0;
    for (int i = 0; i < 30; ++i) {
        const double alphas[] = {0.4, 0.8, 1, 1.5, 4};
        const double alpha = alphas[i % 5];
        const std::vector<int> patch = random_patch(mesh, 20, 120, random);
        SCOPED_TRACE("run " + std::to_string(i) + ", alpha " + std::to_string(alpha));
        const auto result = run(mesh, patch, alpha);
        if (result.outcome.fault)
            continue;
        ++done;
        expect_count_or_nearest(result.outcome);
        ASSERT_TRUE(result.prediction);
        EXPECT_EQ(result.prediction->faces, result.outcome.faces_after);
        EXPECT_EQ(result.prediction->singularities, result.outcome.singular_after);
    }
    EXPECT_GE(done, 25);
}

TEST(Adapt, AgainAndAgain) { // what is renumbered must be found again
    mesh::QuadMesh mesh = unstructured(20, 5);
    std::mt19937 random(6);
    for (int i = 0; i < 20; ++i) {
        mesh.reset_origins();
        const mesh::QuadMesh before = mesh;
        const std::vector<int> patch = random_patch(mesh, 20, 80, random);
        if (adapt_one(mesh, patch, i % 2 == 0 ? 0.6 : 1.6).fault)
            continue;
        ASSERT_NO_THROW(mesh.check());
        expect_outside_kept(before, mesh, {patch});
    }
}

// Some programs write faces clockwise; then the mesh is seen from below.
TEST(Adapt, ClockwiseMeshIsAdaptedAsItsMirrorImage) {
    const mesh::QuadMesh mesh = unstructured(20, 5);
    mesh::QuadMesh below = mesh;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        below.set_point(v, {mesh.point(v)[0], -mesh.point(v)[1], 0});
    std::mt19937 random(6);
    int done = 0;
    for (const double alpha : {0.6, 1.0, 2.0, 3.0}) {
        const std::vector<int> patch = random_patch(mesh, 40, 80, random);
        mesh::QuadMesh one = mesh, other = below;
        const Outcome expected = adapt_one(one, patch, alpha), outcome = adapt_one(other, patch, alpha);
        ASSERT_EQ(outcome.fault, expected.fault);
        EXPECT_EQ(outcome.singular_after, expected.singular_after);
        EXPECT_EQ(outcome.quality_after, expected.quality_after);
        done += !outcome.fault;
        ASSERT_EQ(other.n_vertices(), one.n_vertices());
        for (int v = 0; v < one.n_vertices(); ++v)
            ASSERT_EQ(other.point(v), OpenMesh::Vec3d(one.point(v)[0], -one.point(v)[1], 0));
        smooth::smooth(one, nullptr, {}, silent);
        smooth::smooth(other, nullptr, {}, silent);
        for (int v = 0; v < one.n_vertices(); ++v)
            ASSERT_EQ(other.point(v), OpenMesh::Vec3d(one.point(v)[0], -one.point(v)[1], 0));
    }
    EXPECT_GE(done, 3);
}

TEST(Adapt, RegularBlockBecomesFinerAndCoarser) {
    for (const double alpha : {0.6, 0.8, 1.25, 2.0, 3.0}) {
        const Middle middle;
        const auto result = run(middle.mesh, middle.faces, alpha);
        ASSERT_FALSE(result.outcome.fault) << result.outcome.text;
        EXPECT_EQ(result.outcome.faces_after, std::llround(36 * alpha));
        EXPECT_GT(result.outcome.singular_after, 0);
    }
}

TEST(Adapt, RegularBlockStaysAtAlphaOne) {
    const Middle middle;
    const auto result = run(middle.mesh, middle.faces, 1);
    ASSERT_FALSE(result.outcome.fault) << result.outcome.text;
    EXPECT_EQ(result.outcome.faces_after, 36);
    EXPECT_EQ(result.outcome.singular_after, 0);
    std::vector<Patch> regions(1);
    regions[0].faces = middle.faces;
    mesh::QuadMesh after = middle.mesh;
    adapt(after, regions, 1, {}, silent);
    EXPECT_EQ(after.checksum(), middle.mesh.checksum());
}

TEST(Adapt, AlphaOfThePatchComesFirst) {
    Middle middle;
    std::vector<Patch> regions(1);
    regions[0].faces = middle.faces;
    regions[0].alpha = 2;
    EXPECT_EQ(predict(middle.mesh, regions[0], 0.5, {}).faces, 72);
    EXPECT_EQ(adapt(middle.mesh, regions, 0.5, {}, silent).at(0).faces_after, 72);
}

TEST(Adapt, ValencesAreThoseOfThePatch) {
    mesh::QuadMesh mesh = unstructured(20, 7);
    std::mt19937 random(8);
    const std::vector<int> patch = random_patch(mesh, 80, 81, random);
    const mesh::QuadMesh before = mesh;
    std::vector<Patch> regions(1);
    regions[0].faces = patch;
    const Outcome outcome = adapt(mesh, regions, 1.5, {}, silent).at(0);
    ASSERT_FALSE(outcome.fault) << outcome.text;
    const auto valences = [](const mesh::QuadMesh &of, const std::vector<int> &faces) {
        std::set<int> vertices;
        for (const int f : faces)
            for (const int v : of.corners(f))
                vertices.insert(v);
        std::map<int, std::int64_t> count;
        for (const int v : vertices)
            if (!of.on_boundary(v))
                ++count[of.valence(v)];
        return count;
    };
    EXPECT_EQ(outcome.valences_before, valences(before, patch));
    EXPECT_EQ(outcome.valences_after, valences(mesh, regions[0].faces));
}

TEST(Adapt, NewFacesInheritTheRegion) {
    Middle middle;
    middle.mesh.face_marker.assign(144, 7);
    middle.mesh.edge_marker.assign(at(middle.mesh.n_edges()), 0);
    middle.mesh.edge_marker[at(middle.mesh.find_edge(0, 1))] = 3;
    middle.mesh.reset_origins();
    const mesh::QuadMesh before = middle.mesh;
    ASSERT_FALSE(adapt_one(middle.mesh, middle.faces, 2).fault);
    EXPECT_EQ(middle.mesh.face_marker, std::vector<std::int32_t>(at(middle.mesh.n_faces()), 7));
    expect_outside_kept(before, middle.mesh, {middle.faces});
}

// What must not be crossed, inside and on the buffer of the block.
using Mark = std::function<void(Middle &, int)>;

const std::pair<const char *, Mark> vertex_marks[] = {
    {"FIXED vertex", [](Middle &m, int v) { m.mesh.vertex_flags[at(v)] = mesh::fixed; }},
    {"FEATURE vertex", [](Middle &m, int v) { m.mesh.vertex_flags[at(v)] = mesh::feature; }},
    {"CORNER vertex", [](Middle &m, int v) { m.mesh.vertex_flags[at(v)] = mesh::corner; }},
    {"FIXED edge", [](Middle &m, int v) { m.mesh.edge_flags[at(m.mesh.find_edge(v, v + 1))] = mesh::fixed; }},
    {"FEATURE edge",
     [](Middle &m, int v) { m.mesh.edge_flags[at(m.mesh.find_edge(v, v + 1))] = mesh::feature; }},
    {"marked edge", [](Middle &m, int v) {
         m.mesh.edge_marker.assign(at(m.mesh.n_edges()), 0);
         m.mesh.edge_marker[at(m.mesh.find_edge(v, v + 1))] = 5;
     }}};

TEST(Adapt, NothingHeldLiesInside) {
    for (const auto &[name, mark] : vertex_marks) {
        Middle middle;
        mark(middle, middle.inside);
        const auto result = run(middle.mesh, middle.faces, 2);
        EXPECT_EQ(result.outcome.fault, Fault::patch) << name;
        EXPECT_FALSE(result.prediction) << name;
    }
    Middle middle;
    middle.mesh.face_marker.assign(144, 7);
    middle.mesh.face_marker[6 * 12 + 6] = 8;
    EXPECT_EQ(run(middle.mesh, middle.faces, 2).outcome.fault, Fault::patch);
}

TEST(Adapt, WhatIsHeldMayLieOnTheRim) {
    for (const auto &[name, mark] : vertex_marks) {
        Middle middle;
        mark(middle, middle.buffer);
        SCOPED_TRACE(name);
        EXPECT_FALSE(run(middle.mesh, middle.faces, 2).outcome.fault);
    }
}

TEST(Adapt, RefinesARing) {
    const Middle middle;
    std::vector<Patch> rings(1);
    rings[0].faces = middle.faces;
    std::erase(rings[0].faces, 6 * 12 + 6);
    mesh::QuadMesh mesh = middle.mesh;
    const std::int64_t before = std::ssize(rings[0].faces);
    const Outcome outcome = adapt(mesh, rings, 2, {}, silent).at(0);
    EXPECT_FALSE(outcome.fault) << outcome.text;
    EXPECT_EQ(outcome.faces_wanted, 2 * before);
    EXPECT_EQ(std::ssize(rings[0].faces), outcome.faces_after);
    EXPECT_NEAR(static_cast<double>(outcome.faces_after), 2.0 * static_cast<double>(before), 4);
    EXPECT_NO_THROW(mesh.check());
}

TEST(Adapt, RefusesWhatIsNeitherDiskNorRing) {
    const Middle middle;
    std::vector<int> pinched = block(12, 1, 1, 3, 3), apart = block(12, 0, 0, 2, 2);
    for (const int f : block(12, 3, 3, 5, 5))
        pinched.push_back(f);
    for (const int f : block(12, 6, 6, 8, 8))
        apart.push_back(f);
    mesh::QuadMesh mesh = middle.mesh;
    for (const std::vector<int> &faces : {pinched, apart, std::vector<int>()}) {
        EXPECT_EQ(adapt_one(mesh, faces, 2).fault, Fault::patch);
        EXPECT_EQ(mesh.checksum(), middle.mesh.checksum());
    }
}

TEST(Adapt, CornersMustLieOnTheBoundary) {
    Middle middle;
    std::vector<Patch> regions(1);
    regions[0].faces = middle.faces;
    regions[0].corners = {middle.inside, middle.buffer, middle.buffer + 1};
    EXPECT_EQ(adapt(middle.mesh, regions, 2, {}, silent).at(0).fault, Fault::patch);
}

TEST(Adapt, PatchOfOneFace) {
    const mesh::QuadMesh mesh = grid(5, 5);
    for (const double alpha : {0.4, 1.0, 2.0, 3.0, 5.0, 9.0}) {
        const auto result = run(mesh, {12}, alpha);
        if (!result.outcome.fault)
            expect_count_or_nearest(result.outcome);
    }
    const auto kept = run(mesh, {12}, 1);
    EXPECT_FALSE(kept.outcome.fault) << kept.outcome.text;
    EXPECT_EQ(kept.outcome.faces_after, 1);
}

TEST(Adapt, WholeMeshAsOnePatch) {
    const mesh::QuadMesh mesh = unstructured(12, 9);
    for (const double alpha : {0.6, 1.0, 1.5, 4.0}) {
        SCOPED_TRACE(alpha);
        const auto result = run(mesh, all_faces(mesh), alpha);
        EXPECT_FALSE(result.outcome.fault) << result.outcome.text;
        EXPECT_LE(std::abs(result.outcome.faces_after - result.outcome.faces_wanted), 2);
    }
}

TEST(Adapt, PlaneInSpace) {
    const mesh::QuadMesh flat = unstructured(14, 10);
    std::vector<double> points;
    std::vector<std::int32_t> faces;
    const OpenMesh::Vec3d right(0.6, 0.8, 0), up(-0.48, 0.36, 0.8);
    for (int v = 0; v < flat.n_vertices(); ++v) {
        const OpenMesh::Vec3d p = right * flat.point(v)[0] + up * flat.point(v)[1];
        points.insert(points.end(), {p[0] + 5, p[1], p[2] - 3});
    }
    for (const auto &corners : flat.faces())
        faces.insert(faces.end(), corners.begin(), corners.end());
    mesh::QuadMesh mesh = mesh::QuadMesh::build(3, points, faces);
    const mesh::QuadMesh before = mesh;
    std::mt19937 random(11);
    const std::vector<int> patch = random_patch(mesh, 60, 61, random);
    const Outcome outcome = adapt_one(mesh, patch, 2);
    ASSERT_FALSE(outcome.fault) << outcome.text;
    expect_outside_kept(before, mesh, {patch});
    const OpenMesh::Vec3d normal = right.cross(up), origin(5, 0, -3);
    for (int v = 0; v < mesh.n_vertices(); ++v)
        EXPECT_NEAR((mesh.point(v) - origin).dot(normal), 0, 1e-9);
    for (int f = 0; f < mesh.n_faces(); ++f) { // no corner is inverted, seen along the normal
        const auto corners = mesh.corners(f);
        for (std::size_t k = 0; k < 4; ++k) {
            const auto &here = mesh.point(corners[k]);
            const auto next = mesh.point(corners[(k + 1) % 4]) - here;
            EXPECT_GT(next.cross(mesh.point(corners[(k + 3) % 4]) - here).dot(normal), 0);
        }
    }
}

// Patches that touch and patches that do not.
std::vector<Patch> many_patches(const mesh::QuadMesh &mesh) {
    std::vector<char> taken(at(mesh.n_faces()), 0);
    std::vector<Patch> regions;
    for (std::vector<int> &faces : patch::clusters(mesh, 60, 1, taken)) {
        if (faces.size() < 20 || regions.size() == 16)
            continue;
        regions.emplace_back();
        regions.back().faces = std::move(faces);
        regions.back().alpha = regions.size() % 3 == 0 ? 0.6 : 0; // some shrink: ids move
    }
    return regions;
}

TEST(Adapt, SameResultForAnyNumberOfThreads) {
    const mesh::QuadMesh mesh = unstructured(36, 12);
    const std::vector<Patch> patches = many_patches(mesh);
    ASSERT_GE(patches.size(), 12u);
    std::optional<std::uint64_t> checksum;
    std::vector<std::vector<int>> faces;
    for (const int threads : {1, 1, 2, 8, 8, 0}) {
        mesh::QuadMesh after = mesh;
        std::vector<Patch> regions = patches;
        Settings settings;
        settings.threads = threads;
        const std::vector<Outcome> outcomes = adapt(after, regions, 1.7, settings, silent);
        ASSERT_NO_THROW(after.check());
        std::vector<std::vector<int>> given, got;
        std::vector<int> fresh;
        for (std::size_t p = 0; p < regions.size(); ++p) {
            got.push_back(regions[p].faces);
            EXPECT_EQ(outcomes[p].faces_after, static_cast<std::int64_t>(regions[p].faces.size()));
            if (outcomes[p].fault)
                continue;
            given.push_back(patches[p].faces);
            fresh.insert(fresh.end(), regions[p].faces.begin(), regions[p].faces.end());
        }
        EXPECT_GE(given.size(), patches.size() * 9 / 10);
        std::sort(fresh.begin(), fresh.end());
        EXPECT_EQ(fresh, new_ones(after.face_origin));
        expect_outside_kept(mesh, after, given);
        if (!checksum) {
            checksum = after.checksum();
            faces = got;
        }
        EXPECT_EQ(after.checksum(), *checksum) << threads << " threads";
        EXPECT_EQ(got, faces) << threads << " threads";
    }
}

TEST(Adapt, ProgressRisesOnTheCallingThread) {
    mesh::QuadMesh mesh = unstructured(30, 13);
    std::vector<Patch> regions = many_patches(mesh);
    Settings settings;
    settings.threads = 4;
    const auto caller = std::this_thread::get_id();
    std::vector<double> fractions;
    adapt(mesh, regions, 1.5, settings, [&](double fraction, const char *) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        fractions.push_back(fraction);
    });
    ASSERT_GE(fractions.size(), 2u);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_EQ(fractions.front(), 0);
    EXPECT_EQ(fractions.back(), 1);
}

TEST(Adapt, CancelComesThrough) {
    const mesh::QuadMesh mesh = unstructured(30, 13);
    const std::vector<Patch> patches = many_patches(mesh);
    const auto before = mesh.checksum();
    for (int stop = 0; stop < 3; ++stop) {
        mesh::QuadMesh copy = mesh;
        std::vector<Patch> regions = patches;
        int calls = 0;
        try {
            adapt(copy, regions, 2, {}, [&](double, const char *) {
                if (calls++ == stop)
                    throw Failure(Fault::cancelled, "stop");
            });
            ADD_FAILURE() << "not cancelled at call " << stop;
        } catch (const Failure &failure) {
            EXPECT_EQ(failure.fault, Fault::cancelled);
        }
        EXPECT_EQ(mesh.checksum(), before);
        EXPECT_NO_THROW(copy.check()) << "half done, but in order";
        EXPECT_EQ(copy.checksum() == before, stop == 0);
    }
}

TEST(Adapt, NoPatchesNothingHappens) {
    mesh::QuadMesh mesh = grid(4, 4);
    const auto before = mesh.checksum();
    std::vector<Patch> none;
    EXPECT_TRUE(adapt(mesh, none, 2, {}, silent).empty());
    EXPECT_EQ(mesh.checksum(), before);
}

} // namespace
} // namespace alphamst::adapt::samples
