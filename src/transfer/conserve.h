// What the changed faces of a mesh hold of a field, and how to make that what it was.
#pragma once

#include <span>
#include <vector>

#include "transfer/cell.h"

namespace alphamst::transfer {

// The faces of the mesh before and after an operation that are not the same at the same place,
// ascending.
struct Changed {
    std::vector<int> before, after;
};

// Connected sets of changed faces. Those that share no vertex with a set of the other mesh, since
// all of theirs were replaced, are one set together.
class Regions {
public:
    Regions(const Cells &before, const Cells &after, const Changed &changed);

    // Makes the sum of value * area over the cells of each set what it was, in each component; where the set
    // itself has another area in a plane, its mean.
    void conserve(std::span<const double> old_values, std::span<double> values, int components) const;

private:
    struct Part {
        int cell;
        std::size_t region;
        double area;
    };
    std::vector<Part> before_, after_;
    std::size_t count_ = 0;
    bool may_gain_ = false; // the boundary of a plane mesh may have changed
};

} // namespace alphamst::transfer
