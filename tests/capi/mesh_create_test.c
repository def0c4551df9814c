/* Meshes from arrays: layouts that mean the same mesh, and input that is none. */
#include <math.h>

#include "grid.h"

enum { nx = 4, ny = 3, n_vertices = 20, n_faces = 12 };

static amst_status create(amst_context *ctx, int32_t dim, const double *points, int64_t nv,
                          const int32_t *faces, int64_t nf, amst_mesh **out) {
    return amst_mesh_create(ctx, dim, points, nv, 0, 0, faces, nf, 0, 0, 4, NULL, out);
}

static void layouts_agree(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *packed = new_grid(ctx, 0, nx, ny), *mesh = NULL;
    double *points = grid_points(nx, ny);
    int32_t *faces = grid_faces(nx, ny, 0);

    /* structure of arrays; corners one after the other, 64 bits wide */
    double by_component[2 * n_vertices];
    int64_t by_corner[4 * n_faces];
    for (int v = 0; v < n_vertices; ++v)
        for (int c = 0; c < 2; ++c)
            by_component[c * n_vertices + v] = points[2 * v + c];
    for (int f = 0; f < n_faces; ++f)
        for (int c = 0; c < 4; ++c)
            by_corner[c * n_faces + f] = faces[4 * f + c];
    must(amst_mesh_create_i64(ctx, 2, by_component, n_vertices, 1, n_vertices, by_corner, n_faces, 1, n_faces,
                              4, NULL, &mesh));
    assert_true(checksum(mesh) == checksum(packed));
    amst_mesh_destroy(mesh);

    /* padded rows */
    double padded[5 * n_vertices];
    int32_t padded_faces[6 * n_faces];
    for (int i = 0; i < 5 * n_vertices; ++i)
        padded[i] = NAN;
    for (int i = 0; i < 6 * n_faces; ++i)
        padded_faces[i] = -77;
    for (int v = 0; v < n_vertices; ++v)
        memcpy(padded + 5 * v, points + 2 * v, 2 * sizeof(double));
    for (int f = 0; f < n_faces; ++f)
        memcpy(padded_faces + 6 * f, faces + 4 * f, 4 * sizeof(int32_t));
    must(amst_mesh_create(ctx, 2, padded, n_vertices, 5, 1, padded_faces, n_faces, 6, 1, 4, NULL, &mesh));
    assert_true(checksum(mesh) == checksum(packed));
    amst_mesh_destroy(mesh);

    /* other numbering */
    amst_context *ctx1 = new_context(1);
    mesh = new_grid(ctx1, 1, nx, ny);
    assert_true(checksum(mesh) == checksum(packed));
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx1);

    amst_mesh_destroy(packed);
    amst_context_destroy(ctx);
    free(points);
    free(faces);
}

static void unreferenced_vertices_stay(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    const double points[12] = {9, 9, 0, 0, 1, 0, 1, 1, 0, 1, 8, 8};
    const int32_t face[4] = {1, 2, 3, 4};
    int32_t valences[6];
    int64_t n;
    amst_mesh *mesh = NULL;
    must(create(ctx, 2, points, 6, face, 1, &mesh));
    assert_int_equal(count_of(mesh, AMST_VERTEX), 6);
    must(amst_mesh_get_valences(mesh, valences, 6, &n));
    assert_int_equal(valences[0], 0);
    assert_int_equal(valences[1], 2);
    assert_int_equal(n_singular(mesh), 0);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void bad_numbers_are_refused(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    double *points = grid_points(nx, ny);
    int32_t *faces = grid_faces(nx, ny, 0);
    amst_mesh *mesh = NULL;
    points[2 * 7] = NAN;
    refused(AMST_ERR_NOT_FINITE, create(ctx, 2, points, n_vertices, faces, n_faces, &mesh));
    assert_error_names(AMST_VERTEX, 7);
    points[2 * 7] = -INFINITY;
    refused(AMST_ERR_NOT_FINITE, create(ctx, 2, points, n_vertices, faces, n_faces, &mesh));
    points[2 * 7] = 2;

    faces[4 * 5 + 2] = n_vertices;
    refused(AMST_ERR_RANGE, create(ctx, 2, points, n_vertices, faces, n_faces, &mesh));
    assert_error_names(AMST_FACE, 5);
    faces[4 * 5 + 2] = -1;
    refused(AMST_ERR_RANGE, create(ctx, 2, points, n_vertices, faces, n_faces, &mesh));
    assert_error_names(AMST_FACE, 5);
    faces[4 * 5 + 2] = faces[4 * 5];
    refused(AMST_ERR_NOT_QUAD, create(ctx, 2, points, n_vertices, faces, n_faces, &mesh));
    assert_error_names(AMST_FACE, 5);
    assert_null(mesh);
    free(points);
    free(faces);
    amst_context_destroy(ctx);
}

static void corners_of_64_bits_must_fit(void **state) {
    (void)state;
    const double points[8] = {0, 0, 1, 0, 1, 1, 0, 1};
    const int64_t bad[] = {INT64_C(4294967296), INT64_MAX, INT64_MIN, INT64_C(2147483648), -1, 6};
    for (int32_t base = 0; base <= 1; ++base) {
        amst_context *ctx = new_context(base);
        for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
            const int64_t face[4] = {base, 1 + base, bad[i], 3 + base};
            amst_mesh *mesh = NULL;
            refused(AMST_ERR_RANGE,
                    amst_mesh_create_i64(ctx, 2, points, 4, 0, 0, face, 1, 0, 0, 4, NULL, &mesh));
            assert_error_names(AMST_FACE, base);
            assert_null(mesh);
        }
        amst_context_destroy(ctx);
    }
}

