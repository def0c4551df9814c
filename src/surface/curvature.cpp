#include "surface/curvature.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "index.h"

namespace alphamst::surface {
namespace {

using Eigen::Vector3d;

// Replaces the value of each point by the mean over the triangles around it, of the mean of their corners.
template <class Value> void average(const Surface &surface, std::vector<Value> &values, const Value &zero) {
    std::vector<Value> sums(values.size(), zero);
    std::vector<double> weights(values.size(), 0);
    for (const auto &triangle : surface.triangles()) {
        const auto &[a, b, c] = triangle;
        const double area = (surface.points()[at(b)] - surface.points()[at(a)])
                                .cross(surface.points()[at(c)] - surface.points()[at(a)])
                                .norm();
        const Value sum = (values[at(a)] + values[at(b)] + values[at(c)]) * (area / 3);
        for (const int i : triangle) {
            sums[at(i)] += sum;
            weights[at(i)] += area;
        }
    }
    for (std::size_t i = 0; i < values.size(); ++i)
        if (weights[i] > 0)
            values[i] = sums[i] / weights[i];
}

} // namespace

std::vector<double> curvature(const Surface &surface, int rings) {
    std::vector<Vector3d> normals(surface.points().size(), Vector3d::Zero());
    for (std::size_t t = 0; t < surface.triangles().size(); ++t)
        for (const int i : surface.triangles()[t])
            normals[at(i)] += surface.normal(static_cast<int>(t));
    for (Vector3d &normal : normals)
        normal.normalize();
    for (int ring = 0; ring < rings; ++ring)
        average<Vector3d>(surface, normals, Vector3d::Zero());
    for (Vector3d &normal : normals)
        normal.normalize();
    std::vector<double> result(normals.size(), 0);
    for (const auto &triangle : surface.triangles())
        for (std::size_t k = 0; k < 3; ++k) {
            const int i = triangle[k], j = triangle[(k + 1) % 3];
            const double way = (surface.points()[at(i)] - surface.points()[at(j)]).norm();
            if (!(way > 0))
                continue;
            const double turn = (normals[at(i)] - normals[at(j)]).norm() / way;
            result[at(i)] = std::max(result[at(i)], turn);
            result[at(j)] = std::max(result[at(j)], turn);
        }
    for (int ring = 0; ring < rings; ++ring)
        average<double>(surface, result, 0.0);
    return result;
}

} // namespace alphamst::surface
