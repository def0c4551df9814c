#include "smooth/align.h"

#include "geometry/align.h"
#include "smooth/relax.h"
#include "smooth/shaping.h"

namespace alphamst::smooth {

void align_to_field(mesh::QuadMesh &mesh, reference::Reference &reference,
                    const reference::CrossField &cross_field, const Settings &settings) {
    std::vector<Eigen::Vector3d> directions;
    for (int f = 0; f < mesh.n_faces(); ++f) {
        const geometry::Quad corners = reference::quad_of(mesh, f);
        directions.push_back(cross_field.at(geometry::centre(corners)));
    }
    const std::vector<char> fixed = constrained_vertices(mesh);
    for (int round = 0; round < 5; ++round) {
        const geometry::SurfacePositions start = reference.on_surface(mesh);
        geometry::SurfacePositions on_surface = start;
        const std::vector<double> areas = reference.areas(mesh.faces(), on_surface);
        geometry::EmbedOptions options = shaping(settings);
        options.area = areas;
        geometry::align(*reference.surface, mesh.faces(), fixed, directions, on_surface, options);
        if (!accept_or_roll_back(mesh, reference, start, on_surface, {}))
            break;
    }
}

} // namespace alphamst::smooth
