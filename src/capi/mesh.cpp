// What a mesh is asked, and its points.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <span>
#include <string>

#include "capi/array.h"
#include "capi/guard.h"
#include "capi/handles.h"
#include "capi/ids.h"
#include "index.h"
#include "mesh/sides.h"

namespace alphamst::capi {
namespace {

static_assert(sizeof(OpenMesh::Vec3d) == 3 * sizeof(double), "points are copied as packed rows");
static_assert(sizeof(std::array<int, 4>) == 4 * sizeof(amst_id), "faces are copied as packed rows");

const mesh::QuadMesh &current(const amst_mesh *mesh) { return *required(mesh, "mesh").impl->current; }

// Writes the numbers of two vertices or faces for each edge.
template <typename Pair>
void edge_pairs(const amst_mesh *handle, amst_id *out, std::int64_t capacity, std::int64_t *needed,
                Pair &&pair) {
    const mesh::QuadMesh &mesh = current(handle);
    if (!answer(out, capacity, needed, std::int64_t{2} * mesh.n_edges()))
        return;
    const int base = index_base(handle);
    for (int e = 0; e < mesh.n_edges(); ++e)
        for (const int index : pair(mesh, e))
            *out++ = capi::out(base, index);
}

// A solver asks what is beyond an edge: on the boundary nothing, whichever way the edge runs.
std::array<int, 2> inner_face_first(const mesh::QuadMesh &mesh, int edge) {
    const auto [left, right] = mesh.edge_faces(edge);
    return left < 0 ? std::array{right, left} : std::array{left, right};
}

template <std::size_t n>
void rows_of_ids(const std::vector<std::array<std::int32_t, n>> &rows, int base, amst_id *out,
                 std::int64_t capacity, std::int64_t *needed) {
    if (answer(out, capacity, needed, static_cast<std::int64_t>(n * rows.size())))
        for (const auto &row : rows)
            for (const std::int32_t id : row)
                *out++ = capi::out(base, id);
}

} // namespace

mesh::QuadMesh &Mesh::writable() {
    const auto shares = [&](const Savepoint &savepoint) { return savepoint.mesh == current; };
    if (std::any_of(savepoints.begin(), savepoints.end(), shares))
        current = std::make_shared<mesh::QuadMesh>(*current);
    return *current;
}

std::shared_ptr<Mesh> Mesh::clone(const std::shared_ptr<Context> &into) const {
    auto copy = std::make_shared<Mesh>(into, std::make_shared<mesh::QuadMesh>(*current));
    copy->revision = revision;
    copy->last_revision = last_revision;
    copy->at_creation = at_creation;
    return copy;
}

} // namespace alphamst::capi

using namespace alphamst;
using namespace alphamst::capi;

amst_status amst_mesh_clone(const amst_mesh *mesh, amst_mesh **out) {
    return guarded(index_base(mesh), [&] {
        const Mesh &from = *required(mesh, "mesh").impl;
        amst_mesh *&created = required(out, "out");
        std::shared_ptr<Mesh> copy = from.clone(from.context);
        copy->projection = from.projection;
        copy->projection_user = from.projection_user;
        created = new amst_mesh{std::move(copy)};
    });
}

amst_status amst_mesh_clone_into(const amst_mesh *mesh, amst_context *ctx, amst_mesh **out) {
    return guarded(index_base(mesh), [&] {
        const Mesh &from = *required(mesh, "mesh").impl;
        const std::shared_ptr<Context> &context = required(ctx, "ctx").impl;
        amst_mesh *&created = required(out, "out");
        created = new amst_mesh{from.clone(context)};
    });
}

void amst_mesh_destroy(amst_mesh *mesh) { delete mesh; }

amst_status amst_mesh_get_dim(const amst_mesh *mesh, std::int32_t *dim) {
    return guarded(index_base(mesh), [&] {
        const int value = current(mesh).dim();
        required(dim, "dim") = value;
    });
}

amst_status amst_mesh_get_count(const amst_mesh *mesh, std::int32_t entity, std::int64_t *count) {
    return guarded(index_base(mesh), [&] {
        const mesh::QuadMesh &asked = current(mesh);
        std::int64_t &told = required(count, "count");
        told = count_of(asked, entity_of(entity));
    });
}

amst_status amst_mesh_get_revision(const amst_mesh *mesh, std::int64_t *revision) {
    return guarded(index_base(mesh), [&] {
        const std::int64_t value = required(mesh, "mesh").impl->revision;
        required(revision, "revision") = value;
    });
}

amst_status amst_mesh_get_points(const amst_mesh *mesh, double *out, std::int64_t capacity,
                                 std::int64_t *needed) {
    return guarded(index_base(mesh), [&] {
        const mesh::QuadMesh &asked = current(mesh);
        const std::int64_t n = asked.n_vertices();
        if (!answer(out, capacity, needed, n * asked.dim()) || n == 0)
            return;
        const OpenMesh::Vec3d *points = asked.kernel().points();
        if (asked.dim() == 3) {
            std::memcpy(out, points, static_cast<std::size_t>(n) * sizeof *points);
            return;
        }
        for (std::int64_t v = 0; v < n; ++v) {
            out[2 * v] = points[v][0];
            out[2 * v + 1] = points[v][1];
        }
    });
}

