#include "geometry/plane.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace alphamst::geometry {

Plane Plane::fit(std::span<const Eigen::Vector3d> points, const Eigen::Vector3d &orientation) {
    Plane plane;
    for (const auto &p : points)
        plane.origin_ += p / static_cast<double>(points.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const auto &p : points)
        spread += (p - plane.origin_) * (p - plane.origin_).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(spread);
    const Eigen::Vector3d values = eigen.eigenvalues(); // ascending
    // The normal is free within the directions in which the points do not spread.
    constexpr double flat = 1e-12;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    if (values[1] > flat * values[2]) {
        normal = eigen.eigenvectors().col(0);
        if (normal.dot(orientation) < 0)
            normal = -normal;
    } else {
        normal = orientation;
        if (values[2] > 0)
            normal -= normal.dot(eigen.eigenvectors().col(2)) * eigen.eigenvectors().col(2);
        if (normal.squaredNorm() <= flat * orientation.squaredNorm())
            normal = eigen.eigenvectors().col(0);
        normal.normalize();
    }
    plane.frame_.col(2) = normal;
    plane.frame_.col(0) = normal.unitOrthogonal();
    plane.frame_.col(1) = normal.cross(plane.frame_.col(0));
    return plane;
}

Plane Plane::of_coordinates(bool from_below) {
    Plane plane;
    if (from_below)
        plane.frame_.diagonal() = Eigen::Vector3d(1, -1, -1);
    return plane;
}

double Plane::deviation(std::span<const Eigen::Vector3d> points) const {
    double largest = 0;
    for (const auto &p : points)
        largest = std::max(largest, std::abs(height(p)));
    return largest;
}

bool Plane::holds(std::span<const Eigen::Vector3d> points) const {
    if (points.empty())
        return true;
    Eigen::Vector3d low = points[0], high = points[0];
    for (const Eigen::Vector3d &p : points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    constexpr double rounding = 1e-7; // of files and frames, not curvature
    return deviation(points) <= rounding * (high - low).norm();
}

} // namespace alphamst::geometry
