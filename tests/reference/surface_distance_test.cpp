#include "reference/surface_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "adapt/eared.h"
#include "adapt/meshes.h"
#include "mesh/curved.h"
#include "reference/locate.h"
#include "reference/surface_of.h"

namespace alphamst::reference {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::vector<geometry::Quad> quads_of(const mesh::QuadMesh &mesh) {
    std::vector<geometry::Quad> quads;
    for (int f = 0; f < mesh.n_faces(); ++f)
        quads.push_back(quad_of(mesh, f));
    return quads;
}

// From the sample to the nearest of the quads.
double distance(const SurfaceDistance &surface_distance, int sample,
                const std::vector<geometry::Quad> &quads) {
    double least = HUGE_VAL;
    for (const geometry::Quad &quad : quads)
        least = std::min(least, geometry::closest_point(quad, surface_distance.point(sample)).distance);
    return std::sqrt(least);
}

// Every sample is with one face, once.
void expect_none_lost(const SurfaceDistance &surface_distance, std::size_t n) {
    std::multiset<int> all;
    for (int f = 0; f < surface_distance.faces(); ++f)
        all.insert(surface_distance.samples(f).begin(), surface_distance.samples(f).end());
    EXPECT_EQ(all.size(), n);
    EXPECT_EQ(std::set<int>(all.begin(), all.end()).size(), n);
}

// The eared ball without its ears: the same faces on a sphere.
std::vector<geometry::Quad> without_ears(const mesh::QuadMesh &mesh) {
    std::vector<geometry::Quad> quads = quads_of(mesh);
    for (geometry::Quad &quad : quads)
        for (Eigen::Vector3d &corner : quad)
            corner.normalize();
    return quads;
}

struct Eared {
    mesh::QuadMesh mesh = adapt::samples::eared(4);
    std::shared_ptr<const surface::Surface> surface = reference::surface_of(mesh);
    std::vector<int> all = adapt::samples::all_faces(mesh);
    SurfaceDistance surface_distance{*surface, mesh, 1000000, 0.1};
};

void backward(std::size_t n, const std::function<void(std::size_t)> &work) {
    for (std::size_t i = n; i-- > 0;)
        work(i);
}

TEST(SurfaceDistance, SamplesBelongToTheNearestFace) {
    const auto surface = reference::surface_of(adapt::samples::eared(3));
    const mesh::QuadMesh coarse = mesh::sphere(5);
    const SurfaceDistance surface_distance(*surface, coarse, 1000000, 0);
    const std::vector<geometry::Quad> quads = quads_of(coarse);
    ASSERT_EQ(surface_distance.faces(), coarse.n_faces());
    expect_none_lost(surface_distance, surface->points().size());
    for (int f = 0; f < surface_distance.faces(); ++f)
        for (const int s : surface_distance.samples(f)) {
            const double nearest = distance(surface_distance, s, quads);
            const double own =
                std::sqrt(geometry::closest_point(quads[at(f)], surface_distance.point(s)).distance);
            EXPECT_NEAR(own, nearest, 1e-12);
            EXPECT_NEAR(surface_distance.allowed(s), nearest, 1e-6 * nearest + 1e-12); // tolerance 0
        }
}

TEST(SurfaceDistance, SamplesAreSomePointsOfTheSurface) {
    const Eared eared;
    const std::size_t points = eared.surface->points().size();
    for (const std::size_t most : {std::size_t(100), points - 1, points, points + 1}) {
        const SurfaceDistance surface_distance(*eared.surface, eared.mesh, most, 0.1);
        const std::size_t n = std::min(most, points);
        expect_none_lost(surface_distance, n);
        std::set<std::array<double, 3>> different;
        for (std::size_t s = 0; s < n; ++s) {
            const Eigen::Vector3d &p = surface_distance.point(static_cast<int>(s));
            different.insert({p.x(), p.y(), p.z()});
            EXPECT_EQ(eared.surface->nearest(p).distance, 0);
        }
        EXPECT_EQ(different.size(), n);
    }
}

TEST(SurfaceDistance, OfAMeshThatIsTheSurfaceIsComplete) {
    Eared eared;
    eared.surface_distance.set_tolerance(1e-6);
    EXPECT_TRUE(eared.surface_distance.complete());
    const auto owners = eared.surface_distance.cover(eared.all, quads_of(eared.mesh));
    ASSERT_TRUE(owners);
    EXPECT_EQ(owners->size(), eared.surface->points().size());
}

TEST(SurfaceDistance, CoversAsFarAsAsked) {
    const Eared eared;
    const std::vector<geometry::Quad> quads = without_ears(eared.mesh);
    double farthest = 0;
    for (std::size_t s = 0; s < eared.surface->points().size(); ++s)
        farthest = std::max(farthest, distance(eared.surface_distance, static_cast<int>(s), quads));
    ASSERT_GT(farthest, 2 * eared.surface_distance.tolerance());
    const double part = farthest / eared.surface_distance.tolerance();
    EXPECT_FALSE(eared.surface_distance.covers(eared.all, quads, 1));
    EXPECT_FALSE(eared.surface_distance.covers(eared.all, quads, 0.99 * part));
    EXPECT_TRUE(eared.surface_distance.covers(eared.all, quads, 1.01 * part));
    EXPECT_TRUE(eared.surface_distance.covers(eared.all, quads_of(eared.mesh), 1e-6));
    EXPECT_TRUE(eared.surface_distance.covers({}, quads, 0.1));
}

TEST(SurfaceDistance, NewOwnersAreTheNearestQuads) {
    const Eared eared;
    mesh::QuadMesh moved = eared.mesh;
    std::mt19937 random(2);
    for (int v = 0; v < moved.n_vertices(); ++v)
        for (std::size_t k = 0; k < 3; ++k) {
            OpenMesh::Vec3d p = moved.point(v);
            p[k] += 0.05 * (adapt::samples::chance(random) - 0.5);
            moved.set_point(v, p);
        }
    const std::vector<geometry::Quad> quads = quads_of(moved);
    const auto owners = eared.surface_distance.cover(eared.all, quads);
    ASSERT_TRUE(owners);
    std::set<int> samples;
    for (const SurfaceDistance::Owner &owner : *owners) {
        samples.insert(owner.sample);
        const double nearest = distance(eared.surface_distance, owner.sample, quads);
        const Eigen::Vector3d &p = eared.surface_distance.point(owner.sample);
        EXPECT_NEAR(std::sqrt(geometry::closest_point(quads[at(owner.quad)], p).distance), nearest, 1e-12);
        EXPECT_NEAR(owner.distance, nearest, 1e-6);
    }
    EXPECT_EQ(samples.size(), eared.surface->points().size());
}

TEST(SurfaceDistance, WithoutAnEarIsRefused) {
    const Eared eared;
    const std::vector<geometry::Quad> round = without_ears(eared.mesh);
    EXPECT_FALSE(eared.surface_distance.cover(eared.all, round));

    std::vector<int> missed;
    const auto owners = eared.surface_distance.cover(eared.all, round, &missed);
    ASSERT_TRUE(owners);
    std::set<int> wanted, kept;
    for (const int f : eared.all)
        for (const int s : eared.surface_distance.samples(f))
            if (distance(eared.surface_distance, s, round) > eared.surface_distance.allowed(s))
                wanted.insert(f);
    EXPECT_GT(wanted.size(), 10u);
    EXPECT_LT(10 * wanted.size(), 4 * eared.all.size());
    EXPECT_EQ(std::set<int>(missed.begin(), missed.end()), wanted);
    EXPECT_EQ(missed.size(), wanted.size());
    for (const SurfaceDistance::Owner &owner : *owners) {
        EXPECT_TRUE(kept.insert(owner.sample).second);
        EXPECT_LE(owner.distance, eared.surface_distance.allowed(owner.sample));
    }
    std::vector<int> rest;
    std::copy_if(eared.all.begin(), eared.all.end(), std::back_inserter(rest),
                 [&](int f) { return !wanted.count(f); });
    for (const int f : rest)
        for (const int s : eared.surface_distance.samples(f))
            EXPECT_TRUE(kept.count(s));

    // The other faces are covered as they are; so are all, if that is near enough.
    EXPECT_TRUE(eared.surface_distance.cover(rest, round));
    SurfaceDistance lenient = eared.surface_distance;
    lenient.set_tolerance(1);
    EXPECT_TRUE(lenient.cover(eared.all, round));
}

TEST(SurfaceDistance, ASampleThatWasFarMayStayAsFar) {
    const Eared eared;
    const mesh::QuadMesh ball = mesh::sphere(8);
    const std::vector<int> all = adapt::samples::all_faces(ball);
    const SurfaceDistance surface_distance(*eared.surface, ball, 1000000, 0.01); // never had the ears
    EXPECT_FALSE(surface_distance.complete());
    EXPECT_TRUE(surface_distance.cover(all, quads_of(ball)));
    std::vector<geometry::Quad> smaller = quads_of(ball);
    for (geometry::Quad &quad : smaller)
        for (Eigen::Vector3d &corner : quad)
            corner *= 0.98;
    EXPECT_FALSE(surface_distance.cover(all, smaller));
}

TEST(SurfaceDistance, DoesNotDependOnHowItIsRun) {
    const Eared eared;
    // Several pieces, and the last one is not full.
    const std::vector<int> faces(eared.all.begin(), eared.all.end() - 100);
    ASSERT_GT(faces.size(), 600u);
    ASSERT_NE(faces.size() % 256, 0u);
    const auto forward = [](std::size_t n, const std::function<void(std::size_t)> &work) {
        for (std::size_t i = 0; i < n; ++i)
            work(i);
    };
    for (const std::vector<geometry::Quad> &quads : {quads_of(eared.mesh), without_ears(eared.mesh)}) {
        std::vector<int> missed;
        const auto owners = eared.surface_distance.cover(faces, quads, &missed);
        ASSERT_TRUE(owners);
        for (const geometry::Run &run : {geometry::Run(forward), geometry::Run(backward)}) {
            std::vector<int> also_missed;
            const auto others = eared.surface_distance.cover(faces, quads, &also_missed, run);
            ASSERT_TRUE(others);
            EXPECT_EQ(also_missed, missed);
            ASSERT_EQ(others->size(), owners->size());
            for (std::size_t i = 0; i < owners->size(); ++i) {
                EXPECT_EQ((*others)[i].sample, (*owners)[i].sample);
                EXPECT_EQ((*others)[i].quad, (*owners)[i].quad);
                EXPECT_EQ((*others)[i].distance, (*owners)[i].distance);
            }
            EXPECT_EQ(eared.surface_distance.cover(faces, quads, nullptr, run).has_value(), missed.empty());
        }
    }
}

TEST(SurfaceDistance, NoSampleIsLostWhenFacesAreReplaced) {
    Eared eared;
    SurfaceDistance &surface_distance = eared.surface_distance;
    const std::size_t n = eared.surface->points().size();
    const std::vector<geometry::Quad> quads = quads_of(eared.mesh);
    std::size_t samples = 0;
    const std::vector<int> old{3, 17, 40, 41};
    for (const int f : old)
        samples += surface_distance.samples(f).size();
    ASSERT_GT(samples, 0u);
    // The same quads, in other places: first more faces, then fewer, the last ones in their gaps.
    const int faces = surface_distance.faces();
    const std::vector<geometry::Quad> at_them{quads[3], quads[17], quads[40], quads[41]};
    const auto owners = surface_distance.cover(old, at_them);
    ASSERT_TRUE(owners);
    EXPECT_EQ(owners->size(), samples);
    surface_distance.resize(faces + 2);
    EXPECT_TRUE(surface_distance.samples(faces).empty());
    surface_distance.assign(old, *owners, std::vector{faces, 41, faces + 1, 3});
    expect_none_lost(surface_distance, n);
    EXPECT_TRUE(surface_distance.samples(17).empty());
    EXPECT_TRUE(surface_distance.samples(40).empty());
    for (const auto &[face, quad] : {std::pair(faces, 3), {41, 17}, {faces + 1, 40}, {3, 41}})
        for (const int s : surface_distance.samples(face))
            EXPECT_LT(geometry::closest_point(quads[at(quad)], surface_distance.point(s)).distance, 1e-20);

    const std::vector<int> last = surface_distance.samples(faces + 1);
    surface_distance.move(faces + 1, 17);
    surface_distance.move(faces, 40);
    surface_distance.resize(faces);
    EXPECT_EQ(surface_distance.faces(), faces);
    EXPECT_EQ(surface_distance.samples(17), last);
    expect_none_lost(surface_distance, n);
}

TEST(SurfaceDistance, AssignRemembersHowFarSamplesAre) {
    Eared eared;
    std::vector<geometry::Quad> smaller = quads_of(eared.mesh);
    for (geometry::Quad &quad : smaller)
        for (Eigen::Vector3d &corner : quad)
            corner *= 0.95;
    const auto owners = eared.surface_distance.cover(eared.all, smaller);
    ASSERT_TRUE(owners);
    EXPECT_TRUE(eared.surface_distance.complete());
    eared.surface_distance.assign(eared.all, *owners, eared.all);
    EXPECT_TRUE(eared.surface_distance.complete());
    eared.surface_distance.set_tolerance(0.03);
    EXPECT_FALSE(eared.surface_distance.complete());
    for (const SurfaceDistance::Owner &owner : *owners)
        EXPECT_DOUBLE_EQ(eared.surface_distance.allowed(owner.sample),
                         std::max(0.03, double(owner.distance)));
}

TEST(SurfaceDistance, IsForTheEdgesOfTheWantedFaces) {
    const Eared eared;
    for (const std::int64_t wanted : {50, 100000}) {
        const SurfaceDistance surface_distance = surface_distance_of(eared.mesh, *eared.surface, wanted, 0.6);
        EXPECT_DOUBLE_EQ(surface_distance.tolerance(),
                         0.6 * std::sqrt(eared.surface->area() / static_cast<double>(wanted)));
        expect_none_lost(surface_distance,
                         std::min<std::size_t>(5 * at(int(wanted)), eared.surface->points().size()));
    }
}

} // namespace
} // namespace alphamst::reference
