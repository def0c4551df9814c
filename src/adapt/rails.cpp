#include "adapt/rails.h"

#include "adapt/locate.h"
#include "patch/region.h"

namespace alphamst::adapt {

geometry::Rail rail_of(const mesh::QuadMesh &mesh, int vertex) {
    if (!mesh.curves)
        return {};
    const auto others = patch::slide(mesh, vertex);
    if (!others)
        return {};
    const std::array points{point_of(mesh, vertex), point_of(mesh, (*others)[0]),
                            point_of(mesh, (*others)[1])};
    const int found = mesh.curves->find(points);
    if (found < 0)
        return {};
    const surface::Line &line = mesh.curves->lines()[static_cast<std::size_t>(found)];
    const geometry::Rail local{line, {1, 2}};
    return local.holds(points[0], points) ? geometry::Rail{line, *others} : geometry::Rail{};
}

std::vector<geometry::Rail> rails_of(const mesh::QuadMesh &mesh) {
    std::vector<geometry::Rail> rails;
    for (int v = 0; mesh.curves && v < mesh.n_vertices(); ++v)
        if (const geometry::Rail rail = rail_of(mesh, v)) {
            rails.resize(static_cast<std::size_t>(mesh.n_vertices()));
            rails[static_cast<std::size_t>(v)] = rail;
        }
    return rails;
}

} // namespace alphamst::adapt
