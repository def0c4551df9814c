/* The cross field, and how much edges follow it. */
#include <math.h>

#include "grid.h"

static double alignment(const amst_mesh *mesh) {
    double degrees = -1;
    must(amst_mesh_get_alignment(mesh, &degrees));
    return degrees;
}

static double *cross_of(const amst_mesh *mesh) {
    int64_t n = 0;
    must(amst_mesh_get_field(mesh, AMST_FACE, "cross", NULL, 0, &n));
    assert_int_equal(n, 3 * count_of(mesh, AMST_FACE));
    double *cross = memory(sizeof(double) * (size_t)n);
    must(amst_mesh_get_field(mesh, AMST_FACE, "cross", cross, n, &n));
    return cross;
}

static void it_is_a_new_field_of_faces(void **state) {
    (void)state;
    amst_context *ctx = new_context(1);
    amst_mesh *mesh = new_grid(ctx, 1, 6, 4);
    const int64_t before = checksum(mesh);
    double degrees = -7;
    refused(AMST_ERR_NOT_FOUND, amst_mesh_get_alignment(mesh, &degrees));
    assert_true(degrees == -7);
    must(amst_mesh_compute_cross_field(mesh, NULL));
    double *cross = cross_of(mesh);
    for (int f = 0; f < 24; ++f) {
        assert_true(fabs(fabs(cross[3 * f]) + fabs(cross[3 * f + 1]) - 1) < 1e-9); /* along x or y */
        assert_true(cross[3 * f + 2] == 0);
    }
    free(cross);
    assert_true(alignment(mesh) < 1e-9);
    assert_true(checksum(mesh) == before);
    assert_int_equal(revision(mesh), 0);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void it_replaces_one_that_was_given(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 3, 3);
    double given[27];
    int64_t mark;
    for (int f = 0; f < 9; ++f) {
        given[3 * f] = cos(0.5);
        given[3 * f + 1] = sin(0.5);
        given[3 * f + 2] = 0;
    }
    must(amst_mesh_set_field(mesh, AMST_FACE, "cross", 3, AMST_CARRY_DROP, given, 9));
    assert_true(fabs(alignment(mesh) - 0.5 * 180 / 3.14159265358979) < 1e-9);
    must(amst_mesh_mark(mesh, &mark));
    must(amst_mesh_compute_cross_field(mesh, NULL));
    assert_true(alignment(mesh) < 1e-9);
    must(amst_mesh_rollback(mesh, mark));
    double *cross = cross_of(mesh);
    assert_memory_equal(cross, given, sizeof given);
    free(cross);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void it_is_of_faces_and_has_three_components(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 2, 2);
    const double values[36] = {0};
    int64_t n;
    refused(AMST_ERR_RANGE, amst_mesh_set_field(mesh, AMST_FACE, "cross", 2, AMST_CARRY_DROP, values, 4));
    refused(AMST_ERR_ARGUMENT,
            amst_mesh_set_field(mesh, AMST_VERTEX, "cross", 3, AMST_CARRY_DROP, values, 9));
    refused(AMST_ERR_ARGUMENT, amst_mesh_set_field(mesh, AMST_EDGE, "cross", 3, AMST_CARRY_DROP, values, 12));
    refused(AMST_ERR_NOT_FOUND, amst_mesh_get_field(mesh, AMST_FACE, "cross", NULL, 0, &n));
    must(amst_mesh_set_field(mesh, AMST_FACE, "cross", 3, AMST_CARRY_DROP, values, 4));
    assert_true(alignment(mesh) == 0); /* no direction anywhere */
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void new_faces_inherit_it(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 10, 10);
    amst_patches *set = NULL;
    must(amst_mesh_compute_cross_field(mesh, NULL));
    must(amst_patches_create(mesh, NULL, &set));
    add_square(set, 10, 2, 8);
    must(amst_adapt(mesh, set, 2, NULL, NULL));
    assert_int_equal(count_of(mesh, AMST_FACE), 136);
    double *cross = cross_of(mesh);
    for (int f = 0; f < 136; ++f)
        assert_true(fabs(fabs(cross[3 * f]) + fabs(cross[3 * f + 1]) - 1) < 1e-9);
    free(cross);
    assert_true(alignment(mesh) > 0.1 && alignment(mesh) < 22.5); /* a template has slanted edges */
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

/* A tube whose edges wind: around the seam of n columns by n / 4 of them. */
static amst_mesh *new_tube(amst_context *ctx) {
    enum { n = 24, m = 12 };
    double points[3 * n * (m + 1)];
    int32_t faces[4 * n * m];
    amst_mesh *mesh = NULL;
    for (int j = 0; j <= m; ++j)
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * 3.14159265358979 * (i + 0.5 * j) / n;
            points[3 * (j * n + i)] = cos(angle);
            points[3 * (j * n + i) + 1] = sin(angle);
            points[3 * (j * n + i) + 2] = 0.26 * j;
        }
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const int32_t corners[4] = {j * n + i, j * n + (i + 1) % n, (j + 1) * n + (i + 1) % n,
                                        (j + 1) * n + i};
            memcpy(faces + 4 * (j * n + i), corners, sizeof corners);
        }
    must(amst_mesh_create(ctx, 3, points, n * (m + 1), 0, 0, faces, n * m, 0, 0, 4, NULL, &mesh));
    return mesh;
}

static void it_follows_curvature(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_tube(ctx);
    must(amst_mesh_compute_cross_field(mesh, NULL));
    double *cross = cross_of(mesh);
    for (int f = 0; f < 288; ++f) {
        const double along = fabs(cross[3 * f + 2]);
        assert_true(along < 0.02 || along > 0.9998); /* a degree, about */
    }
    free(cross);
    assert_true(fabs(alignment(mesh) - 13.3) < 0.5); /* half of atan(0.5 * 0.26 / 0.26) */
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_is_a_new_field_of_faces),
        cmocka_unit_test(it_replaces_one_that_was_given),
        cmocka_unit_test(it_is_of_faces_and_has_three_components),
        cmocka_unit_test(new_faces_inherit_it),
        cmocka_unit_test(it_follows_curvature),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