amst_status amst_mesh_set_points(amst_mesh *mesh, const double *points, std::int64_t n) {
    return guarded(index_base(mesh), [&] {
        Mesh &target = *required(mesh, "mesh").impl;
        target.context->require_idle();
        require_array(points, n, "points", "n");
        const std::int64_t vertices = target.current->n_vertices();
        if (n != vertices)
            throw Failure(Fault::range, "n is " + std::to_string(n) + ", the mesh has " +
                                            std::to_string(vertices) + " vertices");
        const int dim = target.current->dim();
        std::vector<double> places(3 * at(n), 0);
        for (std::size_t v = 0; v < at(n); ++v)
            std::copy_n(points + v * at(dim), dim, places.data() + 3 * v);
        mesh::test_points(places);
        mesh::QuadMesh &changed = target.writable();
        for (std::size_t v = 0; v < at(n); ++v)
            changed.set_point(static_cast<int>(v), OpenMesh::Vec3d(places.data() + 3 * v));
    });
}

amst_status amst_mesh_get_faces(const amst_mesh *mesh, amst_id *out, std::int64_t capacity,
                                std::int64_t *needed) {
    return guarded(index_base(mesh), [&] {
        const std::span<const std::array<int, 4>> faces = current(mesh).faces();
        if (!answer(out, capacity, needed, static_cast<std::int64_t>(4 * faces.size())) || faces.empty())
            return;
        const int base = index_base(mesh);
        if (base == 0) {
            std::memcpy(out, faces.data(), faces.size_bytes());
            return;
        }
        for (const std::array<int, 4> &corners : faces)
            for (const int corner : corners)
                *out++ = capi::out(base, corner);
    });
}

amst_status amst_mesh_get_edges(const amst_mesh *mesh, amst_id *out, std::int64_t capacity,
                                std::int64_t *needed) {
    return guarded(index_base(mesh), [&] {
        edge_pairs(mesh, out, capacity, needed,
                   [](const mesh::QuadMesh &asked, int e) { return asked.edge_vertices(e); });
    });
}

amst_status amst_mesh_get_edge_faces(const amst_mesh *mesh, amst_id *out, std::int64_t capacity,
                                     std::int64_t *needed) {
    return guarded(index_base(mesh), [&] { edge_pairs(mesh, out, capacity, needed, inner_face_first); });
}

amst_status amst_mesh_get_vertex_faces(const amst_mesh *mesh, std::int32_t *offsets, amst_id *out,
                                       std::int64_t capacity, std::int64_t *needed) {
    return guarded(index_base(mesh), [&] {
        const mesh::QuadMesh &asked = current(mesh);
        if (!answer(out, capacity, needed, std::int64_t{4} * asked.n_faces()))
            return;
        std::int32_t *ends = &required(offsets, "offsets");
        const int base = index_base(mesh);
        std::vector<int> rows;
        std::vector<std::int32_t> begins{base};
        for (int v = 0; v < asked.n_vertices(); ++v) {
            const std::vector<int> around = asked.faces_around(v);
            rows.insert(rows.end(), around.begin(), around.end());
            begins.push_back(base + static_cast<std::int32_t>(rows.size()));
        }
        std::ranges::copy(begins, ends);
        std::ranges::transform(rows, out, [&](int face) { return capi::out(base, face); });
    });
}

amst_status amst_mesh_get_crossed_edges(const amst_mesh *mesh, amst_id *out, std::int64_t capacity,
                                        std::int64_t *needed) {
    return guarded(index_base(mesh), [&] {
        rows_of_ids(required(mesh, "mesh").impl->at_creation.crossed, index_base(mesh), out, capacity,
                    needed);
    });
}

amst_status amst_mesh_get_split_edges(const amst_mesh *mesh, amst_id *out, std::int64_t capacity,
                                      std::int64_t *needed) {
    return guarded(index_base(mesh), [&] {
        rows_of_ids(required(mesh, "mesh").impl->at_creation.split, index_base(mesh), out, capacity, needed);
    });
}

amst_status amst_mesh_find_edges(const amst_mesh *mesh, const amst_id *pairs, std::int64_t n,
                                 amst_id *edges) {
    return guarded(index_base(mesh), [&] {
        const mesh::QuadMesh &asked = current(mesh);
        require_array(pairs, n, "pairs", "n");
        require_array(edges, n, "edges", "n");
        const int base = index_base(mesh);
        for (std::int64_t i = 0; i < 2 * n; ++i)
            in(base, pairs[i], asked.n_vertices(), Entity::vertex);
        for (std::int64_t i = 0; i < n; ++i)
            edges[i] = capi::out(base, asked.find_edge(pairs[2 * i] - base, pairs[2 * i + 1] - base));
    });
}

amst_status amst_mesh_get_valences(const amst_mesh *mesh, std::int32_t *out, std::int64_t capacity,
                                   std::int64_t *needed) {
    return guarded(index_base(mesh), [&] {
        const mesh::QuadMesh &asked = current(mesh);
        if (!answer(out, capacity, needed, asked.n_vertices()))
            return;
        for (int v = 0; v < asked.n_vertices(); ++v)
            out[v] = asked.valence(v);
    });
}

amst_status amst_mesh_get_singularities(const amst_mesh *mesh, amst_id *out, std::int64_t capacity,
                                        std::int64_t *needed) {
    return guarded(index_base(mesh), [&] {
        const std::vector<int> vertices = current(mesh).singularities();
        if (!answer(out, capacity, needed, static_cast<std::int64_t>(vertices.size())))
            return;
        const int base = index_base(mesh);
        for (const int vertex : vertices)
            *out++ = capi::out(base, vertex);
    });
}

amst_status amst_mesh_check(const amst_mesh *mesh) {
    return guarded(index_base(mesh), [&] { current(mesh).check(); });
}

amst_status amst_mesh_get_checksum(const amst_mesh *mesh, std::int64_t *digest) {
    return guarded(index_base(mesh), [&] {
        const mesh::QuadMesh &asked = current(mesh);
        std::int64_t &told = required(digest, "digest");
        told = static_cast<std::int64_t>(asked.checksum());
    });
}
