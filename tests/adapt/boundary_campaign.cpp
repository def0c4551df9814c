// Random adaptations that may change the boundary, of meshes with numbered boundaries and corners: every
// number still runs between the same corners, and no face is inverted. The cases are the same in every run.
#include <array>
#include <cmath>
#include <numbers>

#include "adapt/patches.h"
#include "patch/grow.h"
#include "reference/projection.h"
#include "run.h"

namespace alphamst::adapt::samples {
namespace {

#ifdef ALPHAMST_FULL_CAMPAIGN
constexpr int n_runs = 1000;
#else
constexpr int n_runs = 60;
#endif

constexpr std::array<double, 8> alphas{0.3, 0.5, 0.7, 1, 1, 1.5, 2, 4};

using Place = std::array<double, 2>;

Place place_of(const mesh::QuadMesh &mesh, int v) { return {mesh.point(v)[0], mesh.point(v)[1]}; }

// A grid that is closed to a ring, or a square; then bent.
mesh::QuadMesh bent(std::mt19937 &random) {
    const bool ring = random() % 2 == 0;
    const int n = 8 + static_cast<int>(random() % 12), m = 4 + static_cast<int>(random() % 6);
    const int columns = ring ? 3 * n : n;
    std::vector<double> points;
    std::vector<std::int32_t> faces;
    const auto vertex = [&](int i, int j) {
        return j * (ring ? columns : columns + 1) + (ring ? i % columns : i);
    };
    const double waves = 2 + static_cast<double>(random() % 4),
                 height = 0.02 * static_cast<double>(random() % 10);
    for (int j = 0; j <= m; ++j)
        for (int i = 0; i < (ring ? columns : columns + 1); ++i) {
            const double u = static_cast<double>(i) / columns, v = static_cast<double>(j) / m;
            const double wave = height * std::sin(2 * std::numbers::pi * waves * u);
            if (ring) {
                const double angle = 2 * std::numbers::pi * u, radius = 1 + v + wave * (1 - v);
                points.insert(points.end(), {radius * std::cos(angle), radius * std::sin(angle), 0});
            } else {
                points.insert(points.end(), {u * columns / m, v + wave * (1 - v), 0});
            }
        }
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < columns; ++i)
            if (ring) // outwards, so that the faces run counter-clockwise
                faces.insert(faces.end(),
                             {vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1), vertex(i + 1, j)});
            else
                faces.insert(faces.end(),
                             {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    return mesh::QuadMesh::build(2, points, faces);
}

// Numbers by direction, flags at random.
void decorate(mesh::QuadMesh &mesh, std::mt19937 &random) {
    mesh.edge_marker.assign(static_cast<std::size_t>(mesh.n_edges()), 0);
    const int sectors = 1 + static_cast<int>(random() % 5);
    for (int e = 0; e < mesh.n_edges(); ++e) {
        const auto sides = mesh.edge_faces(e);
        if (sides[0] >= 0 && sides[1] >= 0)
            continue;
        const auto [v, w] = mesh.edge_vertices(e);
        const double x = mesh.point(v)[0] + mesh.point(w)[0], y = mesh.point(v)[1] + mesh.point(w)[1];
        const double turn = std::atan2(y - 1, x - 1) / (2 * std::numbers::pi) + 0.5;
        mesh.edge_marker[static_cast<std::size_t>(e)] = 1 + static_cast<int>(turn * sectors * 0.999);
        if (random() % 40 == 0)
            mesh.vertex_flags[static_cast<std::size_t>(v)] = mesh::corner;
        if (random() % 60 == 0)
            mesh.edge_flags[static_cast<std::size_t>(e)] = mesh::fixed;
    }
}

// Ends of the chains of each number, and what else must stay.
struct Kept {
    std::multiset<std::pair<std::int32_t, Place>> ends;
    std::set<Place> flagged;
    std::multiset<std::array<Place, 2>> fixed;

    explicit Kept(const mesh::QuadMesh &mesh) {
        std::map<std::pair<std::int32_t, int>, int> count;
        for (int e = 0; e < mesh.n_edges(); ++e) {
            const std::int32_t marker = mesh.edge_marker[static_cast<std::size_t>(e)];
            const auto [v, w] = mesh.edge_vertices(e);
            if (marker != 0) {
                ++count[{marker, v}];
                ++count[{marker, w}];
            }
            if (mesh.edge_flags[static_cast<std::size_t>(e)] & mesh::fixed)
                fixed.insert({std::min(place_of(mesh, v), place_of(mesh, w)),
                              std::max(place_of(mesh, v), place_of(mesh, w))});
        }
        for (const auto &[end, n] : count)
            if (n != 2)
                ends.insert({end.first, place_of(mesh, end.second)});
        for (int v = 0; v < mesh.n_vertices(); ++v)
            if (mesh.vertex_flags[static_cast<std::size_t>(v)] != 0)
                flagged.insert(place_of(mesh, v));
    }
    bool operator==(const Kept &) const = default;
};

double least(const mesh::QuadMesh &mesh) {
    std::vector<int> all(static_cast<std::size_t>(mesh.n_faces()));
    std::iota(all.begin(), all.end(), 0);
    return least_scaled_jacobian(mesh, all);
}

// The boundary with numbers has no gap: all edges of it are numbered, and no other.
void expect_numbered(const mesh::QuadMesh &mesh) {
    int wrong = 0;
    for (int e = 0; e < mesh.n_edges(); ++e) {
        const auto sides = mesh.edge_faces(e);
        wrong += (sides[0] < 0 || sides[1] < 0) != (mesh.edge_marker[static_cast<std::size_t>(e)] != 0);
    }
    EXPECT_EQ(wrong, 0);
}

void expect_on(const mesh::QuadMesh &mesh, const surface::BoundaryCurves &curves) {
    double farthest = 0;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        if (!mesh.isolated(v) && mesh.on_boundary(v)) {
            const Eigen::Vector3d p(mesh.point(v)[0], mesh.point(v)[1], 0);
            const surface::CurvePlace place = curves.find(p, 1e-9 * curves.extent());
            ASSERT_GE(place.curve, 0) << p.transpose();
            farthest = std::max(farthest, (curves.at(place) - p).norm());
        }
    EXPECT_LE(farthest, 1e-12 * curves.extent());
}

struct Tally {
    int changed = 0, exact = 0, whole = 0, faults = 0;
};

void adapt_once(mesh::QuadMesh &mesh, std::mt19937 &random, Tally &tally) {
    Settings settings;
    settings.edit_boundary = true;
    settings.seed = random();
    const double alpha = alphas[random() % alphas.size()];
    const Kept before(mesh);
    const int edges = static_cast<int>(mesh::QuadMesh(mesh).n_edges());
    const double worst = least(mesh);
    reference::keep_boundary(mesh, {}, settings.tolerance);
    mesh.reset_origins();
    const auto begun = std::make_shared<const mesh::QuadMesh>(mesh);
    mesh.begun = begun;
    Outcome outcome;
    patch::GrowthPlan plan;
    plan.start = static_cast<int>(random() % static_cast<unsigned>(mesh.n_vertices()));
    plan.most = 10 + static_cast<int>(random() % 70);
    const std::vector<int> disk = patch::Growth(mesh).disk(plan);
    if (disk.empty() || random() % 2 == 0) {
        outcome = adapt_whole(mesh, alpha, settings, silent);
        ++tally.whole;
    } else {
        std::vector<Patch> patches(1);
        patches[0].faces = disk;
        outcome = adapt(mesh, patches, alpha, settings, silent)[0];
        tally.faults += outcome.fault ? 1 : 0;
    }
    mesh.begun.reset();
    mesh.check();
    EXPECT_EQ(before, Kept(mesh));
    expect_numbered(mesh);
    expect_on(mesh, *mesh.boundary);
    EXPECT_GT(least(mesh), std::min(0.0, worst));
    tally.changed += mesh.n_edges() != edges;
    tally.exact += !outcome.fault && outcome.faces_after == outcome.faces_wanted;
}

TEST(BoundaryCampaign, NumbersRunBetweenTheSameCorners) {
    std::mt19937 random(7);
    Tally tally;
    for (int run = 0; run < n_runs && !testing::Test::HasFailure(); ++run) {
        SCOPED_TRACE("run " + std::to_string(run));
        mesh::QuadMesh mesh = bent(random);
        decorate(mesh, random);
        adapt_once(mesh, random, tally);
        adapt_once(mesh, random, tally);
    }
    std::cout << tally.changed << " of " << 2 * n_runs << " changed, " << tally.exact << " exact, "
              << tally.whole << " whole meshes, " << tally.faults << " patches left\n";
    EXPECT_GT(tally.exact, 1.8 * n_runs);
}

} // namespace
} // namespace alphamst::adapt::samples
