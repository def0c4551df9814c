// Positions for the new vertices of a filling: planar, with the boundary fixed.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "geometry/feature_line.h"
#include "geometry/judgement.h"

namespace alphamst::geometry {

using Quads = std::span<const std::array<int, 4>>;
using Points = std::vector<Eigen::Vector2d>;

// Vertices 0 .. boundary-1 are fixed and run counter-clockwise around the disk;
// the others are free. Positions of all vertices are in one array.

// Tutte (1963): the loop, with edges of these lengths, on a circle around the origin, every free
// vertex the mean of its neighbours. Every face of a 3-connected filling is convex.
Points embed_on_circle(Quads quads, int boundary, int vertices, std::span<const double> lengths);

// The same with the loop where it is: faces may be inverted.
Points embed_in_loop(Quads quads, int vertices, std::span<const Eigen::Vector2d> loop);

struct Embedding : Judgement {
    Points positions; // all vertices; the first `boundary` equal the loop
    int stuck = -1;   // where it is not valid: the quad that resisted most, if few did
};

// Runs work(0) .. work(n - 1), perhaps at the same time.
using Run = std::function<void(std::size_t n, const std::function<void(std::size_t)> &work)>;

struct EmbedOptions {
    int steps = 20;                    // sweeps of shape optimisation after untangling
    int untangle_sweeps = 200;         // give up afterwards
    bool patient = true;               // false: untangle only what comes right soon
    double least_area = 0.005;         // of a corner, over the wanted one, that the smallest angles may cost
    std::optional<double> size_weight; // improve: of areas against shapes, in 0 .. 1; none: as it chooses
    std::span<const double> area = {}; // improve: [quad] wanted; empty: all equal
    // improve on a surface: [vertex] where those that are on a feature line may go; empty: there are none.
    std::span<const FeatureLine> feature_lines = {};
    // improve: with it, vertices move in classes that do not touch; the result does not depend on how it
    // runs them.
    Run run = {};
};

// Tutte start -> move the loop to its place -> untangle (Garanzha et al. 2021) ->
// improve. Never throws for geometric reasons: valid says whether it worked.
// Deterministic; uses no threads.
Embedding embed(Quads quads, int boundary, int vertices, std::span<const Eigen::Vector2d> loop,
                const EmbedOptions &options);

// Shape optimisation of given positions; fixed[v] vertices do not move. The smallest
// scaled Jacobian never falls and no corner turns non-positive that was positive.
Embedding improve(Quads quads, std::span<const char> fixed, Points positions, const EmbedOptions &options);

// Smallest corner determinant and smallest scaled Jacobian over the quads.
Embedding judge(Quads quads, Points positions);
// The same without the places.
Judgement shapes_of(Quads quads, const Points &positions);

} // namespace alphamst::geometry
