#include "adapt/relax.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "adapt/tally.h"
#include "adapt/workers.h"
#include "geometry/embed.h"
#include "geometry/star.h"
#include "patch/region.h"

namespace alphamst::adapt {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Of each face: the mean over the faces around it, some layers deep.
std::vector<double> local_areas(const mesh::QuadMesh &mesh, const geometry::Points &positions) {
    constexpr int layers = 4;
    std::vector<double> area;
    for (const auto &q : mesh.faces())
        area.push_back(std::max(0.0, geometry::cross(positions[at(q[2])] - positions[at(q[0])],
                                                     positions[at(q[3])] - positions[at(q[1])]) /
                                         2));
    std::vector<double> sum(positions.size()), count(positions.size(), 0);
    for (const auto &q : mesh.faces())
        for (const int v : q)
            ++count[at(v)];
    for (int layer = 0; layer < layers; ++layer) {
        std::fill(sum.begin(), sum.end(), 0);
        for (std::size_t f = 0; f < area.size(); ++f)
            for (const int v : mesh.faces()[f])
                sum[at(v)] += area[f];
        for (std::size_t f = 0; f < area.size(); ++f) {
            area[f] = 0;
            for (const int v : mesh.faces()[f])
                area[f] += sum[at(v)] / count[at(v)] / 4;
        }
    }
    return area;
}

// By the density, so scaled that they sum up to the area of the mesh.
std::vector<double> wanted_areas(const mesh::QuadMesh &mesh, const Density &density) {
    std::vector<double> wanted;
    double sum = 0, area = 0;
    for (const auto &q : mesh.faces()) {
        Eigen::Vector3d corner[4];
        for (std::size_t k = 0; k < 4; ++k)
            corner[k] = point_of(mesh, q[k]);
        wanted.push_back(1 / density.at((corner[0] + corner[1] + corner[2] + corner[3]) / 4));
        sum += wanted.back();
        area += (corner[2] - corner[0]).cross(corner[3] - corner[1]).norm() / 2;
    }
    for (double &a : wanted)
        a *= area / sum;
    return wanted;
}

} // namespace

void relax(mesh::QuadMesh &mesh, const geometry::Plane &plane, const std::optional<Density> &density,
           const Settings &settings) {
    std::vector<char> fixed;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        fixed.push_back(mesh.isolated(v) || patch::pinned(mesh, v));
    geometry::Points positions = flatten(mesh, plane);
    const std::vector<double> area = density ? wanted_areas(mesh, *density) : local_areas(mesh, positions);
    geometry::EmbedOptions options;
    options.steps = settings.smooth_steps;
    options.patient = settings.patient;
    options.least_area = settings.least_area;
    options.area = area;
    const Workers workers(settings.threads);
    options.run = [&](std::size_t n, const std::function<void(std::size_t)> &work) {
        workers.run(n, [&](std::size_t i, std::size_t) { work(i); });
    };
    const auto result = geometry::improve(mesh.faces(), fixed, std::move(positions), options);
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        if (fixed[at(v)])
            continue;
        const Eigen::Vector3d p = plane.to_space(result.positions[at(v)]);
        mesh.set_point(v, {p.x(), p.y(), mesh.dim() == 2 ? 0.0 : p.z()});
    }
}

} // namespace alphamst::adapt
