// Surface: the triangles that a curved mesh keeps to. Where on it is a point nearest, and what is
// the normal there.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace alphamst::surface {

// A place on the surface: the nearest one to a point that was asked for.
struct Spot {
    int triangle = -1;
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::Zero(); // of length one, see Surface::normal_at
    double distance = 0;
};

// Const and safe for any number of threads once made; the same question has the same answer, whatever
// the tree looks like. Degenerate triangles are part of the surface, but have no say in its normals.
class Surface {
public:
    using Spot = surface::Spot;

    // Throws Failure: range (no triangle, or one with a point there is not), not_finite (a
    // coordinate).
    Surface(std::vector<Eigen::Vector3d> points, std::vector<std::array<int, 3>> triangles);
    Surface(const Surface &) = delete;
    Surface &operator=(const Surface &) = delete;
    ~Surface();

    // Of the whole surface; of equally near triangles the smallest id. Costs O(log n) near the surface.
    Spot nearest(const Eigen::Vector3d &p) const;
    // Of the triangles whose normals make less than 75 degrees with `normal`, of any length: the other
    // side of a thin wall is not taken. Of the whole surface if there is none or `normal` is zero.
    Spot nearest(const Eigen::Vector3d &p, const Eigen::Vector3d &normal) const;
    // From triangle to triangle with a common point, always to the nearest, until p is right above the
    // inside of one or none is nearer: connected to the triangle it began at, and much faster than
    // nearest for a short way. Close to the surface it is the same; far above a hollow, one of its sides.
    Spot follow(const Eigen::Vector3d &p, int triangle) const;

    const std::vector<Eigen::Vector3d> &points() const { return points_; }
    const std::vector<std::array<int, 3>> &triangles() const { return triangles_; }
    // Ascending.
    std::span<const int> triangles_around(int point) const {
        const auto i = static_cast<std::size_t>(point);
        return std::span(around_).subspan(begin_[i], begin_[i + 1] - begin_[i]);
    }
    // Of length one, zero for a degenerate triangle.
    const Eigen::Vector3d &normal(int triangle) const { return normals_[static_cast<std::size_t>(triangle)]; }
    // With weights for the corners of a triangle: blended from the normals at its corners, each the mean
    // of the triangles around, weighted by their angles (Thurmer and Wuthrich 1998), as far as they are
    // reached without crossing an edge where the surface turns by more than 40 degrees.
    Eigen::Vector3d normal_at(int triangle, const Eigen::Vector3d &weights) const;
    double area() const;

private:
    struct Tree;
    struct Near;

    void check() const;
    void link();
    void find_normals();
    void find_corner_normals(int point);
    Near near(const Eigen::Vector3d &p, int triangle) const;
    Near step(const Eigen::Vector3d &p, const Near &from, bool touching) const;
    Near descend(const Eigen::Vector3d &p, Near from) const;
    Spot spot(const Eigen::Vector3d &p, const Near &near) const;
    template <class Accept> Near search(const Eigen::Vector3d &p, const Accept &accept) const;

    std::vector<Eigen::Vector3d> points_;
    std::vector<std::array<int, 3>> triangles_;
    std::vector<std::size_t> begin_; // of each point in around_, and its end
    std::vector<int> around_;
    std::vector<Eigen::Vector3d> normals_;
    std::vector<std::array<Eigen::Vector3d, 3>> corner_normals_;
    std::unique_ptr<const Tree> tree_;
};

} // namespace alphamst::surface
