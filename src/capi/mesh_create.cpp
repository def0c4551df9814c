// Meshes from arrays.
#include <limits>
#include <string>
#include <vector>

#include "capi/guard.h"
#include "capi/handles.h"
#include "capi/limits.h"
#include "capi/options.h"
#include "capi/remarks.h"
#include "capi/triangles.h"
#include "mesh/orient.h"

namespace alphamst::capi {
namespace {

// A matrix in the caller's memory: row i, column j at first[i * row + j * column].
template <typename T> struct Strided {
    const T *first;
    std::int64_t rows;
    int columns;
    std::int64_t row, column;

    bool packed() const { return column == 1 && row == columns; }
    const T &operator()(std::int64_t i, int j) const { return first[i * row + j * column]; }
};

template <typename T>
Strided<T> strided(const T *first, std::int64_t rows, int columns, std::int64_t row, std::int64_t column,
                   const char *row_name, const char *column_name) {
    if (row == 0 && column == 0)
        return {first, rows, columns, columns, 1};
    if (row <= 0 || column <= 0)
        throw Failure(Fault::argument, std::string(row_name) + " and " + column_name +
                                           " must both be positive, or both 0 for packed rows");
    constexpr std::int64_t most = std::numeric_limits<std::ptrdiff_t>::max() / std::int64_t{sizeof(T)};
    const std::int64_t last_column = columns - 1;
    if (column > most / last_column || (rows > 1 && row > (most - last_column * column) / (rows - 1)))
        throw Failure(Fault::range, std::string(row_name) + " and " + column_name +
                                        " reach beyond the address space of this machine");
    return {first, rows, columns, row, column};
}

// The caller's own array where it is laid out as the mesh wants it, else a copy in `kept`.
std::span<const double> points_of(const Strided<double> &coords, std::vector<double> &kept) {
    if (coords.columns == 3 && coords.packed())
        return {coords.first, static_cast<std::size_t>(coords.rows) * 3};
    kept.resize(static_cast<std::size_t>(coords.rows) * 3);
    double *to = kept.data();
    for (std::int64_t v = 0; v < coords.rows; ++v, to += 3)
        for (int c = 0; c < coords.columns; ++c)
            to[c] = coords(v, c);
    return kept;
}

// Rows of four, the last corner of a triangle being -1. Corners that are no vertices stay such.
template <typename Id>
std::span<const std::int32_t> faces_of(const Strided<Id> &corners, int index_base,
                                       std::vector<std::int32_t> &kept) {
    if constexpr (std::is_same_v<Id, std::int32_t>)
        if (index_base == 0 && corners.columns == 4 && corners.packed())
            return {corners.first, static_cast<std::size_t>(corners.rows) * 4};
    kept.resize(static_cast<std::size_t>(corners.rows) * 4, -1);
    for (std::int64_t f = 0; f < corners.rows; ++f) {
        std::int32_t *to = kept.data() + 4 * f;
        for (int c = 0; c < corners.columns; ++c) {
            const std::int64_t id = corners(f, c);
            using Limits = std::numeric_limits<std::int32_t>;
            if (id < Limits::min() + 1 || id > Limits::max())
                throw Failure(Fault::range,
                              "face {} has corner " + std::to_string(id) +
                                  ", which does not fit in 32 bits; correct the corner",
                              Entity::face, {f});
            *to++ = static_cast<std::int32_t>(id - index_base);
        }
    }
    return kept;
}

mesh::QuadMesh build(const Context &context, int dim, std::span<const double> points,
                     std::span<const std::int32_t> faces, const Options &options, EdgeChanges &changes) {
    const auto edges = edges_to_keep(options, context.index_base, faces);
    if (!mesh::any_triangle(faces))
        return mesh::QuadMesh::build(dim, points, faces);
    const quadrangulate::QuadArrays quads =
        quads_of(context, "amst_mesh_create", {points, faces, {}, edges}, options);
    changes = changes_in(quads);
    return mesh::QuadMesh::build(dim, quads.points, quads.faces);
}

template <typename Id>
void create(amst_context *ctx, std::int32_t dim, const double *coords, std::int64_t n_vertices,
            std::int64_t vertex_stride, std::int64_t component_stride, const Id *faces, std::int64_t n_faces,
            std::int64_t face_stride, std::int64_t corner_stride, std::int32_t corners_per_face,
            const amst_options *options, amst_mesh **out) {
    const std::shared_ptr<Context> context = required(ctx, "ctx").impl; // whatever a callback destroys
    amst_mesh *&created = required(out, "out");
    require_array(coords, n_vertices, "coords", "n_vertices");
    require_array(faces, n_faces, "faces", "n_faces");
    if (dim != 2 && dim != 3)
        throw Failure(Fault::argument, "dim must be 2 or 3, it is " + std::to_string(dim));
    if (corners_per_face != 3 && corners_per_face != 4)
        throw Failure(Fault::argument,
                      "corners_per_face must be 3 or 4, it is " + std::to_string(corners_per_face));
    require_size(n_vertices, n_faces);
    const auto points = strided(coords, n_vertices, dim, vertex_stride, component_stride, "vertex_stride",
                                "component_stride");
    const auto corners =
        strided(faces, n_faces, corners_per_face, face_stride, corner_stride, "face_stride", "corner_stride");
    std::vector<double> kept_points;
    std::vector<std::int32_t> kept_faces;
    const auto given_points = points_of(points, kept_points);
    const auto given_faces = faces_of(corners, context->index_base, kept_faces);
    const mesh::Oriented oriented = mesh::orient(dim, given_points, given_faces);
    EdgeChanges changes;
    // Built in place: the kernel has no move constructor.
    std::shared_ptr<mesh::QuadMesh> mesh(new mesh::QuadMesh(
        build(*context, dim, given_points, oriented.faces.empty() ? given_faces : oriented.faces,
              options_of(options), changes)));
    auto made = std::make_shared<Mesh>(context, std::move(mesh));
    made->at_creation = std::move(changes);
    say_turned(*context, "amst_mesh_create", oriented, corners.rows);
    say_oddities(*context, "amst_mesh_create", *made->current);
    created = new amst_mesh{std::move(made)};
}

} // namespace
} // namespace alphamst::capi

using namespace alphamst;
using namespace alphamst::capi;

amst_status amst_mesh_create(amst_context *ctx, std::int32_t dim, const double *coords,
                             std::int64_t n_vertices, std::int64_t vertex_stride,
                             std::int64_t component_stride, const std::int32_t *faces, std::int64_t n_faces,
                             std::int64_t face_stride, std::int64_t corner_stride,
                             std::int32_t corners_per_face, const amst_options *options, amst_mesh **out) {
    return guarded(index_base(ctx), [&] {
        create(ctx, dim, coords, n_vertices, vertex_stride, component_stride, faces, n_faces, face_stride,
               corner_stride, corners_per_face, options, out);
    });
}

amst_status amst_mesh_create_i64(amst_context *ctx, std::int32_t dim, const double *coords,
                                 std::int64_t n_vertices, std::int64_t vertex_stride,
                                 std::int64_t component_stride, const std::int64_t *faces,
                                 std::int64_t n_faces, std::int64_t face_stride, std::int64_t corner_stride,
                                 std::int32_t corners_per_face, const amst_options *options,
                                 amst_mesh **out) {
    return guarded(index_base(ctx), [&] {
        create(ctx, dim, coords, n_vertices, vertex_stride, component_stride, faces, n_faces, face_stride,
               corner_stride, corners_per_face, options, out);
    });
}
