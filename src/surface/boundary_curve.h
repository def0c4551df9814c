// Boundary curves: closed polylines, by arc length, on which the vertices of a boundary come and go.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

namespace alphamst::surface {

struct CurvePlace {
    int curve = -1;   // none
    double along = 0; // length from the first point of the curve on, below that of the whole
};

// Const and safe for any number of threads once made.
class BoundaryCurves {
public:
    // [curve][point], the last joined to the first. Without duplicates side by side.
    explicit BoundaryCurves(std::vector<std::vector<Eigen::Vector3d>> curves);
    BoundaryCurves(const BoundaryCurves &) = delete;
    BoundaryCurves &operator=(const BoundaryCurves &) = delete;
    ~BoundaryCurves();

    int count() const { return static_cast<int>(curves_.size()); }
    const std::vector<Eigen::Vector3d> &points(int curve) const {
        return curves_[static_cast<std::size_t>(curve)].points;
    }
    double length(int curve) const;
    double extent() const { return extent_; } // the longest of them
    Eigen::Vector3d at(CurvePlace place) const;
    // The place of a point on a curve; none if it is farther from all of them than the tolerance, or as near
    // to some other part.
    CurvePlace find(const Eigen::Vector3d &point, double tolerance) const;

    // Of two places on one curve: the length of the way from the first to the second, along the direction of
    // the curve; all of it where they are the same.
    double way(CurvePlace from, CurvePlace to) const;
    CurvePlace advance(CurvePlace from, double length) const;
    // The points of the curve strictly between, in order.
    struct Bend {
        Eigen::Vector3d point;
        double along, turn; // from the start of the way; degrees by which the curve turns there
    };
    std::vector<Bend> between(CurvePlace from, double length) const;
    // Whether any other part of the curves than this way, from end to end, comes nearer than the distance to
    // the straight line between its ends.
    bool others_near(CurvePlace from, double length, double distance) const;

private:
    struct Curve {
        std::vector<Eigen::Vector3d> points;
        std::vector<double> lengths; // [point] from the first one; then of the whole
    };
    struct Tree;

    std::size_t segment(CurvePlace place) const;

    std::vector<Curve> curves_;
    double extent_ = 0;
    std::unique_ptr<const Tree> tree_;
};

} // namespace alphamst::surface
