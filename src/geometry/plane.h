// The plane of a piece of surface, to carry its points to 2D and back.
#pragma once

#include <Eigen/Core>
#include <span>

namespace alphamst::geometry {

class Plane {
public:
    // Least squares through the points; the normal is on the side of `orientation`. Where the
    // points do not determine a plane (fewer than three, or on a line) the normal is as near to
    // `orientation` as they allow.
    static Plane fit(std::span<const Eigen::Vector3d> points, const Eigen::Vector3d &orientation);

    // The plane z = 0 with its own coordinates, or seen from below, y inverted: for meshes of two
    // coordinates, whose faces may all run clockwise.
    static Plane of_coordinates(bool from_below);

    Eigen::Vector2d to_plane(const Eigen::Vector3d &point) const {
        return frame_.leftCols<2>().transpose() * (point - origin_);
    }
    Eigen::Vector3d to_space(const Eigen::Vector2d &point, double height = 0) const {
        return origin_ + frame_.leftCols<2>() * point + height * frame_.col(2);
    }
    double height(const Eigen::Vector3d &point) const { return frame_.col(2).dot(point - origin_); } // signed
    Eigen::Vector3d normal() const { return frame_.col(2); }

    // Largest distance of the points from the plane.
    double deviation(std::span<const Eigen::Vector3d> points) const;
    // Whether the points lie in the plane but for rounding: 1e-7 of their extent.
    bool holds(std::span<const Eigen::Vector3d> points) const;

private:
    Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
    Eigen::Matrix3d frame_ = Eigen::Matrix3d::Identity(); // columns: right-handed, the normal last
};

} // namespace alphamst::geometry
