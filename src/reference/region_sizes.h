// The area that a face is wanted to have at each place of a region whose border stays, and how far faces are
// from it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "fill/filling.h"
#include "geometry/quad.h"
#include "reference/locate.h"
#include "reference/size_error.h"

namespace alphamst::reference {

class RegionSizes {
public:
    // Wanted is the area that faces have now, smoothed over neighbours, or what `areas`, if there are any,
    // say for each of them: at the border, whose edges stay, as it is, and far from it divided by one number,
    // so that the faces come to `faces`. In between it changes smoothly, over `transition` of the greatest
    // distance that a face has from the border. positions: of the vertices of the filling that is there, in
    // space.
    RegionSizes(const fill::Filling &old, const std::vector<Eigen::Vector3d> &positions, double faces,
                double transition, std::vector<double> areas = {});
    // Of faces of a mesh; there may be holes in between.
    RegionSizes(const mesh::QuadMesh &mesh, std::span<const int> region, double faces, double transition);

    double at(const Eigen::Vector3d &place) const { return std::exp(log_at(place)); }
    SizeError error(std::span<const geometry::Quad> quads) const;

private:
    using Segment = std::array<Eigen::Vector3d, 2>;

    RegionSizes(const fill::Filling &old, const std::vector<Eigen::Vector3d> &positions, double faces,
                double transition, std::vector<double> areas, std::vector<Segment> border);

    static std::vector<Segment> border_of(const fill::Filling &old,
                                          const std::vector<Eigen::Vector3d> &positions);
    static std::vector<Segment> border_of(const mesh::QuadMesh &mesh, std::span<const int> region);

    void make_lattice();
    double log_at(const Eigen::Vector3d &place) const;
    double computed(const Eigen::Vector3d &place) const; // not by the lattice
    double distance(const Eigen::Vector3d &place) const; // to the border

    std::vector<Segment> border_;
    std::vector<double> log_areas_;     // [face of the old filling]
    PointTree faces_;                   // their centres
    double depth_ = 0, log_factor_ = 0; // depth_: over which sizes change
    // In a plane: values at the points of a lattice over the cavity, between which they are interpolated, as
    // they are asked for a hundred thousand times. [row][column], rows along the y-axis.
    std::vector<double> lattice_;
    Eigen::Vector3d origin_;
    double spacing_ = 0;
    int columns_ = 0, rows_ = 0;
};

} // namespace alphamst::reference
