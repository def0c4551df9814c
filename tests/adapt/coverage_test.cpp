#include "adapt/coverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "adapt/locate.h"
#include "eared.h"
#include "mesh/curved.h"
#include "mesh/reference.h"
#include "meshes.h"

namespace alphamst::adapt {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::vector<Quad> quads_of(const mesh::QuadMesh &mesh) {
    std::vector<Quad> quads;
    for (int f = 0; f < mesh.n_faces(); ++f)
        quads.push_back(quad_of(mesh, f));
    return quads;
}

// From the sample to the nearest of the quads.
double distance(const Coverage &coverage, int sample, const std::vector<Quad> &quads) {
    double least = HUGE_VAL;
    for (const Quad &quad : quads)
        least = std::min(least, nearest_spot(quad, coverage.point(sample)).distance);
    return std::sqrt(least);
}

// Every sample is with one face, once.
void expect_none_lost(const Coverage &coverage, std::size_t n) {
    std::multiset<int> all;
    for (int f = 0; f < coverage.faces(); ++f)
        all.insert(coverage.samples(f).begin(), coverage.samples(f).end());
    EXPECT_EQ(all.size(), n);
    EXPECT_EQ(std::set<int>(all.begin(), all.end()).size(), n);
}

// The eared ball without its ears: the same faces on a sphere.
std::vector<Quad> without_ears(const mesh::QuadMesh &mesh) {
    std::vector<Quad> quads = quads_of(mesh);
    for (Quad &quad : quads)
        for (Eigen::Vector3d &corner : quad)
            corner.normalize();
    return quads;
}

struct Eared {
    mesh::QuadMesh mesh = samples::eared(4);
    std::shared_ptr<const surface::Surface> surface = mesh::surface_of(mesh);
    std::vector<int> all = samples::all_faces(mesh);
    Coverage coverage{*surface, mesh, 1000000, 0.1};
};

void backward(std::size_t n, const std::function<void(std::size_t)> &work) {
    for (std::size_t i = n; i-- > 0;)
        work(i);
}

TEST(Coverage, SamplesBelongToTheNearestFace) {
    const auto surface = mesh::surface_of(samples::eared(3));
    const mesh::QuadMesh coarse = mesh::sphere(5);
    const Coverage coverage(*surface, coarse, 1000000, 0);
    const std::vector<Quad> quads = quads_of(coarse);
    ASSERT_EQ(coverage.faces(), coarse.n_faces());
    expect_none_lost(coverage, surface->points().size());
    for (int f = 0; f < coverage.faces(); ++f)
        for (const int s : coverage.samples(f)) {
            const double nearest = distance(coverage, s, quads);
            const double own = std::sqrt(nearest_spot(quads[at(f)], coverage.point(s)).distance);
            EXPECT_NEAR(own, nearest, 1e-12);
            EXPECT_NEAR(coverage.allowed(s), nearest, 1e-6 * nearest + 1e-12); // tolerance 0
        }
}

TEST(Coverage, SamplesAreSomePointsOfTheSurface) {
    const Eared eared;
    const std::size_t points = eared.surface->points().size();
    for (const std::size_t most : {std::size_t(100), points - 1, points, points + 1}) {
        const Coverage coverage(*eared.surface, eared.mesh, most, 0.1);
        const std::size_t n = std::min(most, points);
        expect_none_lost(coverage, n);
        std::set<std::array<double, 3>> different;
        for (std::size_t s = 0; s < n; ++s) {
            const Eigen::Vector3d &p = coverage.point(static_cast<int>(s));
            different.insert({p.x(), p.y(), p.z()});
            EXPECT_EQ(eared.surface->nearest(p).distance, 0);
        }
        EXPECT_EQ(different.size(), n);
    }
}

TEST(Coverage, OfAMeshThatIsTheSurfaceIsComplete) {
    Eared eared;
    eared.coverage.set_tolerance(1e-6);
    EXPECT_TRUE(eared.coverage.complete());
    const auto owners = eared.coverage.cover(eared.all, quads_of(eared.mesh));
    ASSERT_TRUE(owners);
    EXPECT_EQ(owners->size(), eared.surface->points().size());
}

TEST(Coverage, CoversAsFarAsAsked) {
    const Eared eared;
    const std::vector<Quad> quads = without_ears(eared.mesh);
    double farthest = 0;
    for (std::size_t s = 0; s < eared.surface->points().size(); ++s)
        farthest = std::max(farthest, distance(eared.coverage, static_cast<int>(s), quads));
    ASSERT_GT(farthest, 2 * eared.coverage.tolerance());
    const double part = farthest / eared.coverage.tolerance();
    EXPECT_FALSE(eared.coverage.covers(eared.all, quads, 1));
    EXPECT_FALSE(eared.coverage.covers(eared.all, quads, 0.99 * part));
    EXPECT_TRUE(eared.coverage.covers(eared.all, quads, 1.01 * part));
    EXPECT_TRUE(eared.coverage.covers(eared.all, quads_of(eared.mesh), 1e-6));
    EXPECT_TRUE(eared.coverage.covers({}, quads, 0.1));
}

TEST(Coverage, NewOwnersAreTheNearestQuads) {
    const Eared eared;
    mesh::QuadMesh moved = eared.mesh;
    std::mt19937 random(2);
    for (int v = 0; v < moved.n_vertices(); ++v)
        for (std::size_t k = 0; k < 3; ++k) {
            OpenMesh::Vec3d p = moved.point(v);
            p[k] += 0.05 * (samples::chance(random) - 0.5);
            moved.set_point(v, p);
        }
    const std::vector<Quad> quads = quads_of(moved);
    const auto owners = eared.coverage.cover(eared.all, quads);
    ASSERT_TRUE(owners);
    std::set<int> samples;
    for (const Coverage::Owner &owner : *owners) {
        samples.insert(owner.sample);
        const double nearest = distance(eared.coverage, owner.sample, quads);
        const Eigen::Vector3d &p = eared.coverage.point(owner.sample);
        EXPECT_NEAR(std::sqrt(nearest_spot(quads[at(owner.quad)], p).distance), nearest, 1e-12);
        EXPECT_NEAR(owner.distance, nearest, 1e-6);
    }
    EXPECT_EQ(samples.size(), eared.surface->points().size());
}

TEST(Coverage, WithoutAnEarIsRefused) {
    const Eared eared;
    const std::vector<Quad> round = without_ears(eared.mesh);
    EXPECT_FALSE(eared.coverage.cover(eared.all, round));

    std::vector<int> missed;
    const auto owners = eared.coverage.cover(eared.all, round, &missed);
    ASSERT_TRUE(owners);
    std::set<int> wanted, kept;
    for (const int f : eared.all)
        for (const int s : eared.coverage.samples(f))
            if (distance(eared.coverage, s, round) > eared.coverage.allowed(s))
                wanted.insert(f);
    EXPECT_GT(wanted.size(), 10u);
    EXPECT_LT(10 * wanted.size(), 4 * eared.all.size());
    EXPECT_EQ(std::set<int>(missed.begin(), missed.end()), wanted);
    EXPECT_EQ(missed.size(), wanted.size());
    for (const Coverage::Owner &owner : *owners) {
        EXPECT_TRUE(kept.insert(owner.sample).second);
        EXPECT_LE(owner.distance, eared.coverage.allowed(owner.sample));
    }
    std::vector<int> rest;
    std::copy_if(eared.all.begin(), eared.all.end(), std::back_inserter(rest),
                 [&](int f) { return !wanted.count(f); });
    for (const int f : rest)
        for (const int s : eared.coverage.samples(f))
            EXPECT_TRUE(kept.count(s));

    // The other faces are covered as they are; so are all, if that is near enough.
    EXPECT_TRUE(eared.coverage.cover(rest, round));
    Coverage lenient = eared.coverage;
    lenient.set_tolerance(1);
    EXPECT_TRUE(lenient.cover(eared.all, round));
}

TEST(Coverage, ASampleThatWasFarMayStayAsFar) {
    const Eared eared;
    const mesh::QuadMesh ball = mesh::sphere(8);
    const std::vector<int> all = samples::all_faces(ball);
    const Coverage coverage(*eared.surface, ball, 1000000, 0.01); // never had the ears
    EXPECT_FALSE(coverage.complete());
    EXPECT_TRUE(coverage.cover(all, quads_of(ball)));
    std::vector<Quad> smaller = quads_of(ball);
    for (Quad &quad : smaller)
        for (Eigen::Vector3d &corner : quad)
            corner *= 0.98;
    EXPECT_FALSE(coverage.cover(all, smaller));
}

TEST(Coverage, DoesNotDependOnHowItIsRun) {
    const Eared eared;
    // Several pieces, and the last one is not full.
    const std::vector<int> faces(eared.all.begin(), eared.all.end() - 100);
    ASSERT_GT(faces.size(), 600u);
    ASSERT_NE(faces.size() % 256, 0u);
    const auto forward = [](std::size_t n, const std::function<void(std::size_t)> &work) {
        for (std::size_t i = 0; i < n; ++i)
            work(i);
    };
    for (const std::vector<Quad> &quads : {quads_of(eared.mesh), without_ears(eared.mesh)}) {
        std::vector<int> missed;
        const auto owners = eared.coverage.cover(faces, quads, &missed);
        ASSERT_TRUE(owners);
        for (const geometry::Run &run : {geometry::Run(forward), geometry::Run(backward)}) {
            std::vector<int> also_missed;
            const auto others = eared.coverage.cover(faces, quads, &also_missed, run);
            ASSERT_TRUE(others);
            EXPECT_EQ(also_missed, missed);
            ASSERT_EQ(others->size(), owners->size());
            for (std::size_t i = 0; i < owners->size(); ++i) {
                EXPECT_EQ((*others)[i].sample, (*owners)[i].sample);
                EXPECT_EQ((*others)[i].quad, (*owners)[i].quad);
                EXPECT_EQ((*others)[i].distance, (*owners)[i].distance);
            }
            EXPECT_EQ(eared.coverage.cover(faces, quads, nullptr, run).has_value(), missed.empty());
        }
    }
}

TEST(Coverage, NoSampleIsLostWhenFacesAreReplaced) {
    Eared eared;
    Coverage &coverage = eared.coverage;
    const std::size_t n = eared.surface->points().size();
    const std::vector<Quad> quads = quads_of(eared.mesh);
    std::size_t samples = 0;
    const std::vector<int> old{3, 17, 40, 41};
    for (const int f : old)
        samples += coverage.samples(f).size();
    ASSERT_GT(samples, 0u);
    // The same quads, in other places: first more faces, then fewer, the last ones in their gaps.
    const int faces = coverage.faces();
    const std::vector<Quad> at_them{quads[3], quads[17], quads[40], quads[41]};
    const auto owners = coverage.cover(old, at_them);
    ASSERT_TRUE(owners);
    EXPECT_EQ(owners->size(), samples);
    coverage.resize(faces + 2);
    EXPECT_TRUE(coverage.samples(faces).empty());
    coverage.assign(old, *owners, std::vector{faces, 41, faces + 1, 3});
    expect_none_lost(coverage, n);
    EXPECT_TRUE(coverage.samples(17).empty());
    EXPECT_TRUE(coverage.samples(40).empty());
    for (const auto &[face, quad] : {std::pair(faces, 3), {41, 17}, {faces + 1, 40}, {3, 41}})
        for (const int s : coverage.samples(face))
            EXPECT_LT(nearest_spot(quads[at(quad)], coverage.point(s)).distance, 1e-20);

    const std::vector<int> last = coverage.samples(faces + 1);
    coverage.move(faces + 1, 17);
    coverage.move(faces, 40);
    coverage.resize(faces);
    EXPECT_EQ(coverage.faces(), faces);
    EXPECT_EQ(coverage.samples(17), last);
    expect_none_lost(coverage, n);
}

TEST(Coverage, AssignRemembersHowFarSamplesAre) {
    Eared eared;
    std::vector<Quad> smaller = quads_of(eared.mesh);
    for (Quad &quad : smaller)
        for (Eigen::Vector3d &corner : quad)
            corner *= 0.95;
    const auto owners = eared.coverage.cover(eared.all, smaller);
    ASSERT_TRUE(owners);
    EXPECT_TRUE(eared.coverage.complete());
    eared.coverage.assign(eared.all, *owners, eared.all);
    EXPECT_TRUE(eared.coverage.complete());
    eared.coverage.set_tolerance(0.03);
    EXPECT_FALSE(eared.coverage.complete());
    for (const Coverage::Owner &owner : *owners)
        EXPECT_DOUBLE_EQ(eared.coverage.allowed(owner.sample), std::max(0.03, double(owner.distance)));
}

TEST(Coverage, IsForTheEdgesOfTheWantedFaces) {
    const Eared eared;
    for (const std::int64_t wanted : {50, 100000}) {
        const Coverage coverage = coverage_of(eared.mesh, *eared.surface, wanted, 0.6);
        EXPECT_DOUBLE_EQ(coverage.tolerance(),
                         0.6 * std::sqrt(eared.surface->area() / static_cast<double>(wanted)));
        expect_none_lost(coverage,
                         std::min<std::size_t>(5 * at(int(wanted)), eared.surface->points().size()));
    }
}

} // namespace
} // namespace alphamst::adapt
