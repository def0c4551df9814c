#include "adapt/off_size.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "adapt/adapt.h"
#include "adapt/run.h"
#include "geometry/quad.h"
#include "index.h"
#include "reference/locate.h"
#include "reference/projection.h"
#include "transfer/carry.h"

namespace alphamst::adapt {
namespace {

using namespace samples;

constexpr int n = 40;
constexpr double band = 0.7;

Settings by_band() {
    Settings settings;
    settings.size_band = band;
    return settings;
}

using Size = std::function<double(double x, double y)>;

// Half as long near a place that moves.
Size spot(double x0, double y0) {
    return [=](double x, double y) {
        const double away = std::hypot(x - x0, y - y0);
        return away < 5 ? 0.5 : away < 11 ? 0.5 + (away - 5) / 12 : 1.0;
    };
}

void want(mesh::QuadMesh &mesh, const Size &size) {
    std::vector<double> values;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        values.push_back(size(mesh.point(v)[0], mesh.point(v)[1]));
    mesh.fields.set(std::make_shared<mesh::Field>(
        mesh::Field{Entity::vertex, "size", 1, mesh::Carry::linear, std::move(values)}));
}

// As the C interface does it: fields come along.
Outcome adapted(mesh::QuadMesh &mesh, double alpha = 1, const Settings &settings = by_band()) {
    const mesh::QuadMesh before = mesh;
    mesh.reset_origins();
    mesh.begun = std::make_shared<const mesh::QuadMesh>(before);
    if (settings.edit_boundary)
        reference::keep_boundary(mesh, {}, settings.tolerance);
    const Outcome outcome = adapt_whole(mesh, alpha, settings, silent);
    transfer::carry(before, mesh, silent);
    mesh.begun.reset();
    mesh.check();
    return outcome;
}

double wanted_faces(const mesh::QuadMesh &mesh, const Size &size) {
    double sum = 0;
    for (int f = 0; f < mesh.n_faces(); ++f) {
        const geometry::Quad quad = reference::quad_of(mesh, f);
        const Eigen::Vector3d middle = (quad[0] + quad[1] + quad[2] + quad[3]) / 4;
        sum += geometry::area_vector(quad).norm() / std::pow(size(middle.x(), middle.y()), 2);
    }
    return sum;
}

TEST(OffSize, NothingIsTouchedWhereSizesAreRight) {
    mesh::QuadMesh mesh = grid(n, n);
    want(mesh, [](double x, double) { return 1 + 0.004 * x; });
    EXPECT_TRUE(faces_off_size(mesh, 1, by_band()).empty());
    const std::uint64_t before = mesh.checksum();
    const Outcome outcome = adapted(mesh);
    EXPECT_EQ(outcome.faces_wanted, n * n);
    EXPECT_EQ(mesh.checksum(), before);
}

TEST(OffSize, OnlyThePlaceThatIsOffChangesAndOnce) {
    mesh::QuadMesh mesh = grid(n, n);
    const Size size = spot(20, 20);
    want(mesh, size);
    const std::vector<int> faces = faces_off_size(mesh, 1, by_band());
    EXPECT_GT(faces.size(), 100u);
    EXPECT_LT(faces.size(), at(n * n / 2));
    const mesh::QuadMesh before = mesh;
    const Outcome outcome = adapted(mesh);
    EXPECT_EQ(outcome.faces_after, mesh.n_faces());
    EXPECT_NEAR(static_cast<double>(outcome.faces_after), wanted_faces(mesh, size), 0.05 * n * n);
    EXPECT_LT(outcome.size_error_after, 0.5 * outcome.size_error_before);
    EXPECT_GT(outcome.quality_after, 0.3);
    std::size_t kept = 0;
    for (int f = 0; f < mesh.n_faces(); ++f)
        kept += mesh.face_origin[at(f)] >= 0;
    EXPECT_GE(kept, at(before.n_faces()) - faces.size());
    for (int f = 0; f < mesh.n_faces(); ++f)
        if (const int old = mesh.face_origin[at(f)]; old >= 0)
            for (std::size_t k = 0; k < 4; ++k) {
                const int v = mesh.corners(f)[k], was = before.corners(old)[k];
                EXPECT_EQ(mesh.vertex_origin[at(v)], was);
                if (!std::ranges::binary_search(faces, old)) {
                    EXPECT_EQ(mesh.point(v), before.point(was));
                }
            }
    for (const bool anew : {false, true}) { // as it came along, and as the caller says it again
        if (anew)
            want(mesh, size);
        const std::uint64_t digest = mesh.checksum();
        adapted(mesh);
        EXPECT_EQ(mesh.checksum(), digest);
    }
}

TEST(OffSize, AlphaIsHowDenseTheFieldIsMeant) {
    mesh::QuadMesh mesh = grid(n / 2, n / 2);
    want(mesh, [](double, double) { return 1.0; });
    const Outcome outcome = adapted(mesh, 4);
    EXPECT_EQ(outcome.faces_wanted, n * n);
    EXPECT_EQ(mesh.n_faces(), n * n);
    mesh::QuadMesh coarse = mesh;
    want(coarse, [](double, double) { return 1.0; });
    adapted(coarse, 1);
    EXPECT_LT(coarse.n_faces(), n * n / 2);
}

// A front that goes there and back leaves few singular vertices, and as many faces as before.
TEST(OffSize, FollowsAFront) {
    mesh::QuadMesh mesh = grid(n, n);
    std::int64_t most = 0;
    for (int step = 0; step < 12; ++step) {
        const double x = 12 + 16 * (1 - std::abs(step - 6) / 6.0);
        const Size size = spot(x, 20);
        want(mesh, size);
        const Outcome outcome = adapted(mesh);
        EXPECT_GT(outcome.quality_after, 0.2) << step;
        EXPECT_NEAR(mesh.n_faces(), wanted_faces(mesh, size), 0.1 * mesh.n_faces()) << step;
        most = std::max(most, outcome.singular_after);
    }
    EXPECT_LE(most, 40);
}

// Two places whose faces meet at one vertex: all around that comes along.
TEST(OffSize, PlacesMayTouch) {
    mesh::QuadMesh mesh = grid(n, n);
    want(mesh, [](double x, double y) { return (x < 12 && y < 12) || (x > 28 && y > 28) ? 0.5 : 1.0; });
    adapted(mesh);
    for (const double reach : {17.0, 20.0}) {
        mesh::QuadMesh touching = grid(n, n);
        want(touching, [&](double x, double y) {
            return (x < reach && y < reach) || (x > n - reach && y > n - reach) ? 0.6 : 1.0;
        });
        EXPECT_GT(adapted(touching).quality_after, 0.1) << reach;
    }
}

// A front along a wall: vertices come and go there, too, and the wall stays where it is.
TEST(OffSize, FollowsAFrontAlongTheBoundary) {
    Settings edits = by_band();
    edits.edit_boundary = true;
    mesh::QuadMesh mesh = grid(n, n);
    mesh.edge_marker.assign(at(mesh.n_edges()), 0);
    for (int e = 0; e < mesh.n_edges(); ++e) {
        const auto [v, w] = mesh.edge_vertices(e);
        if (mesh.point(v)[1] + mesh.point(w)[1] == 0)
            mesh.edge_marker[at(e)] = 3;
    }
    for (int step = 0; step < 8; ++step) {
        const Size size = spot(6 + 28 * (1 - std::abs(step - 4) / 4.0), 0);
        want(mesh, size);
        const Outcome outcome = adapted(mesh, 1, edits);
        EXPECT_GT(outcome.quality_after, 0.2) << step;
        EXPECT_LE(outcome.singular_after, 24) << step;
        EXPECT_NEAR(mesh.n_faces(), wanted_faces(mesh, size), 0.05 * mesh.n_faces()) << step;
        double area = 0, wall = 0, error = 0;
        int edges = 0;
        for (int f = 0; f < mesh.n_faces(); ++f)
            area += geometry::area_vector(reference::quad_of(mesh, f)).norm();
        for (int e = 0; e < mesh.n_edges(); ++e) {
            if (mesh.edge_marker[at(e)] != 3)
                continue;
            const auto [v, w] = mesh.edge_vertices(e);
            const double length = std::abs(mesh.point(w)[0] - mesh.point(v)[0]);
            EXPECT_EQ(mesh.point(v)[1] + mesh.point(w)[1], 0);
            const double off = std::log2(length / size((mesh.point(v)[0] + mesh.point(w)[0]) / 2, 0));
            wall += length;
            error += off * off;
            ++edges;
        }
        EXPECT_NEAR(area, n * n, 1e-9) << step;
        EXPECT_NEAR(wall, n, 1e-12) << step;
        EXPECT_LT(std::sqrt(error / edges), 0.35) << step;
        const std::uint64_t digest = mesh.checksum();
        adapted(mesh, 1, edits);
        EXPECT_EQ(mesh.checksum(), digest) << step;
    }
}

TEST(OffSize, IsForPlaneMeshesWithSizes) {
    mesh::QuadMesh mesh = grid(4, 4);
    EXPECT_FALSE(goes_by_band(mesh, by_band()));
    want(mesh, spot(2, 2));
    EXPECT_TRUE(goes_by_band(mesh, by_band()));
    EXPECT_FALSE(goes_by_band(mesh, {}));
    mesh::QuadMesh flat = grid(4, 4, 3);
    want(flat, spot(2, 2));
    EXPECT_TRUE(goes_by_band(flat, by_band()));
    flat.set_point(12, flat.point(12) + OpenMesh::Vec3d(0, 0, 1));
    EXPECT_FALSE(goes_by_band(flat, by_band()));
}

} // namespace
} // namespace alphamst::adapt
