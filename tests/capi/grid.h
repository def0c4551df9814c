/* Meshes and questions that the tests of the C interface share. */
#ifndef ALPHAMST_TESTS_CAPI_GRID_H
#define ALPHAMST_TESTS_CAPI_GRID_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "alphamst/alphamst.h"

#define must(call) assert_int_equal((call), AMST_OK)
#define refused(status, call) assert_int_equal((call), (status))

static inline void *memory(size_t bytes) {
    void *p = malloc(bytes > 0 ? bytes : 1);
    assert_non_null(p);
    return p;
}

static inline amst_context *new_context(int32_t index_base) {
    amst_context *ctx = NULL;
    must(amst_context_create(index_base, &ctx));
    assert_non_null(ctx);
    return ctx;
}

/* [(nx + 1) * (ny + 1)][2]: vertex (i, j) has row j * (nx + 1) + i and lies there. */
static inline double *grid_points(int32_t nx, int32_t ny) {
    double *points = memory(sizeof(double) * 2 * (size_t)((nx + 1) * (ny + 1)));
    for (int32_t j = 0; j <= ny; ++j)
        for (int32_t i = 0; i <= nx; ++i) {
            points[2 * (j * (nx + 1) + i)] = i;
            points[2 * (j * (nx + 1) + i) + 1] = j;
        }
    return points;
}

/* [nx * ny][4]: face (i, j) has row j * nx + i. */
static inline int32_t *grid_faces(int32_t nx, int32_t ny, int32_t index_base) {
    int32_t *faces = memory(sizeof(int32_t) * 4 * (size_t)(nx * ny)), *to = faces;
    for (int32_t j = 0; j < ny; ++j)
        for (int32_t i = 0; i < nx; ++i) {
            const int32_t v = j * (nx + 1) + i + index_base;
            *to++ = v;
            *to++ = v + 1;
            *to++ = v + nx + 2;
            *to++ = v + nx + 1;
        }
    return faces;
}

static inline amst_mesh *new_grid(amst_context *ctx, int32_t index_base, int32_t nx, int32_t ny) {
    double *points = grid_points(nx, ny);
    int32_t *faces = grid_faces(nx, ny, index_base);
    amst_mesh *mesh = NULL;
    must(amst_mesh_create(ctx, 2, points, (int64_t)(nx + 1) * (ny + 1), 0, 0, faces, (int64_t)nx * ny, 0, 0,
                          4, NULL, &mesh));
    free(points);
    free(faces);
    return mesh;
}

/* The faces (i, j) with low <= i, j < high as one patch of a base-0 grid of nx columns. */
static inline amst_id add_square(amst_patches *set, int32_t nx, int32_t low, int32_t high) {
    amst_id *faces = memory(sizeof(amst_id) * (size_t)((high - low) * (high - low))), patch = -1;
    int64_t n = 0;
    for (int32_t j = low; j < high; ++j)
        for (int32_t i = low; i < high; ++i)
            faces[n++] = j * nx + i;
    must(amst_patches_add_faces(set, faces, n, &patch));
    free(faces);
    return patch;
}

static inline int64_t checksum(const amst_mesh *mesh) {
    int64_t digest = 0;
    must(amst_mesh_get_checksum(mesh, &digest));
    return digest;
}

static inline int64_t revision(const amst_mesh *mesh) {
    int64_t number = -1;
    must(amst_mesh_get_revision(mesh, &number));
    return number;
}

static inline int64_t count_of(const amst_mesh *mesh, int32_t entity) {
    int64_t n = -1;
    must(amst_mesh_get_count(mesh, entity, &n));
    return n;
}

static inline int64_t n_singular(const amst_mesh *mesh) {
    int64_t n = -1;
    must(amst_mesh_get_singularities(mesh, NULL, 0, &n));
    return n;
}

static inline double *points_of(const amst_mesh *mesh) {
    int64_t n = 0;
    must(amst_mesh_get_points(mesh, NULL, 0, &n));
    double *points = memory(sizeof(double) * (size_t)n);
    must(amst_mesh_get_points(mesh, points, n, &n));
    return points;
}

static inline amst_id *faces_of(const amst_mesh *mesh) {
    int64_t n = 0;
    must(amst_mesh_get_faces(mesh, NULL, 0, &n));
    amst_id *faces = memory(sizeof(amst_id) * (size_t)n);
    must(amst_mesh_get_faces(mesh, faces, n, &n));
    return faces;
}

