// One call of adapt on one patch, and all that must hold after it, whatever it says.
#pragma once

#include <gtest/gtest.h>

#include <cstring>

#include "adapt/adapt.h"
#include "geometry/embed.h"
#include "meshes.h"
#include "smooth/smooth.h"

namespace alphamst::adapt::samples {

inline const Progress silent = [](double, const char *) {};

// Smallest scaled Jacobian of some faces of a mesh in the plane.
inline double least_scaled_jacobian(const mesh::QuadMesh &mesh, const std::vector<int> &faces) {
    geometry::Points points;
    std::vector<std::array<int, 4>> quads;
    std::map<int, int> local;
    for (const int f : faces) {
        std::array<int, 4> quad = mesh.corners(f);
        for (int &v : quad) {
            const auto [it, fresh] = local.emplace(v, static_cast<int>(points.size()));
            if (fresh)
                points.emplace_back(mesh.point(v)[0], mesh.point(v)[1]);
            v = it->second;
        }
        quads.push_back(quad);
    }
    return geometry::judge(quads, std::move(points)).min_scaled_jacobian;
}

inline std::vector<int> new_ones(const std::vector<std::int32_t> &origins) {
    std::vector<int> ids;
    for (std::size_t i = 0; i < origins.size(); ++i)
        if (origins[i] < 0)
            ids.push_back(static_cast<int>(i));
    return ids;
}

inline std::size_t distinct_old(const std::vector<std::int32_t> &origins) {
    std::set<std::int32_t> old(origins.begin(), origins.end());
    old.erase(-1);
    return old.size();
}

// By the origins: what is old is in `after` as it was in `before`, bit for bit.
inline void expect_old_unchanged(const mesh::QuadMesh &before, const mesh::QuadMesh &after) {
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    int wrong = 0;
    for (int v = 0; v < after.n_vertices(); ++v) {
        const int old = after.vertex_origin[at(v)];
        if (old < 0)
            continue;
        wrong += std::memcmp(&after.point(v), &before.point(old), sizeof(OpenMesh::Vec3d)) != 0;
        wrong += after.vertex_flags[at(v)] != before.vertex_flags[at(old)];
    }
    for (int e = 0; e < after.n_edges(); ++e) {
        const int old = after.edge_origin[at(e)];
        if (old < 0)
            continue;
        auto ends = after.edge_vertices(e);
        for (int &v : ends)
            v = after.vertex_origin[at(v)];
        std::sort(ends.begin(), ends.end());
        wrong += ends != before.edge_vertices(old);
        wrong += after.edge_flags[at(e)] != before.edge_flags[at(old)];
        wrong += !before.edge_marker.empty() && after.edge_marker[at(e)] != before.edge_marker[at(old)];
    }
    for (int f = 0; f < after.n_faces(); ++f) {
        const int old = after.face_origin[at(f)];
        if (old < 0)
            continue;
        auto corners = after.corners(f);
        for (int &v : corners)
            v = after.vertex_origin[at(v)];
        wrong += corners != before.corners(old);
        wrong += after.face_flags[at(f)] != before.face_flags[at(old)];
        wrong += !before.face_marker.empty() && after.face_marker[at(f)] != before.face_marker[at(old)];
    }
    EXPECT_EQ(wrong, 0) << "entities outside the patches have changed";
}

// By the origins: everything but the faces of the patches and what is inside them is in `after`
// as it was in `before`, bit for bit, and once.
inline void expect_outside_kept(const mesh::QuadMesh &before, const mesh::QuadMesh &after,
                                const std::vector<std::vector<int>> &patches) {
    std::size_t faces = 0, edges = 0, vertices = 0;
    for (const std::vector<int> &patch : patches) {
        const patch::Window window = patch::make_window(before, patch);
        faces += patch.size();
        edges += (4 * patch.size() - window.loop.size()) / 2;
        vertices += window.interior.size();
    }
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    ASSERT_EQ(distinct_old(after.face_origin), at(before.n_faces()) - faces);
    ASSERT_EQ(distinct_old(after.edge_origin), at(before.n_edges()) - edges);
    ASSERT_EQ(distinct_old(after.vertex_origin), at(before.n_vertices()) - vertices);
    expect_old_unchanged(before, after);
}

// Singular vertices in a set of faces, its boundary included, that of the mesh not.
inline std::int64_t singular_in(const mesh::QuadMesh &mesh, const std::vector<int> &faces) {
    std::set<int> vertices;
    for (const int f : faces)
        for (const int v : mesh.corners(f))
            if (mesh.singular(v))
                vertices.insert(v);
    return static_cast<std::int64_t>(vertices.size());
}

struct Run {
    Outcome outcome;
    std::optional<Prediction> prediction;
};

// `mesh` has fresh origins and passes its check.
inline Run run(const mesh::QuadMesh &mesh, const std::vector<int> &faces, double alpha,
               const Settings &settings = {}) {
    Patch region;
    region.faces = faces;
    Run run;
    try {
        run.prediction = predict(mesh, region, alpha, settings);
    } catch (const Failure &) { // adapt will say why
    }
    mesh::QuadMesh after = mesh;
    std::vector<Patch> regions{region};
    const std::vector<Outcome> outcomes = adapt(after, regions, alpha, settings, silent);
    EXPECT_EQ(outcomes.size(), 1u);
    run.outcome = outcomes.at(0);
    const Outcome &outcome = run.outcome;
    EXPECT_EQ(outcome.faces_before, static_cast<std::int64_t>(faces.size()));
    EXPECT_EQ(outcome.faces_wanted, std::llround(alpha * static_cast<double>(faces.size())));
    EXPECT_EQ(outcome.singular_before, singular_in(mesh, faces));
    if (outcome.fault) {
        EXPECT_FALSE(outcome.text.empty());
        EXPECT_EQ(after.checksum(), mesh.checksum());
        EXPECT_EQ(regions[0].faces, faces);
        EXPECT_EQ(outcome.faces_after, outcome.faces_before);
        return run;
    }
    EXPECT_NO_THROW(after.check());            // every corner is positive, too
    if (after.checksum() == mesh.checksum()) { // nothing could be gained
        EXPECT_EQ(regions[0].faces, faces);
        EXPECT_EQ(outcome.faces_after, outcome.faces_before);
    } else {
        const std::vector<int> fresh = new_ones(after.face_origin);
        const bool in_parts = faces.size() >= 300 && outcome.faces_wanted == outcome.faces_before;
        if (!in_parts) {
            expect_outside_kept(mesh, after, {faces});
            EXPECT_EQ(regions[0].faces, fresh);
        } else { // maybe, and some may have stayed
            EXPECT_TRUE(std::ranges::includes(regions[0].faces, fresh));
            expect_old_unchanged(mesh, after);
            EXPECT_GE(distinct_old(after.face_origin),
                      static_cast<std::size_t>(mesh.n_faces()) - faces.size());
        }
    }
    EXPECT_EQ(outcome.faces_after, static_cast<std::int64_t>(regions[0].faces.size()));
    EXPECT_EQ(outcome.singular_after, singular_in(after, regions[0].faces));
    EXPECT_LE(outcome.singular_bound, outcome.singular_after);
    EXPECT_NEAR(outcome.quality_before, least_scaled_jacobian(mesh, faces), 1e-9);
    EXPECT_NEAR(outcome.quality_after, least_scaled_jacobian(after, regions[0].faces), 1e-9);
    return run;
}

} // namespace alphamst::adapt::samples
