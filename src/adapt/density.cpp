#include "adapt/density.h"

#include <Eigen/Geometry>
#include <numeric>

namespace alphamst::adapt {

std::optional<Density> Density::of(const mesh::QuadMesh &mesh) {
    if (mesh.n_faces() == 0 || mesh.field(Entity::vertex, "size") == nullptr)
        return std::nullopt;
    return Density(mesh);
}

Density::Density(const mesh::QuadMesh &mesh)
    : mesh_(std::make_unique<const mesh::QuadMesh>(mesh)), size_(*mesh.field(Entity::vertex, "size")) {
    std::vector<int> all(static_cast<std::size_t>(mesh.n_faces()));
    std::iota(all.begin(), all.end(), 0);
    faces_ = std::make_unique<const Faces>(*mesh_, std::move(all));
}

double Density::at(const Eigen::Vector3d &point) const {
    const Faces::Place place = faces_->nearest(point);
    const auto corners = mesh_->corners(place.face);
    double size = 0;
    for (std::size_t k = 0; k < 4; ++k)
        size += place.spot.weights[k] * size_[static_cast<std::size_t>(corners[k])];
    return 1 / (size * size);
}

std::vector<double> Density::weights(const mesh::QuadMesh &mesh, std::span<const int> faces) const {
    std::vector<double> weights;
    for (const int f : faces) {
        Eigen::Vector3d corner[4], middle = Eigen::Vector3d::Zero();
        const auto corners = mesh.corners(f);
        for (std::size_t k = 0; k < 4; ++k)
            middle += (corner[k] = point_of(mesh, corners[k])) / 4;
        weights.push_back((corner[2] - corner[0]).cross(corner[3] - corner[1]).norm() / 2 * at(middle));
    }
    return weights;
}

} // namespace alphamst::adapt
