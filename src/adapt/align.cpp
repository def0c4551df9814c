#include "adapt/align.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include "adapt/relax.h"
#include "adapt/shaping.h"
#include "geometry/align.h"
#include "mesh/cross_field.h"

namespace alphamst::adapt {
namespace {

// Of their parts at right angles to the normal.
double flat_dot(const Eigen::Vector3d &a, const Eigen::Vector3d &b, const Eigen::Vector3d &normal) {
    return a.dot(b) - a.dot(normal) * b.dot(normal);
}

} // namespace

Crosses::Crosses(const mesh::QuadMesh &mesh) : mesh_(std::make_unique<const mesh::QuadMesh>(mesh)) {
    constexpr int sweeps = 20; // on each level of the hierarchy of faces
    const std::vector<double> *given = mesh.field(Entity::face, "cross");
    values_ = given != nullptr ? *given : mesh::cross_field(*mesh_, sweeps);
    std::vector<int> all(static_cast<std::size_t>(mesh.n_faces()));
    std::iota(all.begin(), all.end(), 0);
    faces_ = std::make_unique<const Faces>(*mesh_, std::move(all));
}

Eigen::Vector3d Crosses::at(const Eigen::Vector3d &point) const {
    const auto i = 3 * static_cast<std::size_t>(faces_->nearest(point).face);
    return {values_[i], values_[i + 1], values_[i + 2]};
}

double Crosses::straying(std::span<const Quad> quads) const {
    double sum = 0;
    std::size_t sides = 0;
    for (const Quad &quad : quads) {
        const Eigen::Vector3d normal = area_vector(quad).normalized(),
                              cross = at((quad[0] + quad[1] + quad[2] + quad[3]) / 4);
        for (std::size_t k = 0; k < 4; ++k, ++sides) {
            const Eigen::Vector3d side = quad[(k + 1) % 4] - quad[k];
            // Across the normal as along it, four times around.
            const double angle = 4 * std::atan2(normal.dot(cross.cross(side)), flat_dot(cross, side, normal));
            sum += std::abs(std::remainder(angle, 2 * std::numbers::pi)) / 4;
        }
    }
    return sides == 0 ? 0 : sum / static_cast<double>(sides) * 180 / std::numbers::pi;
}

void align(mesh::QuadMesh &mesh, Ground &ground, const Crosses &crosses, const Settings &settings) {
    std::vector<Eigen::Vector3d> directions;
    for (int f = 0; f < mesh.n_faces(); ++f) {
        const Quad corners = quad_of(mesh, f);
        directions.push_back(crosses.at((corners[0] + corners[1] + corners[2] + corners[3]) / 4));
    }
    const std::vector<char> fixed = immovable(mesh);
    for (int round = 0; round < 5; ++round) {
        const geometry::Drape start = ground.drape(mesh);
        geometry::Drape drape = start;
        const std::vector<double> areas = ground.areas(mesh.faces(), drape);
        geometry::EmbedOptions options = shaping(settings);
        options.area = areas;
        geometry::align(*ground.surface, mesh.faces(), fixed, directions, drape, options);
        if (!settle(mesh, ground, start, drape, {}))
            break;
    }
}

} // namespace alphamst::adapt
