#include "reference/cross_field.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include "mesh/cross_field.h"

namespace alphamst::reference {
namespace {

// Of their parts at right angles to the normal.
double flat_dot(const Eigen::Vector3d &a, const Eigen::Vector3d &b, const Eigen::Vector3d &normal) {
    return a.dot(b) - a.dot(normal) * b.dot(normal);
}

} // namespace

CrossField::CrossField(const mesh::QuadMesh &mesh) : mesh_(std::make_unique<const mesh::QuadMesh>(mesh)) {
    constexpr int sweeps = 20; // on each level of the hierarchy of faces
    const std::vector<double> *given = mesh.field(Entity::face, "cross");
    values_ = given != nullptr ? *given : mesh::cross_field(*mesh_, sweeps);
    std::vector<int> all(static_cast<std::size_t>(mesh.n_faces()));
    std::iota(all.begin(), all.end(), 0);
    faces_ = std::make_unique<const FaceTree>(*mesh_, std::move(all));
}

Eigen::Vector3d CrossField::at(const Eigen::Vector3d &point) const {
    const auto i = 3 * static_cast<std::size_t>(faces_->nearest(point).face);
    return {values_[i], values_[i + 1], values_[i + 2]};
}

double CrossField::alignment_error(std::span<const geometry::Quad> quads) const {
    double sum = 0;
    std::size_t sides = 0;
    for (const geometry::Quad &quad : quads) {
        const Eigen::Vector3d normal = geometry::area_vector(quad).normalized(),
                              cross = at(geometry::centre(quad));
        for (std::size_t k = 0; k < 4; ++k, ++sides) {
            const Eigen::Vector3d side = quad[(k + 1) % 4] - quad[k];
            // Across the normal as along it, four times around.
            const double angle = 4 * std::atan2(normal.dot(cross.cross(side)), flat_dot(cross, side, normal));
            sum += std::abs(std::remainder(angle, 2 * std::numbers::pi)) / 4;
        }
    }
    return sides == 0 ? 0 : sum / static_cast<double>(sides) * 180 / std::numbers::pi;
}

} // namespace alphamst::reference
