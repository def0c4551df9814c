// Newton's method on all vertices of a part of a disk at once: for corners that no
// single vertex can mend.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "geometry/barrier.h"

namespace alphamst::geometry {

// Free vertices to move and the quads that feel it.
struct FreeRegion {
    std::vector<int> vertices, quads;
    std::vector<char> member; // [vertex of the disk]

    // The free vertices of some quads and of `layers` of faces around them.
    FreeRegion(const Problem &problem, std::span<const int> seeds, int layers);
    void extend(const Problem &problem, int layers);
};

// Smallest corner determinant over the wanted area, over the given quads.
double worst_determinant(const Problem &problem, std::span<const int> quads, const Points &points);

struct Descent {
    double theta;
    int rounds, steps;
    std::function<void(const Points &)> renew;
};

class Newton {
public:
    // Both must outlive it. The wanted areas of the problem may change between calls.
    Newton(const Problem &problem, const FreeRegion &region);
    ~Newton();

    // Minimises the barrier with epsilon falling from 1 by the rule that Garanzha et al. prove to
    // end in an untangled state, if there is one, until every corner determinant of the region,
    // over the wanted area, exceeds `margin`. True if it got there. Gives up once epsilon has
    // fallen far below the determinant of a corner that stays negative. `iterations` is the most
    // it may make and is lowered by those made.
    bool untangle(Points &points, int &iterations, double margin);

    // Minimises the barrier with epsilon = 0 over a region without a corner that is not positive; none
    // becomes one. Some rounds of `steps` steps, fewer where one gains little, and before each renew(points),
    // which may change the wanted areas.
    void minimise(Points &points, const Descent &descent);

private:
    class Step;
    const Problem &problem_;
    const FreeRegion &region_;
    std::unique_ptr<Step> step_; // null: nothing is free
};

} // namespace alphamst::geometry
