// Random operations on a mesh with boundaries, a line inside, two regions and two points: whatever was done,
// each marker has the same curve between the same ends, each region its area, each point its place, and all
// have their names.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "alphamst/alphamst.h"

namespace {

#ifdef ALPHAMST_FULL_CAMPAIGN
constexpr int n_trials = 2000;
#else
constexpr int n_trials = 60;
#endif

using Mesh = std::unique_ptr<amst_mesh, void (*)(amst_mesh *)>;
using Options = std::unique_ptr<amst_options, void (*)(amst_options *)>;
using Patches = std::unique_ptr<amst_patches, void (*)(amst_patches *)>;
using Point = std::array<double, 3>;

void must(amst_status status) { ASSERT_GE(status, 0) << amst_last_error(); }

std::int64_t count(const Mesh &mesh, std::int32_t entity) {
    std::int64_t n = 0;
    must(amst_mesh_get_count(mesh.get(), entity, &n));
    return n;
}

std::vector<std::int32_t> markers(const Mesh &mesh, std::int32_t entity) {
    std::int64_t n = count(mesh, entity);
    std::vector<std::int32_t> values(static_cast<std::size_t>(n));
    must(amst_mesh_get_markers(mesh.get(), entity, values.data(), n, &n));
    return values;
}

// What operations keep.
struct Kept {
    std::map<std::int32_t, double> lengths, areas;   // of the edges and faces of each marker
    std::map<std::int32_t, std::vector<Point>> ends; // of the curves of each marker, in order
    std::map<std::int32_t, Point> points;            // that have a marker
    std::map<std::int32_t, std::string> names;       // of the markers of edges
};

std::vector<Point> points_of(const Mesh &mesh) {
    std::int32_t dim = 0;
    must(amst_mesh_get_dim(mesh.get(), &dim));
    std::int64_t n = count(mesh, AMST_VERTEX) * dim;
    std::vector<double> flat(static_cast<std::size_t>(n));
    must(amst_mesh_get_points(mesh.get(), flat.data(), n, &n));
    std::vector<Point> points;
    for (auto at = flat.begin(); at != flat.end(); at += dim)
        points.push_back({at[0], at[1], dim == 3 ? at[2] : 0});
    return points;
}

void keep_edges(const Mesh &mesh, const std::vector<Point> &points, Kept &kept) {
    std::int64_t n = 2 * count(mesh, AMST_EDGE);
    std::vector<amst_id> edges(static_cast<std::size_t>(n));
    must(amst_mesh_get_edges(mesh.get(), edges.data(), n, &n));
    const std::vector<std::int32_t> marker = markers(mesh, AMST_EDGE);
    std::map<std::pair<std::int32_t, amst_id>, int> valence; // of a vertex on the edges of a marker
    for (std::size_t e = 0; e < marker.size(); ++e) {
        if (marker[e] == 0)
            continue;
        const amst_id v = edges[2 * e], w = edges[2 * e + 1];
        const Point &p = points[static_cast<std::size_t>(v)], &q = points[static_cast<std::size_t>(w)];
        kept.lengths[marker[e]] += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
        ++valence[{marker[e], v}];
        ++valence[{marker[e], w}];
    }
    for (const auto &[at, n_edges] : valence)
        if (n_edges != 2)
            kept.ends[at.first].push_back(points[static_cast<std::size_t>(at.second)]);
    for (auto &[m, ends] : kept.ends)
        std::sort(ends.begin(), ends.end());
}

Kept kept_of(const Mesh &mesh) {
    Kept kept;
    const std::vector<Point> points = points_of(mesh);
    keep_edges(mesh, points, kept);
    std::vector<double> area(static_cast<std::size_t>(count(mesh, AMST_FACE)));
    std::int64_t n = 0;
    must(amst_mesh_get_quality(mesh.get(), AMST_METRIC_AREA, area.data(),
                               static_cast<std::int64_t>(area.size()), &n));
    const std::vector<std::int32_t> regions = markers(mesh, AMST_FACE), wells = markers(mesh, AMST_VERTEX);
    for (std::size_t f = 0; f < area.size(); ++f)
        kept.areas[regions[f]] += area[f];
    for (std::size_t v = 0; v < points.size(); ++v)
        if (wells[v] != 0) {
            EXPECT_TRUE(kept.points.emplace(wells[v], points[v]).second);
        }
    for (const auto &[marker, length] : kept.lengths) {
        char name[32] = "";
        must(amst_mesh_get_marker_name(mesh.get(), AMST_EDGE, marker, name, sizeof name, &n));
        kept.names[marker] = name;
    }
    return kept;
}

void expect_near(const std::map<std::int32_t, double> &now, const std::map<std::int32_t, double> &before,
                 double tolerance) {
    ASSERT_EQ(now.size(), before.size());
    for (const auto &[marker, value] : before)
        EXPECT_NEAR(now.at(marker), value, tolerance * value) << marker;
}

// On [0, 12] x [0, 8]: sides 1 to 4, a border of regions at x = 6, a line at y = 4 up to there with the
// marker 5, wells inside and on the border. Bent: on a paraboloid.
Mesh marked(bool bent) {
    constexpr int nx = 12, ny = 8;
    std::vector<double> points;
    std::vector<std::int32_t> faces;
    for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i) {
            points.insert(points.end(), {double(i), double(j)});
            if (bent)
                points.push_back(.02 * (i - 5) * (i - 5) + .03 * j * j);
            const int v = j * (nx + 1) + i;
            if (i < nx && j < ny)
                faces.insert(faces.end(), {v, v + 1, v + nx + 2, v + nx + 1});
        }
    const int dim = bent ? 3 : 2;
    amst_context *context = nullptr;
    amst_mesh *made = nullptr;
    must(amst_context_create(0, &context));
    must(amst_mesh_create(context, dim, points.data(), static_cast<std::int64_t>(points.size()) / dim, 0, 0,
                          faces.data(), nx * ny, 0, 0, 4, nullptr, &made));
    amst_context_destroy(context);
    const auto mark = [&](std::int32_t marker, int i, int j, int di, int dj, int n) {
        for (int k = 0; k < n; ++k, i += di, j += dj) {
            const std::array<amst_id, 2> pair{j * (nx + 1) + i, (j + dj) * (nx + 1) + i + di};
            amst_id edge = -1;
            must(amst_mesh_find_edges(made, pair.data(), 1, &edge));
            must(amst_mesh_set_markers(made, AMST_EDGE, &edge, 1, marker));
        }
        must(amst_mesh_set_marker_name(made, AMST_EDGE, marker, ("line " + std::to_string(marker)).c_str()));
    };
    mark(1, 0, 0, 1, 0, nx);
    mark(2, nx, 0, 0, 1, ny);
    mark(3, 0, ny, 1, 0, nx);
    mark(4, 0, 0, 0, 1, ny);
    mark(5, 0, 4, 1, 0, nx / 2);
    for (amst_id f = 0; f < nx * ny; ++f)
        must(amst_mesh_set_markers(made, AMST_FACE, &f, 1, f % nx < nx / 2 ? 10 : 20));
    const amst_id inside = 2 * (nx + 1) + 9, border = 6 * (nx + 1) + 6;
    must(amst_mesh_set_markers(made, AMST_VERTEX, &inside, 1, 77));
    must(amst_mesh_set_markers(made, AMST_VERTEX, &border, 1, 78));
    return {made, amst_mesh_destroy};
}