static void base_1_has_no_vertex_0(void **state) {
    (void)state;
    const double points[8] = {0, 0, 1, 0, 1, 1, 0, 1};
    const int32_t zero[4] = {0, 1, 2, 3}, least[4] = {INT32_MIN, 1, 2, 3}, good[4] = {1, 2, 3, 4};
    amst_context *ctx = new_context(1);
    amst_mesh *mesh = NULL;
    refused(AMST_ERR_RANGE, create(ctx, 2, points, 4, zero, 1, &mesh));
    assert_error_names(AMST_FACE, 1);
    refused(AMST_ERR_RANGE, create(ctx, 2, points, 4, least, 1, &mesh));
    must(create(ctx, 2, points, 4, good, 1, &mesh));
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void shapes_of_arrays_are_checked(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    double *points = grid_points(nx, ny);
    int32_t *faces = grid_faces(nx, ny, 0);
    amst_mesh *mesh = NULL;
    refused(AMST_ERR_ARGUMENT, create(ctx, 1, points, n_vertices, faces, n_faces, &mesh));
    refused(AMST_ERR_ARGUMENT, create(ctx, 4, points, n_vertices, faces, n_faces, &mesh));
    refused(AMST_ERR_ARGUMENT,
            amst_mesh_create(ctx, 2, points, n_vertices, 0, 0, faces, n_faces, 0, 0, 2, NULL, &mesh));
    refused(AMST_ERR_RANGE, create(ctx, 2, points, -1, faces, n_faces, &mesh));
    refused(AMST_ERR_RANGE, create(ctx, 2, points, n_vertices, faces, -1, &mesh));
    refused(AMST_ERR_RANGE, create(ctx, 2, points, n_vertices, faces, 0, &mesh));
    refused(AMST_ERR_RANGE, create(ctx, 2, points, n_vertices, NULL, 0, &mesh));
    refused(AMST_ERR_RANGE, create(ctx, 2, NULL, 0, faces, n_faces, &mesh));
    refused(AMST_ERR_RANGE, create(ctx, 2, points, INT64_MAX, faces, n_faces, &mesh));
    refused(AMST_ERR_RANGE, create(ctx, 2, points, n_vertices, faces, INT64_C(100000000000), &mesh));
    const int64_t strides[][2] = {{-2, 1}, {2, -1}, {0, 1}, {2, 0}, {INT64_MIN, 1}};
    for (size_t i = 0; i < sizeof strides / sizeof *strides; ++i) {
        refused(AMST_ERR_ARGUMENT, amst_mesh_create(ctx, 2, points, n_vertices, strides[i][0], strides[i][1],
                                                    faces, n_faces, 0, 0, 4, NULL, &mesh));
        refused(AMST_ERR_ARGUMENT, amst_mesh_create(ctx, 2, points, n_vertices, 0, 0, faces, n_faces,
                                                    strides[i][0], strides[i][1], 4, NULL, &mesh));
    }
    refused(AMST_ERR_RANGE,
            amst_mesh_create(ctx, 2, points, n_vertices, INT64_MAX, 1, faces, n_faces, 0, 0, 4, NULL, &mesh));
    refused(AMST_ERR_RANGE, amst_mesh_create(ctx, 2, points, n_vertices, 0, 0, faces, n_faces, 4,
                                             INT64_MAX / 2, 4, NULL, &mesh));
    assert_null(mesh);
    free(points);
    free(faces);
    amst_context_destroy(ctx);
}

/* The faces of the grid cut along a diagonal, in every layout and numbering. */
static void triangles_become_quads(void **state) {
    (void)state;
    double *points = grid_points(nx, ny);
    for (int32_t base = 0; base < 2; ++base) {
        amst_context *ctx = new_context(base);
        amst_mesh *grid = new_grid(ctx, base, nx, ny), *mesh = NULL;
        int32_t *faces = grid_faces(nx, ny, base);
        int32_t three[6 * n_faces], four[8 * n_faces];
        int64_t by_corner[6 * n_faces];
        for (int f = 0; f < n_faces; ++f)
            for (int t = 0; t < 2; ++t)
                for (int k = 0; k < 4; ++k) {
                    const int32_t v = k == 3 ? base - 1 : faces[4 * f + (k == 0 ? 0 : k + t)];
                    four[8 * f + 4 * t + k] = v;
                    if (k < 3) {
                        three[6 * f + 3 * t + k] = v;
                        by_corner[k * 2 * n_faces + 2 * f + t] = v;
                    }
                }
        must(amst_mesh_create(ctx, 2, points, n_vertices, 0, 0, three, 2 * n_faces, 0, 0, 3, NULL, &mesh));
        assert_int_equal(count_of(mesh, AMST_FACE), n_faces);
        assert_int_equal(count_of(mesh, AMST_VERTEX), n_vertices);
        double *kept = points_of(mesh);
        assert_memory_equal(kept, points, 2 * n_vertices * sizeof(double));
        free(kept);
        must(amst_mesh_check(mesh));
        const int64_t digest = checksum(mesh);
        amst_mesh_destroy(mesh);
        must(amst_mesh_create(ctx, 2, points, n_vertices, 0, 0, four, 2 * n_faces, 0, 0, 4, NULL, &mesh));
        assert_true(checksum(mesh) == digest);
        amst_mesh_destroy(mesh);
        must(amst_mesh_create_i64(ctx, 2, points, n_vertices, 0, 0, by_corner, 2 * n_faces, 1, 2 * n_faces, 3,
                                  NULL, &mesh));
        assert_true(checksum(mesh) == digest);
        amst_mesh_destroy(mesh);

        /* One left over: a vertex on the boundary more, and no flat corner there. */
        must(
            amst_mesh_create(ctx, 2, points, n_vertices, 0, 0, three, 2 * n_faces - 1, 0, 0, 3, NULL, &mesh));
        assert_int_equal(count_of(mesh, AMST_FACE), n_faces + 4);
        assert_int_equal(count_of(mesh, AMST_VERTEX), n_vertices + 5);
        must(amst_mesh_check(mesh));
        amst_mesh_destroy(mesh);

        /* "none" is for the last of four corners only */
        mesh = NULL;
        four[2] = base - 1;
        refused(AMST_ERR_RANGE,
                amst_mesh_create(ctx, 2, points, n_vertices, 0, 0, four, 2 * n_faces, 0, 0, 4, NULL, &mesh));
        assert_error_names(AMST_FACE, base);
        three[3] = three[4];
        refused(AMST_ERR_NOT_QUAD,
                amst_mesh_create(ctx, 2, points, n_vertices, 0, 0, three, 2 * n_faces, 0, 0, 3, NULL, &mesh));
        assert_error_names(AMST_FACE, base + 1);
        assert_null(mesh);
        amst_mesh_destroy(grid);
        amst_context_destroy(ctx);
        free(faces);
    }
    free(points);
}

static void what_is_no_surface_is_refused(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = NULL;
    double points[60];
    for (int i = 0; i < 60; ++i)
        points[i] = (i * 37) % 23;
    const int32_t three_at_an_edge[12] = {0, 1, 2, 3, 0, 1, 4, 5, 1, 0, 6, 7};
    refused(AMST_ERR_NOT_MANIFOLD, create(ctx, 3, points, 20, three_at_an_edge, 3, &mesh));
    const int32_t moebius[12] = {0, 1, 2, 3, 3, 2, 4, 5, 5, 4, 0, 1}; /* closes with a half turn */
    refused(AMST_ERR_NOT_MANIFOLD, create(ctx, 3, points, 20, moebius, 3, &mesh));
    const int32_t twice[8] = {0, 1, 2, 3, 3, 0, 1, 2};
    refused(AMST_ERR_NOT_MANIFOLD, create(ctx, 3, points, 20, twice, 2, &mesh));
    assert_error_names(AMST_FACE, 1);
    assert_string_equal(amst_last_error(), "face 1 has the vertices of face 0; leave one of the two out");
    const int32_t touching[8] = {0, 1, 2, 3, 0, 4, 5, 6}; /* two fans at vertex 0 */
    refused(AMST_ERR_NOT_MANIFOLD, create(ctx, 3, points, 20, touching, 2, &mesh));
    assert_error_names(AMST_VERTEX, 0);
    const int32_t triangles[8] = {0, 1, 2, 2, 2, 1, 4, 4};
    refused(AMST_ERR_NOT_QUAD, create(ctx, 3, points, 20, triangles, 2, &mesh));
    assert_null(mesh);
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(layouts_agree),           cmocka_unit_test(unreferenced_vertices_stay),
        cmocka_unit_test(bad_numbers_are_refused), cmocka_unit_test(corners_of_64_bits_must_fit),
        cmocka_unit_test(base_1_has_no_vertex_0),  cmocka_unit_test(shapes_of_arrays_are_checked),
        cmocka_unit_test(triangles_become_quads),  cmocka_unit_test(what_is_no_surface_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
