/* What one patch of a set is asked. */
#include <math.h>

#include "patches.h"

static void faces_come_back_ascending_and_once(void **state) {
    (void)state;
    const amst_id given[6] = {12, 1, 11, 2, 12, 1}, wanted[4] = {1, 2, 11, 12};
    amst_id patch = -1, faces[4];
    int64_t n;
    must(amst_patches_add_faces(set, given, 6, &patch));
    assert_int_equal(patch, 0);
    must(amst_patches_get_faces(set, patch, faces, 4, &n));
    assert_int_equal(n, 4);
    assert_memory_equal(faces, wanted, sizeof wanted);
    assert_int_equal(defects_of(patch), 0);
}

static void without_repair_defects_are_told(void **state) {
    (void)state;
    const amst_id frame[8] = {0, 1, 2, 10, 12, 20, 21, 22}, apart[2] = {55, 57}, touching[2] = {88, 99};
    int64_t n;
    must(amst_patches_add_faces(set, frame, 8, NULL));
    must(amst_patches_add_faces(set, apart, 2, NULL));
    must(amst_patches_add_faces(set, touching, 2, NULL));
    assert_true(defects_of(0) & AMST_DEFECT_NOT_DISK);
    assert_true(defects_of(1) & AMST_DEFECT_NOT_CONNECTED);
    assert_true(defects_of(2) & AMST_DEFECT_PINCHED);
    for (amst_id patch = 0; patch < 3; ++patch) {
        amst_id told = -7;
        refused(AMST_ERR_PATCH, amst_patches_get_boundary(set, patch, NULL, 0, &n));
        must(amst_last_error_where(NULL, NULL, &told));
        assert_int_equal(told, patch);
        if (patch == 0) { /* a ring is refilled in parts */
            must(amst_patches_predict(set, patch, 1, NULL, &n, NULL));
            assert_int_equal(n, 8);
            continue;
        }
        refused(AMST_ERR_PATCH, amst_patches_predict(set, patch, 1, NULL, NULL, NULL));
        amst_id place = -9;
        must(amst_last_error_where(NULL, NULL, &place));
        assert_int_equal(place, patch);
    }
}

static void features_inside_are_defects(void **state) {
    (void)state;
    amst_id pair[2] = {3 * 11 + 3, 3 * 11 + 4}, edge;
    add_square(set, 10, 2, 5);
    assert_int_equal(defects_of(0), 0);
    must(amst_mesh_find_edges(mesh, pair, 1, &edge));
    must(amst_mesh_set_flags(mesh, AMST_EDGE, &edge, 1, AMST_FLAG_FEATURE, AMST_FLAG_FEATURE));
    assert_int_equal(defects_of(0), AMST_DEFECT_CROSSES_FEATURE);
}

static void boundary_starts_at_the_first_corner(void **state) {
    (void)state;
    enum { n_loop = 12 };
    amst_id loop[n_loop], corners[4];
    int64_t n;
    add_square(set, 10, 2, 5);
    must(amst_patches_get_corners(set, 0, corners, 4, &n));
    assert_int_equal(n, 4);
    must(amst_patches_get_boundary(set, 0, loop, n_loop, &n));
    assert_int_equal(n, n_loop);
    assert_int_equal(loop[0], corners[0]);
    double *points = points_of(mesh), area = 0;
    for (int i = 0; i < n_loop; ++i) {
        const double *p = points + 2 * loop[i], *q = points + 2 * loop[(i + 1) % n_loop];
        assert_true(hypot(q[0] - p[0], q[1] - p[1]) == 1);
        area += (p[0] * q[1] - q[0] * p[1]) / 2;
    }
    assert_true(area == 9); /* positive: counter-clockwise */
    free(points);

    const amst_id given[3] = {5 * 11 + 5, 5 * 11 + 2, 2 * 11 + 3};
    must(amst_patches_set_corners(set, 0, given, 3));
    must(amst_patches_get_corners(set, 0, corners, 4, &n));
    assert_int_equal(n, 3);
    assert_memory_equal(corners, given, sizeof given);
    must(amst_patches_get_boundary(set, 0, loop, n_loop, &n));
    assert_int_equal(loop[0], given[0]);
    assert_int_equal(defects_of(0), 0);
    must(amst_patches_set_corners(set, 0, NULL, 0));
    must(amst_patches_get_corners(set, 0, corners, 4, &n));
    assert_int_equal(n, 4);
}

static void convexity_is_a_remark(void **state) {
    (void)state;
    const amst_id cross[5] = {45, 44, 46, 35, 55}; /* 5 of a hull of 7 */
    int32_t defects = -1;
    double convexity = -1;
    add_square(set, 10, 0, 3);
    must(amst_patches_check(set, 0, &defects, &convexity));
    assert_int_equal(defects, 0);
    assert_true(fabs(convexity - 1) < 1e-12);
    must(amst_patches_add_faces(set, cross, 5, NULL));
    must(amst_patches_check(set, 1, &defects, &convexity));
    assert_int_equal(defects, 0);
    assert_true(fabs(convexity - 5.0 / 7) < 1e-12);

    amst_options *strict = NULL;
    amst_patches *other = NULL;
    must(amst_options_create(&strict));
    must(amst_options_set_real(strict, AMST_OPT_MIN_CONVEXITY, 0.8));
    must(amst_patches_create(mesh, strict, &other));
    amst_options_destroy(strict);
    must(amst_patches_add_faces(other, cross, 5, NULL));
    must(amst_patches_check(other, 0, &defects, NULL));
    assert_int_equal(defects, AMST_DEFECT_NOT_CONVEX);
    amst_patches_destroy(other);
}

static void prediction_needs_a_usable_alpha(void **state) {
    (void)state;
    int64_t faces = -5, singularities = -5;
    add_square(set, 10, 2, 6);
    must(amst_patches_predict(set, 0, 1, NULL, &faces, &singularities));
    assert_int_equal(faces, 16);
    assert_int_equal(singularities, 0);
    must(amst_patches_predict(set, 0, 2, NULL, &faces, NULL));
    assert_int_equal(faces, 32);
    refused(AMST_ERR_ARGUMENT, amst_patches_predict(set, 0, 0, NULL, &faces, NULL));
    refused(AMST_ERR_ARGUMENT, amst_patches_predict(set, 0, -1, NULL, &faces, NULL));
    refused(AMST_ERR_NOT_FINITE, amst_patches_predict(set, 0, NAN, NULL, &faces, NULL));
    refused(AMST_ERR_RANGE, amst_patches_predict(set, 1, 1, NULL, &faces, NULL));
    assert_int_equal(faces, 32);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(faces_come_back_ascending_and_once, setup, teardown),
        cmocka_unit_test_setup_teardown(without_repair_defects_are_told, setup_plain, teardown),
        cmocka_unit_test_setup_teardown(features_inside_are_defects, setup, teardown),
        cmocka_unit_test_setup_teardown(boundary_starts_at_the_first_corner, setup, teardown),
        cmocka_unit_test_setup_teardown(convexity_is_a_remark, setup, teardown),
        cmocka_unit_test_setup_teardown(prediction_needs_a_usable_alpha, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