static inline amst_id *origin_of(const amst_report *report, int32_t entity) {
    int64_t n = 0;
    must(amst_report_get_origin(report, entity, NULL, 0, &n));
    amst_id *origin = memory(sizeof(amst_id) * (size_t)n);
    must(amst_report_get_origin(report, entity, origin, n, &n));
    return origin;
}

static inline int64_t result(const amst_report *report, amst_id patch, int32_t key) {
    int64_t value = -1;
    must(amst_report_get_int(report, patch, key, &value));
    return value;
}

static inline double real_result(const amst_report *report, amst_id patch, int32_t key) {
    double value = -1;
    must(amst_report_get_real(report, patch, key, &value));
    return value;
}

static inline double worst_scaled_jacobian(const amst_mesh *mesh) {
    amst_summary summary;
    must(amst_mesh_get_summary(mesh, AMST_METRIC_SCALED_JACOBIAN, &summary));
    return summary.min;
}

static inline void assert_error_names(int32_t entity, amst_id id) {
    int32_t told_entity = -7;
    amst_id told_id = -7, told_patch = -7;
    must(amst_last_error_where(&told_entity, &told_id, &told_patch));
    assert_int_equal(told_entity, entity);
    assert_int_equal(told_id, id);
}

/* What a base-0 mesh was before an operation, to be held against what it became. */
typedef struct snapshot {
    int64_t n_vertices, n_faces;
    double *points;
    amst_id *faces;
    int32_t dim;
} snapshot;

static inline snapshot take_snapshot(const amst_mesh *mesh) {
    snapshot taken;
    taken.n_vertices = count_of(mesh, AMST_VERTEX);
    taken.n_faces = count_of(mesh, AMST_FACE);
    taken.points = points_of(mesh);
    taken.faces = faces_of(mesh);
    must(amst_mesh_get_dim(mesh, &taken.dim));
    return taken;
}

static inline void free_snapshot(snapshot *taken) {
    free(taken->points);
    free(taken->faces);
}

/* Every old vertex is where it was, bit for bit; every old face still has its corners;
 * exactly `replaced` faces are gone. */
static inline void assert_outside_same(const snapshot *before, const amst_mesh *mesh,
                                       const amst_report *report, int64_t replaced) {
    const int64_t n_vertices = count_of(mesh, AMST_VERTEX), n_faces = count_of(mesh, AMST_FACE);
    const size_t row = sizeof(double) * (size_t)before->dim;
    double *points = points_of(mesh);
    amst_id *faces = faces_of(mesh);
    amst_id *vertex_origin = origin_of(report, AMST_VERTEX), *face_origin = origin_of(report, AMST_FACE);
    for (int64_t v = 0; v < n_vertices; ++v)
        if (vertex_origin[v] != -1)
            assert_memory_equal(points + before->dim * v, before->points + before->dim * vertex_origin[v],
                                row);
    char *kept = calloc((size_t)before->n_faces, 1);
    assert_non_null(kept);
    int64_t n_kept = 0;
    for (int64_t f = 0; f < n_faces; ++f) {
        const amst_id old = face_origin[f];
        if (old == -1)
            continue;
        assert_in_range(old, 0, before->n_faces - 1);
        assert_int_equal(kept[old], 0);
        kept[old] = 1;
        ++n_kept;
        for (int c = 0; c < 4; ++c)
            assert_int_equal(vertex_origin[faces[4 * f + c]], before->faces[4 * old + c]);
    }
    assert_int_equal(n_kept, before->n_faces - replaced);
    free(kept);
    free(points);
    free(faces);
    free(vertex_origin);
    free(face_origin);
}

/* A grid of n x n squares with singularities: squares in it were refilled at alpha 2. */
static inline amst_mesh *new_disturbed(amst_context *ctx, int32_t n) {
    amst_mesh *mesh = new_grid(ctx, 0, n, n);
    amst_patches *set = NULL;
    must(amst_patches_create(mesh, NULL, &set));
    for (int32_t low = 2; low + 6 < n; low += 7)
        add_square(set, n, low, low + 6);
    must(amst_adapt(mesh, set, 1.5, NULL, NULL));
    amst_patches_destroy(set);
    assert_true(n_singular(mesh) > 4);
    return mesh;
}

#endif
