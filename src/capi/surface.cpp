#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "capi/guard.h"
#include "capi/handles.h"
#include "mesh/sides.h"
#include "reference/surface_of.h"

namespace alphamst::capi {
namespace {

using Eigen::Vector3d;

void require_size(std::int64_t n, const char *name) {
    constexpr std::int64_t most = std::numeric_limits<amst_id>::max() - 1;
    if (n > most)
        throw Failure(Fault::range, std::string(name) + " is " + std::to_string(n) +
                                        ": ids are 32 bits wide, which is enough for " +
                                        std::to_string(most));
}

std::vector<Vector3d> points_of(const double *points, std::int64_t n, int dim) {
    std::vector<Vector3d> read;
    read.reserve(static_cast<std::size_t>(n));
    for (std::int64_t i = 0; i < n; ++i, points += dim)
        read.emplace_back(points[0], points[1], dim == 3 ? points[2] : 0);
    return read;
}

std::vector<std::array<int, 3>> triangles_of(const std::int32_t *corners, std::int64_t n, int base,
                                             std::int64_t n_points) {
    std::vector<std::array<int, 3>> read(static_cast<std::size_t>(n));
    for (std::int64_t t = 0; t < n; ++t)
        for (int &corner : read[static_cast<std::size_t>(t)]) {
            const std::int64_t point = std::int64_t{*corners++} - base;
            if (point < 0 || point >= n_points)
                throw Failure(Fault::range,
                              "triangle {} of the surface has corner {}, but there are " +
                                  std::to_string(n_points) + " points; correct the corner or add the point",
                              Entity::none, {t, point});
            corner = static_cast<int>(point);
        }
    return read;
}

// Lengths as those of meshes are, and something to keep to.
void require_places(const surface::Surface &surface) {
    for (std::size_t i = 0; i < surface.points().size(); ++i)
        if (surface.points()[i].cwiseAbs().maxCoeff() > mesh::largest_coordinate)
            throw Failure(
                Fault::range,
                "point {} of the surface has a coordinate beyond 1e30; give the surface and the mesh in "
                "a larger unit of length",
                Entity::none, {static_cast<std::int64_t>(i)});
    if (!(surface.area() > mesh::least_extent * mesh::least_extent))
        throw Failure(Fault::range,
                      "no triangle of the surface has an area; give at least one whose corners are "
                      "not on a line");
}

} // namespace
} // namespace alphamst::capi

using namespace alphamst;
using namespace alphamst::capi;

amst_status amst_mesh_set_surface(amst_mesh *mesh, const double *points, std::int64_t n_points,
                                  const std::int32_t *triangles, std::int64_t n_triangles) {
    return guarded(index_base(mesh), [&] {
        Mesh &target = *required(mesh, "mesh").impl;
        target.context->require_idle();
        std::shared_ptr<const surface::Surface> made;
        if (points == nullptr) {
            made = reference::surface_of(*target.current);
        } else {
            require_array(points, n_points, "points", "n_points");
            require_array(triangles, n_triangles, "triangles", "n_triangles");
            require_size(n_points, "n_points");
            require_size(n_triangles, "n_triangles");
            made = std::make_shared<const surface::Surface>(
                points_of(points, n_points, target.current->dim()),
                triangles_of(triangles, n_triangles, index_base(mesh), n_points));
        }
        require_places(*made);
        target.writable().surface = std::move(made);
    });
}
