// A disk of quads in space laid out in the plane, and back.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "fill/filling.h"
#include "geometry/drape.h"

namespace alphamst::adapt {

// What lies at the same place of the chart lies at the same place of the surface, so that a new filling
// begins where the old one was. Where the surface turns little, the chart is its projection on a plane,
// and fillings get their shape there. Elsewhere the disk and any other filling of its boundary are laid
// into the same circle, where none has a face turned over however curved the surface is (Tutte 1963;
// with the boundary spaced by length).
class Chart {
public:
    Chart(const fill::Filling &old, const geometry::Drape &drape);
    ~Chart();
    Chart(Chart &&) noexcept;

    // Of the vertices of the old filling.
    const geometry::Points &positions() const { return positions_; }
    // Of the vertices of another filling of the boundary; not valid where no such positions were found.
    geometry::Embedding place(const fill::Filling &filling, const geometry::EmbedOptions &options) const;
    // Where on the surface a position is.
    surface::Spot lift(const surface::Surface &surface, const Eigen::Vector2d &position) const;

private:
    bool project();
    void link();

    struct Tree;
    fill::Filling old_;
    geometry::Drape drape_;
    bool flat_ = false;
    std::vector<double> lengths_; // of the edges of the loop
    geometry::Points positions_;
    std::vector<std::array<int, 3>> triangles_;
    std::unique_ptr<const Tree> tree_;
};

} // namespace alphamst::adapt
