#include "transfer/conserve.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "adapt/meshes.h"
#include "reference/locate.h"

namespace alphamst::transfer {
namespace {

using adapt::samples::all_faces;
using adapt::samples::block;
using adapt::samples::grid;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Regions regions_of(const mesh::QuadMesh &before, const mesh::QuadMesh &after, const Changed &changed,
                   Entity entity = Entity::face) {
    return {Cells(before, entity), Cells(after, entity), changed};
}

// Over some faces of value * area, of one of two components.
double sum(const mesh::QuadMesh &mesh, const std::vector<double> &values, const std::vector<int> &faces,
           std::size_t component) {
    double total = 0;
    for (const int f : faces)
        total += values[2 * at(f) + component] * geometry::area_vector(reference::quad_of(mesh, f)).norm();
    return total;
}

std::vector<double> some_values(const mesh::QuadMesh &mesh, double sign) {
    std::vector<double> values;
    for (int f = 0; f < mesh.n_faces(); ++f)
        for (int component = 0; component < 2; ++component)
            values.push_back((1 + f % 5 + 3 * component) * (component == 1 && f % 2 == 0 ? sign : 1));
    return values;
}

// Two windows of a grid where a vertex has moved: each holds what it held, and other faces stay.
TEST(Conserve, EachRegionHoldsWhatItHeld) {
    const mesh::QuadMesh before = grid(9, 9);
    mesh::QuadMesh after = before;
    after.reset_origins();
    after.set_point(2 * 10 + 2, {2.3, 2.1, 0});
    after.set_point(7 * 10 + 7, {6.8, 7.2, 0});
    const std::vector<int> one = block(9, 1, 1, 3, 3), other = block(9, 6, 6, 8, 8);
    Changed changed{one, {}};
    changed.before.insert(changed.before.end(), other.begin(), other.end());
    changed.after = changed.before;
    const Regions regions = regions_of(before, after, changed);
    for (const double sign : {1.0, -1.0}) {
        const std::vector<double> old = some_values(before, sign);
        std::vector<double> values = old;
        for (const int f : one)
            values[2 * at(f)] *= 1.5;
        for (const int f : other)
            values[2 * at(f) + 1] *= 0.7;
        const std::vector<double> given = values;
        regions.conserve(old, values, 2);
        for (const std::vector<int> &region : {one, other})
            for (const std::size_t component : {0u, 1u})
                EXPECT_NEAR(sum(after, values, region, component), sum(before, old, region, component),
                            1e-12);
        for (const int f : all_faces(after))
            if (!std::binary_search(changed.after.begin(), changed.after.end(), f)) {
                EXPECT_EQ(values[2 * at(f)], given[2 * at(f)]);
                EXPECT_EQ(values[2 * at(f) + 1], given[2 * at(f) + 1]);
            }
    }
}

// What is missing is added in proportion to what is there, or evenly where nothing is.
TEST(Conserve, ValuesKeepTheirProportionsAndZerosGetTheMean) {
    const mesh::QuadMesh before = grid(4, 1);
    mesh::QuadMesh after = before;
    after.reset_origins();
    const Regions regions = regions_of(before, after, {all_faces(before), all_faces(after)});
    const std::vector<double> old{2, 4, 6, 8};
    std::vector<double> half{1, 2, 3, 4}, none{0, 0, 0, 0}, right = old;
    regions.conserve(old, half, 1);
    regions.conserve(old, none, 1);
    regions.conserve(old, right, 1);
    for (std::size_t f = 0; f < 4; ++f) {
        EXPECT_NEAR(half[f], old[f], 1e-12);
        EXPECT_NEAR(none[f], 5, 1e-12);
    }
    EXPECT_EQ(right, old); // not a bit of it
}

// All of the vertices are new, so nothing tells which faces are where: they hold together.
TEST(Conserve, WhatWasReplacedAltogetherIsOneRegion) {
    const mesh::QuadMesh before = grid(2, 2);
    mesh::QuadMesh after = grid(4, 4);
    std::fill(after.vertex_origin.begin(), after.vertex_origin.end(), -1);
    const Regions regions = regions_of(before, after, {all_faces(before), all_faces(after)});
    const std::vector<double> old{1, 2, 3, 4};
    std::vector<double> values(16, 1);
    regions.conserve(old, values, 1);
    for (const double value : values)
        EXPECT_NEAR(value, 10.0 / 16, 1e-12);
}

// Vertices hold quarters of faces; those at the border of what changed have others beyond it.
TEST(Conserve, VerticesHoldQuarters) {
    const mesh::QuadMesh before = grid(5, 5);
    mesh::QuadMesh after = before;
    after.reset_origins();
    after.set_point(2 * 6 + 2, {2.3, 2.1, 0});
    const std::vector<int> faces = block(5, 1, 1, 3, 3);
    const Regions regions = regions_of(before, after, {faces, faces}, Entity::vertex);
    const Cells olds(before, Entity::vertex), news(after, Entity::vertex);
    std::vector<double> old, values;
    for (int v = 0; v < before.n_vertices(); ++v) {
        old.push_back(1 + v % 7);
        values.push_back(1 + v % 5);
    }
    const std::vector<double> given = values;
    regions.conserve(old, values, 1);
    double sum = 0, wanted = 0;
    for (const int v : olds.of(faces)) {
        sum += values[at(v)] * news.area(v);
        wanted += old[at(v)] * olds.area(v);
    }
    EXPECT_NEAR(sum, wanted, 1e-12);
    EXPECT_EQ(values[0], given[0]);
    EXPECT_EQ(values[4 * 6 + 4], given[4 * 6 + 4]);
}

} // namespace
} // namespace alphamst::transfer
