// A disk of quads in space laid out in the plane, and back.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "fill/filling.h"
#include "geometry/surface_positions.h"
#include "mesh/quad_mesh.h"
#include "outcome.h"
#include "settings.h"

namespace alphamst::refill {

// What lies at the same place of the chart lies at the same place of the surface, so that a new filling
// begins where the old one was. Where the loop keeps a shape of its own, in a projection on a plane or a
// conformal map, fillings get their shape there. Otherwise it is on a circle, spaced by length, in which any
// filling of it has a place without a face inverted, however curved the surface is (Tutte 1963). A map
// that folds is not taken: conformal and low stretch give way to mean values, and those to Tutte's. His is
// the one by default, since mean values in its place made no fewer singularities and took no less time.
class Chart {
public:
    Chart(const fill::Filling &old, const geometry::SurfacePositions &on_surface,
          ChartKind kind = ChartKind::plane_or_circle);
    ~Chart();
    Chart(Chart &&) noexcept;

    // Of the vertices of the old filling.
    const geometry::Points &positions() const { return positions_; }
    // Of the vertices of another filling of the boundary; not valid where no such positions were found.
    geometry::Embedding place(const fill::Filling &filling, const geometry::EmbedOptions &options) const;
    // Where on the surface a position is.
    surface::Spot lift(const surface::Surface &surface, const Eigen::Vector2d &position) const;

private:
    bool lay(ChartKind kind);
    bool take(geometry::Points positions);
    bool project();
    void link();

    struct Tree;
    fill::Filling old_;
    geometry::SurfacePositions on_surface_;
    bool round_ = true;           // the loop is on a circle
    std::vector<double> lengths_; // of the edges of the loop
    geometry::Points positions_;
    std::vector<std::array<int, 3>> triangles_;
    std::unique_ptr<const Tree> tree_;
};

} // namespace alphamst::refill
