#include "run.h"

namespace alphamst::adapt::samples {
namespace {

std::int64_t singular(const mesh::QuadMesh &mesh) {
    return static_cast<std::int64_t>(mesh.singularities().size());
}

// The points of the mesh boundary, in the order of their coordinates.
std::set<std::array<double, 3>> buffer(const mesh::QuadMesh &mesh) {
    std::set<std::array<double, 3>> points;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        if (!mesh.isolated(v) && mesh.on_boundary(v))
            points.insert({mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]});
    return points;
}

TEST(Whole, DeliversTheFacesAndFewSingularities) {
    for (const double alpha : {0.8, 1.0, 1.5, 2.0}) {
        const mesh::QuadMesh before = unstructured(16, 7);
        mesh::QuadMesh mesh = before;
        const Outcome outcome = adapt_whole(mesh, alpha, {}, silent);
        EXPECT_NO_THROW(mesh.check());
        EXPECT_EQ(mesh.n_faces(), std::llround(alpha * before.n_faces())) << alpha << " " << outcome.text;
        EXPECT_EQ(outcome.faces_after, mesh.n_faces());
        EXPECT_EQ(outcome.singular_before, singular(before));
        EXPECT_EQ(outcome.singular_after, singular(mesh));
        EXPECT_LT(4 * singular(mesh), singular(before)) << alpha;
        EXPECT_EQ(buffer(mesh), buffer(before));
        EXPECT_GT(least_scaled_jacobian(mesh, all_faces(mesh)), 0.25) << alpha;
        EXPECT_NEAR(outcome.quality_after, least_scaled_jacobian(mesh, all_faces(mesh)), 1e-9);
    }
}

TEST(Whole, ReductionKeepsTheFacesWithinAFewPercent) {
    const mesh::QuadMesh before = unstructured(20, 3);
    mesh::QuadMesh mesh = before;
    const Outcome outcome = reduce_whole(mesh, {}, silent);
    EXPECT_NO_THROW(mesh.check());
    EXPECT_LT(4 * singular(mesh), singular(before));
    EXPECT_NEAR(mesh.n_faces(), before.n_faces(), 0.04 * before.n_faces());
    EXPECT_EQ(outcome.singular_after, singular(mesh));
}

TEST(Whole, NothingIsDoneWhereNothingIsToGain) {
    const mesh::QuadMesh before = grid(12, 9);
    mesh::QuadMesh mesh = before;
    const Outcome outcome = adapt_whole(mesh, 1, {}, silent);
    EXPECT_EQ(outcome.singular_after, 0);
    EXPECT_EQ(mesh.checksum(), before.checksum());
}

TEST(Whole, ARegularMeshIsRefinedAndSimplified) {
    for (const double alpha : {0.7, 1.3, 2.0}) {
        mesh::QuadMesh mesh = grid(24, 20);
        const Outcome outcome = adapt_whole(mesh, alpha, {}, silent);
        EXPECT_NO_THROW(mesh.check());
        EXPECT_EQ(mesh.n_faces(), std::llround(alpha * 480)) << outcome.text;
        EXPECT_LE(singular(mesh), 40) << alpha;
    }
}

TEST(Whole, EqualOnAnyNumberOfThreads) {
    std::set<std::uint64_t> digests;
    for (const int threads : {1, 2, 8}) {
        mesh::QuadMesh mesh = unstructured(20, 5);
        Settings settings;
        settings.threads = threads;
        adapt_whole(mesh, 1.2, settings, silent);
        digests.insert(mesh.checksum());
    }
    EXPECT_EQ(digests.size(), 1u);
}

TEST(Whole, OtherSeedsGiveOtherMeshes) {
    std::set<std::uint64_t> digests;
    for (const std::uint64_t seed : {1, 2, 3}) {
        mesh::QuadMesh mesh = unstructured(34, 5); // no piece, which has one best filling
        Settings settings;
        settings.seed = seed;
        adapt_whole(mesh, 1, settings, silent);
        digests.insert(mesh.checksum());
    }
    EXPECT_GT(digests.size(), 1u);
}

TEST(Whole, WithLessEffortFewerWindowsAreTried) {
    std::vector<int> calls;
    for (const double effort : {0.05, 1.0}) {
        mesh::QuadMesh mesh = unstructured(34, 5);
        Settings settings;
        settings.effort = effort;
        int count = 0;
        const Outcome outcome = adapt_whole(mesh, 1, settings, [&](double, const char *) { ++count; });
        EXPECT_EQ(outcome.faces_after, outcome.faces_wanted);
        EXPECT_LT(outcome.singular_after, outcome.singular_before);
        calls.push_back(count);
    }
    EXPECT_LT(calls[0], calls[1]);
}

TEST(Whole, ClockwiseAndTiltedMeshesAreDone) {
    const mesh::QuadMesh sample = unstructured(14, 9);
    std::vector<double> points;
    std::vector<std::int32_t> faces, clockwise;
    for (int v = 0; v < sample.n_vertices(); ++v) {
        const auto &p = sample.point(v);
        points.insert(points.end(), {p[0], 0.6 * p[1], 0.8 * p[1]});
    }
    for (const auto &q : sample.faces()) {
        faces.insert(faces.end(), q.begin(), q.end());
        clockwise.insert(clockwise.end(), q.rbegin(), q.rend());
    }
    mesh::QuadMesh tilted = mesh::QuadMesh::build(3, points, faces);
    adapt_whole(tilted, 1.5, {}, silent);
    EXPECT_EQ(tilted.n_faces(), std::llround(1.5 * sample.n_faces()));
    EXPECT_LT(3 * singular(tilted), singular(sample));
    for (int v = 0; v < tilted.n_vertices(); ++v)
        EXPECT_NEAR(0.8 * tilted.point(v)[1], 0.6 * tilted.point(v)[2], 1e-9);
    for (std::size_t v = 0; v < points.size() / 3; ++v)
        points[3 * v + 2] = 0;
    mesh::QuadMesh below = mesh::QuadMesh::build(2, points, clockwise);
    adapt_whole(below, 1, {}, silent);
    EXPECT_EQ(below.n_faces(), sample.n_faces());
    EXPECT_LT(3 * singular(below), singular(sample));
}

TEST(Whole, CanBeCancelledAnywhere) {
    for (int stop = 0; stop < 40; stop += 3) {
        mesh::QuadMesh mesh = unstructured(12, 5);
        int calls = 0;
        double last = 0;
        bool cancelled = false;
        try {
            adapt_whole(mesh, 1.5, {}, [&](double fraction, const char *) {
                EXPECT_GE(fraction, 0);
                EXPECT_LE(fraction, 1);
                last = fraction;
                if (calls++ == stop)
                    throw Failure(Fault::cancelled, "stop");
            });
        } catch (const Failure &failure) {
            cancelled = failure.fault == Fault::cancelled;
        }
        EXPECT_TRUE(cancelled || last == 1);
    }
}

// Flagged faces, edges and vertices stay what and where they are.
TEST(Whole, FixedFacesAndFeaturesStay) {
    mesh::QuadMesh mesh = unstructured(16, 21);
    std::set<std::array<double, 8>> kept;
    const auto shape = [](const mesh::QuadMesh &m, int f) {
        std::array<double, 8> points{};
        for (std::size_t k = 0; k < 4; ++k) {
            points[2 * k] = m.point(m.corners(f)[k])[0];
            points[2 * k + 1] = m.point(m.corners(f)[k])[1];
        }
        return points;
    };
    for (int f = 0; f < mesh.n_faces(); f += 37) {
        mesh.face_flags[static_cast<std::size_t>(f)] = mesh::fixed;
        kept.insert(shape(mesh, f));
    }
    adapt_whole(mesh, 1, {}, silent);
    for (int f = 0; f < mesh.n_faces(); ++f)
        if (mesh.face_flags[static_cast<std::size_t>(f)] == mesh::fixed) {
            EXPECT_EQ(kept.erase(shape(mesh, f)), 1u);
        }
    EXPECT_TRUE(kept.empty());
}

TEST(Whole, TheSizeFieldSaysWhereTheFacesGo) {
    mesh::QuadMesh mesh = unstructured(48, 4);
    auto size = std::make_shared<mesh::Field>();
    size->name = "size";
    double middle = 0;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        middle += mesh.point(v)[0] / mesh.n_vertices();
    for (int v = 0; v < mesh.n_vertices(); ++v)
        size->values.push_back(mesh.point(v)[0] < middle ? 1 : 1.6);
    mesh.fields.set(size);
    const auto left = [&] {
        int count = 0;
        for (const auto &q : mesh.faces())
            count += mesh.point(q[0])[0] < middle;
        return static_cast<double>(count) / mesh.n_faces();
    };
    const double before = left();
    const int faces = mesh.n_faces();
    adapt_whole(mesh, 1.5, {}, silent);
    EXPECT_EQ(mesh.n_faces(), std::llround(1.5 * faces));
    EXPECT_GT(left(), before + 0.06);
}

} // namespace
} // namespace alphamst::adapt::samples