amst_status operate(const Mesh &mesh, std::mt19937 &random, std::string &name) {
    amst_options *made = nullptr;
    must(amst_options_create(&made));
    const Options options(made, amst_options_destroy);
    must(amst_options_set_int(made, AMST_OPT_EDIT_BOUNDARY, random() % 2));
    must(amst_options_set_int(made, AMST_OPT_SEED, random() % 100));
    must(amst_options_set_real(made, AMST_OPT_EFFORT, .1));
    const std::int64_t n = count(mesh, AMST_FACE);
    const double alpha = n > 250 ? .5 : n < 60 ? 2 : std::array<double, 4>{.5, .8, 1.5, 2}[random() % 4];
    amst_patches *decomposed = nullptr;
    must(amst_patches_create(mesh.get(), made, &decomposed));
    const Patches patches(decomposed, amst_patches_destroy);
    must(amst_patches_decompose(decomposed, static_cast<std::int32_t>(random() % 5), nullptr));
    const auto edge = static_cast<amst_id>(random() % static_cast<std::size_t>(count(mesh, AMST_EDGE)));
    switch (random() % 9) {
    case 0:
        name = "adapt whole";
        return amst_adapt(mesh.get(), nullptr, alpha, made, nullptr);
    case 1:
        name = "adapt patches";
        return amst_adapt(mesh.get(), decomposed, alpha, made, nullptr);
    case 2:
        name = "adapt by chords";
        must(amst_options_set_int(made, AMST_OPT_STRATEGY, 1));
        return amst_adapt(mesh.get(), nullptr, alpha, made, nullptr);
    case 3:
        name = "smooth";
        return amst_smooth(mesh.get(), nullptr, made, nullptr);
    case 4:
        name = "clean";
        return amst_clean(mesh.get(), made, nullptr);
    case 5:
        name = "reduce";
        return amst_reduce_singularities(mesh.get(), random() % 2 == 0 ? nullptr : decomposed, made, nullptr);
    case 6:
        name = "insert chords";
        return amst_insert_chords(mesh.get(), decomposed, 1, made, nullptr);
    case 7:
        name = "split";
        return amst_split_chord(mesh.get(), edge, 1, made, nullptr);
    default:
        name = "collapse";
        return amst_collapse_chord(mesh.get(), edge, made, nullptr);
    }
}

// The most that lengths and areas may change, as parts of them.
void campaign(bool bent, unsigned seed, double tolerance) {
    std::mt19937 random(seed);
    Mesh mesh(nullptr, amst_mesh_destroy);
    Kept before;
    std::map<std::string, int> done;
    for (int i = 0; i < n_trials && !testing::Test::HasFailure(); ++i) {
        if (i % 15 == 0) {
            mesh = marked(bent);
            before = kept_of(mesh);
        }
        std::string name;
        const amst_status status = operate(mesh, random, name);
        ASSERT_TRUE(status >= 0 || status == AMST_ERR_CHORD || status == AMST_ERR_GEOMETRY)
            << name << ": " << amst_last_error();
        done[name] += status >= 0;
        SCOPED_TRACE("trial " + std::to_string(i) + ", " + name);
        const Kept now = kept_of(mesh);
        expect_near(now.lengths, before.lengths, tolerance);
        expect_near(now.areas, before.areas, tolerance);
        EXPECT_EQ(now.ends, before.ends);
        EXPECT_EQ(now.points, before.points);
        EXPECT_EQ(now.names, before.names);
    }
    EXPECT_EQ(done.size(), 9U);
}

TEST(MarkerCampaign, InThePlane) { campaign(false, 1, 1e-9); }

TEST(MarkerCampaign, OnASurface) { campaign(true, 2, .05); }

} // namespace
