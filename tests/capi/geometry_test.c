/* Centroids, lengths and normals; faces around vertices. */
#include <math.h>

#include "grid.h"

/* A grid of faces of all shapes in the plane, or the same bent over a cylinder. */
static amst_mesh *new_mesh(amst_context *ctx, int32_t dim) {
    double *flat = grid_points(6, 6), points[3 * 49];
    int32_t *faces = grid_faces(6, 6, 0);
    for (int v = 0; v < 49; ++v) {
        const double x = flat[2 * v] + 0.2 * sin(5 * v), y = flat[2 * v + 1] + 0.2 * cos(7 * v);
        points[dim * v] = dim == 2 ? x : 4 * sin(x / 4);
        points[dim * v + 1] = y;
        if (dim == 3)
            points[3 * v + 2] = 4 * cos(x / 4);
    }
    amst_mesh *mesh = NULL;
    must(amst_mesh_create(ctx, dim, points, 49, 0, 0, faces, 36, 0, 0, 4, NULL, &mesh));
    free(flat);
    free(faces);
    return mesh;
}

enum { n_faces = 36, n_edges = 84 };

static void normals_point_out_of_the_first_face(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    for (int32_t dim = 2; dim <= 3; ++dim) {
        amst_mesh *mesh = new_mesh(ctx, dim);
        double centroids[3 * n_faces], lengths[n_edges], normals[3 * n_edges];
        amst_id edges[2 * n_edges], sides[2 * n_edges];
        int64_t n;
        must(amst_mesh_get_geometry(mesh, AMST_GEOMETRY_CENTROIDS, centroids, 3 * n_faces, &n));
        assert_int_equal(n, dim * n_faces);
        must(amst_mesh_get_geometry(mesh, AMST_GEOMETRY_LENGTHS, lengths, n_edges, &n));
        must(amst_mesh_get_geometry(mesh, AMST_GEOMETRY_NORMALS, normals, 3 * n_edges, &n));
        assert_int_equal(n, dim * n_edges);
        must(amst_mesh_get_edges(mesh, edges, 2 * n_edges, &n));
        must(amst_mesh_get_edge_faces(mesh, sides, 2 * n_edges, &n));
        double *points = points_of(mesh);
        for (int e = 0; e < n_edges; ++e) {
            double length = 0, size = 0, along = 0, out = 0;
            for (int c = 0; c < dim; ++c) {
                const double a = points[dim * edges[2 * e] + c], b = points[dim * edges[2 * e + 1] + c];
                const double normal = normals[dim * e + c];
                length += (b - a) * (b - a);
                along += (b - a) * normal;
                size += normal * normal;
                out += normal * ((a + b) / 2 - centroids[dim * sides[2 * e] + c]);
            }
            assert_true(fabs(lengths[e] - sqrt(length)) < 1e-14);
            assert_true(fabs(size - 1) < 1e-14);
            assert_true(fabs(along) < 1e-14);
            assert_true(out > 0.1);
        }
        free(points);
        amst_mesh_destroy(mesh);
    }
    amst_context_destroy(ctx);
}

/* What Gauss says of a linear function, which a solver relies on: normals around a face close, and they
 * balance its area. */
static void normals_close_around_faces(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_mesh(ctx, 2);
    double lengths[n_edges], normals[2 * n_edges], sums[3 * n_faces] = {0}, areas[n_faces];
    amst_id edges[2 * n_edges], sides[2 * n_edges];
    int64_t n;
    must(amst_mesh_get_geometry(mesh, AMST_GEOMETRY_LENGTHS, lengths, n_edges, &n));
    must(amst_mesh_get_geometry(mesh, AMST_GEOMETRY_NORMALS, normals, 2 * n_edges, &n));
    must(amst_mesh_get_edges(mesh, edges, 2 * n_edges, &n));
    must(amst_mesh_get_edge_faces(mesh, sides, 2 * n_edges, &n));
    must(amst_mesh_get_quality(mesh, AMST_METRIC_AREA, areas, n_faces, &n));
    double *points = points_of(mesh);
    for (int e = 0; e < n_edges; ++e) {
        const double x = (points[2 * edges[2 * e]] + points[2 * edges[2 * e + 1]]) / 2;
        for (int side = 0; side < 2; ++side)
            if (sides[2 * e + side] >= 0) {
                double *sum = sums + 3 * sides[2 * e + side];
                const double part = (side == 0 ? 1 : -1) * lengths[e];
                sum[0] += part * normals[2 * e];
                sum[1] += part * normals[2 * e + 1];
                sum[2] += part * normals[2 * e] * x;
            }
    }
    for (int f = 0; f < n_faces; ++f) {
        assert_true(fabs(sums[3 * f]) < 1e-14 && fabs(sums[3 * f + 1]) < 1e-14);
        assert_true(fabs(sums[3 * f + 2] - areas[f]) < 1e-14);
    }
    free(points);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void centroids_are_those_of_the_area(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    const double corners[8] = {0, 0, 3, 0, 1, 2, 0, 2}; /* a trapezium: its centre is (1, 1) */
    const int32_t face[4] = {0, 1, 2, 3};
    double centroid[2];
    int64_t n;
    amst_mesh *mesh = NULL;
    must(amst_mesh_create(ctx, 2, corners, 4, 0, 0, face, 1, 0, 0, 4, NULL, &mesh));
    must(amst_mesh_get_geometry(mesh, AMST_GEOMETRY_CENTROIDS, centroid, 2, &n));
    assert_true(fabs(centroid[0] - 13.0 / 12) < 1e-15);
    assert_true(fabs(centroid[1] - 5.0 / 6) < 1e-15);
    refused(AMST_ERR_ARGUMENT, amst_mesh_get_geometry(mesh, 3, centroid, 2, &n));
    refused(AMST_ERR_ARGUMENT, amst_mesh_get_geometry(mesh, -1, NULL, 0, &n));
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void faces_are_around_their_vertices(void **state) {
    (void)state;
    for (int32_t base = 0; base <= 1; ++base) {
        amst_context *ctx = new_context(base);
        amst_mesh *mesh = new_grid(ctx, base, 3, 2);
        int32_t offsets[13];
        amst_id around[24], *faces = faces_of(mesh);
        int64_t n;
        must(amst_mesh_get_vertex_faces(mesh, offsets, around, 24, &n));
        assert_int_equal(n, 24);
        assert_int_equal(offsets[0], base);
        assert_int_equal(offsets[12], base + 24);
        for (int v = 0; v < 12; ++v)
            for (int32_t i = offsets[v] - base; i < offsets[v + 1] - base; ++i) {
                int at = 0, next = 0; /* the face after it begins with the edge that it ends with */
                const amst_id *face = faces + 4 * (around[i] - base);
                while (face[at] != v + base)
                    assert_true(++at < 4);
                if (i + 1 == offsets[v + 1] - base)
                    continue;
                const amst_id *after = faces + 4 * (around[i + 1] - base);
                while (after[next] != v + base)
                    assert_true(++next < 4);
                assert_int_equal(after[(next + 1) % 4], face[(at + 3) % 4]);
            }
        refused(AMST_ERR_NULL, amst_mesh_get_vertex_faces(mesh, NULL, around, 24, &n));
        must(amst_mesh_get_vertex_faces(mesh, NULL, NULL, 0, &n));
        free(faces);
        amst_mesh_destroy(mesh);
        amst_context_destroy(ctx);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(normals_point_out_of_the_first_face),
        cmocka_unit_test(normals_close_around_faces),
        cmocka_unit_test(centroids_are_those_of_the_area),
        cmocka_unit_test(faces_are_around_their_vertices),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
