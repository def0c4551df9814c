// What a code needs of faces and edges that solves on the mesh.
#include <string>

#include "capi/array.h"
#include "capi/guard.h"
#include "capi/handles.h"
#include "geometry/quad.h"
#include "reference/locate.h"

namespace alphamst::capi {
namespace {

// At right angles to the edge and, on curved meshes, to the mean normal of its faces; out of its left face,
// or on the boundary out of the one there is.
Eigen::Vector3d edge_normal(const mesh::QuadMesh &mesh, int edge) {
    const auto [v, w] = mesh.edge_vertices(edge);
    const auto [left, right] = mesh.edge_faces(edge);
    Eigen::Vector3d up = Eigen::Vector3d::Zero();
    for (const int face : {left, right})
        if (face >= 0)
            up += geometry::area_vector(reference::quad_of(mesh, face)).normalized();
    const Eigen::Vector3d along = (reference::point_of(mesh, w) - reference::point_of(mesh, v)).normalized();
    const Eigen::Vector3d out = along.cross(up).normalized();
    return left < 0 ? Eigen::Vector3d(-out) : out;
}

double length(const mesh::QuadMesh &mesh, int edge) {
    const auto [v, w] = mesh.edge_vertices(edge);
    return (reference::point_of(mesh, w) - reference::point_of(mesh, v)).norm();
}

// One row of dim numbers for each of n entities.
template <class Vector>
void rows(int n, int dim, double *out, std::int64_t capacity, std::int64_t *needed, Vector &&vector) {
    if (!answer(out, capacity, needed, std::int64_t{n} * dim))
        return;
    for (int i = 0; i < n; ++i) {
        const Eigen::Vector3d row = vector(i);
        for (int c = 0; c < dim; ++c)
            *out++ = row[c];
    }
}

} // namespace
} // namespace alphamst::capi

using namespace alphamst;
using namespace alphamst::capi;

amst_status amst_mesh_get_geometry(const amst_mesh *mesh, std::int32_t key, double *out,
                                   std::int64_t capacity, std::int64_t *needed) {
    return guarded(index_base(mesh), [&] {
        const mesh::QuadMesh &asked = *required(mesh, "mesh").impl->current;
        switch (key) {
        case AMST_GEOMETRY_CENTROIDS:
            return rows(asked.n_faces(), asked.dim(), out, capacity, needed,
                        [&](int face) { return geometry::area_centroid(reference::quad_of(asked, face)); });
        case AMST_GEOMETRY_LENGTHS:
            if (answer(out, capacity, needed, asked.n_edges()))
                for (int e = 0; e < asked.n_edges(); ++e)
                    out[e] = length(asked, e);
            return;
        case AMST_GEOMETRY_NORMALS:
            return rows(asked.n_edges(), asked.dim(), out, capacity, needed,
                        [&](int edge) { return edge_normal(asked, edge); });
        default:
            throw Failure(Fault::argument,
                          "there is no geometry " + std::to_string(key) + "; ask for one of amst_geometry");
        }
    });
}
