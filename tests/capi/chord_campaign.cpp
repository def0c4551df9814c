// Random collapses and splits of chords: what is accepted leaves a valid mesh with the faces and the
// singular vertices foretold and no element inverted, what is refused leaves everything as it was.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "alphamst/alphamst.h"

namespace {

#ifdef ALPHAMST_FULL_CAMPAIGN
constexpr int n_trials = 10000;
#else
constexpr int n_trials = 400;
#endif

using Mesh = std::unique_ptr<amst_mesh, void (*)(amst_mesh *)>;

void must(amst_status status) { ASSERT_GE(status, 0) << amst_last_error(); }

std::int64_t count(const Mesh &mesh, std::int32_t entity) {
    std::int64_t n = 0;
    must(amst_mesh_get_count(mesh.get(), entity, &n));
    return n;
}

std::int64_t singular(const Mesh &mesh) {
    std::int64_t n = 0;
    must(amst_mesh_get_singularities(mesh.get(), nullptr, 0, &n));
    return n;
}

std::int64_t inverted(const Mesh &mesh) {
    std::vector<double> quality(static_cast<std::size_t>(count(mesh, AMST_FACE)));
    std::int64_t n = 0, bad = 0;
    must(amst_mesh_get_quality(mesh.get(), AMST_METRIC_SCALED_JACOBIAN, quality.data(),
                               static_cast<std::int64_t>(quality.size()), &n));
    for (const double q : quality)
        bad += q <= 0;
    return bad;
}

std::int64_t checksum(const Mesh &mesh) {
    std::int64_t digest = 0;
    must(amst_mesh_get_checksum(mesh.get(), &digest));
    return digest;
}

std::vector<std::int64_t> table(const Mesh &mesh, std::int32_t property, const amst_options *options) {
    std::int64_t n = 0;
    must(amst_mesh_get_chords(mesh.get(), property, options, nullptr, 0, &n));
    std::vector<std::int64_t> values(static_cast<std::size_t>(n));
    must(amst_mesh_get_chords(mesh.get(), property, options, values.data(), n, &n));
    return values;
}

struct Tally {
    int collapsed = 0, split = 0, refused = 0, unshapely = 0;
};

void trial(const Mesh &mesh, std::int64_t most, const amst_options *options, std::mt19937 &random,
           Tally &tally) {
    const auto edges = table(mesh, AMST_CHORD_EDGE, options),
               lengths = table(mesh, AMST_CHORD_LENGTH, options);
    const auto reasons = table(mesh, AMST_CHORD_REFUSAL, options);
    const auto after = table(mesh, AMST_CHORD_SINGULAR_AFTER, options);
    const auto crossings = table(mesh, AMST_CHORD_CROSSINGS, options);
    const std::int64_t singular_before = singular(mesh);
    const std::int64_t faces = count(mesh, AMST_FACE), bad = inverted(mesh), digest = checksum(mesh);
    std::int64_t sum = 0;
    for (const std::int64_t length : lengths)
        sum += length;
    ASSERT_EQ(sum, 2 * faces);
    std::size_t i = random() % edges.size();
    const bool grow = faces < 60 || (faces < most && random() % 2 == 0);
    for (std::size_t step = 0; !grow && random() % 4 != 0 && reasons[i] != 0 && step < edges.size(); ++step)
        i = (i + 1) % edges.size(); // mostly one that can go
    const auto edge = static_cast<amst_id>(edges[i]);
    const auto copies = static_cast<std::int32_t>(1 + random() % 2);
    const amst_status status = grow ? amst_split_chord(mesh.get(), edge, copies, options, nullptr)
                                    : amst_collapse_chord(mesh.get(), edge, options, nullptr);
    if (status < 0) {
        ASSERT_TRUE(status == AMST_ERR_CHORD || status == AMST_ERR_GEOMETRY) << amst_last_error();
        ASSERT_TRUE(grow || (status == AMST_ERR_CHORD) == (reasons[i] != 0)) << amst_last_error();
        ASSERT_EQ(checksum(mesh), digest);
        ++(status == AMST_ERR_CHORD ? tally.refused : tally.unshapely);
        return;
    }
    ASSERT_TRUE(grow || reasons[i] == 0);
    if (bad == 0) {
        ASSERT_EQ(amst_mesh_check(mesh.get()), AMST_OK) << amst_last_error();
    }
    ASSERT_LE(inverted(mesh), bad);
    const std::int64_t n = copies;
    ASSERT_EQ(count(mesh, AMST_FACE),
              grow ? faces + n * lengths[i] + n * n * crossings[i] : faces - lengths[i]);
    ASSERT_EQ(singular(mesh), grow ? singular_before : after[i]);
    ++(grow ? tally.split : tally.collapsed);
}

Tally campaign(const Mesh &start, bool boundary, unsigned seed, int trials) {
    amst_options *made = nullptr;
    must(amst_options_create(&made));
    const std::unique_ptr<amst_options, void (*)(amst_options *)> options(made, amst_options_destroy);
    must(amst_options_set_int(made, AMST_OPT_EDIT_BOUNDARY, boundary ? 1 : 0));
    must(amst_options_set_int(made, AMST_OPT_SMOOTH_STEPS, 3));
    std::mt19937 random(seed);
    Tally tally;
    Mesh mesh(nullptr, amst_mesh_destroy);
    for (int i = 0; i < trials && !testing::Test::HasFatalFailure(); ++i) {
        if (i % 50 == 0) {
            amst_mesh *copy = nullptr;
            must(amst_mesh_clone(start.get(), &copy));
            mesh.reset(copy);
        }
        trial(mesh, 2 * count(start, AMST_FACE), options.get(), random, tally);
    }
    EXPECT_GT(tally.collapsed, trials / 20);
    EXPECT_GT(tally.split, trials / 20);
    return tally;
}

Mesh created(int dim, const std::vector<double> &points, const std::vector<std::int32_t> &faces) {
    amst_context *context = nullptr;
    amst_mesh *mesh = nullptr;
    must(amst_context_create(0, &context));
    must(amst_mesh_create(context, dim, points.data(), static_cast<std::int64_t>(points.size()) / dim, 0, 0,
                          faces.data(), static_cast<std::int64_t>(faces.size() / 4), 0, 0, 4, nullptr,
                          &mesh));
    amst_context_destroy(context);
    return Mesh(mesh, amst_mesh_destroy);
}

Mesh read(const std::string &name) {
    amst_context *context = nullptr;
    amst_mesh *mesh = nullptr;
    const std::string here = __FILE__;
    const std::string path = here.substr(0, here.rfind('/')) + "/../../examples/data/" + name;
    must(amst_context_create(0, &context));
    must(amst_mesh_read(context, path.c_str(), nullptr, &mesh));
    amst_context_destroy(context);
    return Mesh(mesh, amst_mesh_destroy);
}

Mesh torus(int n, int m) {
    std::vector<double> points;
    std::vector<std::int32_t> faces;
    const auto vertex = [&](int i, int j) { return j % m * n + i % n; };
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const double a = 6.283185307179586 * i / n, b = 6.283185307179586 * j / m;
            points.insert(points.end(),
                          {(3 + std::cos(b)) * std::cos(a), (3 + std::cos(b)) * std::sin(a), std::sin(b)});
            faces.insert(faces.end(),
                         {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    return created(3, points, faces);
}

// With alpha templates, whose rings are closed chords.
Mesh adapted(Mesh mesh) {
    amst_patches *made = nullptr;
    must(amst_patches_create(mesh.get(), nullptr, &made));
    const std::unique_ptr<amst_patches, void (*)(amst_patches *)> patches(made, amst_patches_destroy);
    must(amst_patches_decompose(made, AMST_DECOMPOSE_CLUSTERS, nullptr));
    must(amst_adapt(mesh.get(), made, 2, nullptr, nullptr));
    return mesh;
}

TEST(ChordCampaign, Coast) {
    const Tally tally = campaign(adapted(read("coast_small.msh")), true, 1, n_trials / 4);
    EXPECT_GT(tally.refused, 0);
}

TEST(ChordCampaign, PlateWithItsBoundaryKept) { campaign(read("plate.off"), false, 2, n_trials / 4); }

TEST(ChordCampaign, Plate) { campaign(adapted(read("plate.off")), true, 3, n_trials / 4); }

TEST(ChordCampaign, Torus) { campaign(torus(16, 10), false, 4, n_trials / 4); }

} // namespace
