// What optimising positions in the plane and on a surface have in common: sweeps over the vertices and
// over the worst corners.
#pragma once

#include <algorithm>
#include <vector>

#include "geometry/colour.h"
#include "stop.h"

namespace alphamst::geometry {

constexpr double still = 1e-2;  // a vertex rests when it moves less, in wanted edge lengths
constexpr double softest = 0.2; // first epsilon at corners that are hardly positive

// Calls move(vertex), true if that went far, for all vertices in order, or class by class where the
// options run things at the same time. True if any went far.
template <class Move>
bool sweep(int vertices, const std::vector<std::vector<int>> &classes, const EmbedOptions &options,
           const Move &move) {
    constexpr std::size_t piece = 256; // vertices at least that make up for a change of thread
    bool far = false;
    for (const auto &members : classes) {
        std::vector<char> moved((members.size() + piece - 1) / piece, 0);
        options.run(moved.size(), [&](std::size_t i) {
            const std::size_t last = std::min(members.size(), (i + 1) * piece);
            Stop::point();
            for (std::size_t k = i * piece; k < last; ++k)
                moved[i] |= move(members[k]);
        });
        far |= std::find(moved.begin(), moved.end(), 1) != moved.end();
    }
    if (!options.run)
        for (int v = 0; v < vertices; ++v) {
            Stop::point();
            far |= move(v);
        }
    return far;
}

// Calls turn(vertex, floor) around the quads of smallest scaled Jacobian, which quality(quad) tells,
// until that no longer rises. floor: the square of the smallest.
template <class Quality, class Turn>
void sharpen_worst(const Problem &problem, int rounds, const Quality &quality, const Turn &turn) {
    constexpr double band = 0.15;       // quads up to this above the worst are sharpened with it
    constexpr double least_gain = 2e-3; // of the smallest scaled Jacobian in a round
    constexpr int sweeps = 3;           // in a round
    std::vector<char> member(problem.fixed.size(), 0);
    std::vector<int> around;
    std::vector<double> of_quad(problem.quads.size());
    double before = -1;
    for (int round = 0; round < rounds; ++round) {
        double worst = 1;
        for (std::size_t q = 0; q < of_quad.size(); ++q)
            worst = std::min(worst, of_quad[q] = quality(q));
        if (!(worst > 0) || worst < before + least_gain)
            return;
        before = worst;
        for (const int v : around)
            member[static_cast<std::size_t>(v)] = 0;
        around.clear();
        for (std::size_t q = 0; q < of_quad.size(); ++q)
            if (of_quad[q] < worst + band)
                for (const int v : problem.quads[q])
                    if (const auto i = static_cast<std::size_t>(v); !problem.fixed[i] && !member[i]) {
                        member[i] = 1;
                        around.push_back(v);
                    }
        grow(problem.stars, problem.fixed, 1, around, member);
        for (int k = 0; k < sweeps; ++k)
            for (const int v : around) {
                Stop::point();
                turn(v, worst * worst);
            }
    }
}

} // namespace alphamst::geometry
