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
#include "reference/boundary.h"
#include "reference/locate.h"
#include "reference/size_error.h"

namespace alphamst::reference {

class RegionSizes {
public:
    // Wanted is the area that faces have now, smoothed over neighbours, or what `areas`, if there are any,
    // say for each of them: at the border, whose edges stay, as it is, and far from it divided by one number,
    // so that the faces come to `faces`. In between it changes smoothly, over `transition` of the greatest
    // distance that a face has from the border. positions: of the vertices of the filling that is there, in
    // space. stays: [edge of the boundary], empty: all do; edges that do not are no border.
    RegionSizes(const fill::Filling &old, const std::vector<Eigen::Vector3d> &positions, double faces,
                double transition, std::vector<double> areas = {}, std::span<const char> stays = {});
    // Of faces of a mesh; there may be holes in between. Where `boundary` may change, it is no border.
    RegionSizes(const mesh::QuadMesh &mesh, std::span<const int> region, double faces, double transition,
                const Boundary *boundary = nullptr);

    double at(const Eigen::Vector3d &place) const { return std::exp(log_at(place)); }
    double part(const Eigen::Vector3d &place) const; // wanted area over what is there or given
    SizeError error(std::span<const geometry::Quad> quads) const;

private:
    using Segment = std::array<Eigen::Vector3d, 2>;
    struct Border {
        std::vector<Segment> segments; // that stay
        bool any = false;              // there are some, whether or not they stay
        Eigen::Vector3d low, high;     // of all

        void add(const Segment &segment, bool stays);
    };

    RegionSizes(const fill::Filling &old, const std::vector<Eigen::Vector3d> &positions, double faces,
                double transition, std::vector<double> areas, Border border);

    static Border border_of(const fill::Filling &old, const std::vector<Eigen::Vector3d> &positions,
                            std::span<const char> stays);
    static Border border_of(const mesh::QuadMesh &mesh, std::span<const int> region,
                            const Boundary *boundary);

    void make_lattice();
    double log_at(const Eigen::Vector3d &place) const;
    double computed(const Eigen::Vector3d &place) const; // not by the lattice
    double distance(const Eigen::Vector3d &place) const; // to the border

    Border border_;
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
