/* Choosing patches, and what a patch is asked. */
#include <math.h>

#include "grid.h"

static amst_context *ctx;
static amst_mesh *mesh;
static amst_patches *set;

static int setup_with(const amst_options *options) {
    ctx = new_context(0);
    mesh = new_grid(ctx, 0, 10, 10);
    must(amst_patches_create(mesh, options, &set));
    return 0;
}

static int setup(void **state) {
    (void)state;
    return setup_with(NULL);
}

static int setup_plain(void **state) {
    (void)state;
    amst_options *options = NULL;
    must(amst_options_create(&options));
    must(amst_options_set_int(options, AMST_OPT_REPAIR_PATCHES, 0));
    setup_with(options);
    amst_options_destroy(options);
    return 0;
}

static int teardown(void **state) {
    (void)state;
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
    return 0;
}

static int64_t n_patches(void) {
    int64_t n = -1;
    must(amst_patches_get_count(set, &n));
    return n;
}

static int64_t n_faces(amst_id patch) {
    int64_t n = -1;
    must(amst_patches_get_faces(set, patch, NULL, 0, &n));
    return n;
}

static int32_t defects_of(amst_id patch) {
    int32_t defects = -1;
    must(amst_patches_check(set, patch, &defects, NULL));
    return defects;
}

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

static void rings_ball_and_box(void **state) {
    (void)state;
    const double center[3] = {8, 8, 0}, low[3] = {0, 6, -1}, high[3] = {3, 9, 1};
    amst_id patch = -1;
    must(amst_patches_add_rings(set, 2 * 11 + 2, 2, &patch)); /* around (2, 2) */
    assert_int_equal(patch, 0);
    assert_int_equal(n_faces(0), 16);
    must(amst_patches_add_ball(set, center, 1, &patch));
    assert_int_equal(patch, 1);
    assert_int_equal(n_faces(1), 4);
    must(amst_patches_add_box(set, low, high, &patch));
    assert_int_equal(patch, 2);
    assert_int_equal(n_faces(2), 9);
    must(amst_patches_add_rings(set, 2 * 11 + 8, 1, NULL));
    assert_int_equal(n_patches(), 4);
}

static void taken_and_fixed_faces_are_left_out(void **state) {
    (void)state;
    const amst_id fixed[1] = {0}, three[3] = {0, 1, 2}, two[2] = {1, 2};
    must(amst_mesh_set_flags(mesh, AMST_FACE, fixed, 1, AMST_FLAG_FIXED, AMST_FLAG_FIXED));
    must(amst_patches_add_faces(set, three, 3, NULL));
    assert_int_equal(n_faces(0), 2);
    refused(AMST_ERR_PATCH, amst_patches_add_faces(set, two, 2, NULL));
    refused(AMST_ERR_PATCH, amst_patches_add_faces(set, fixed, 1, NULL));
    refused(AMST_ERR_PATCH, amst_patches_add_faces(set, NULL, 0, NULL));
    assert_int_equal(n_patches(), 1);
}

static void without_repair_overlap_is_refused(void **state) {
    (void)state;
    const amst_id first[2] = {4, 5}, second[3] = {6, 5, 7};
    must(amst_patches_add_faces(set, first, 2, NULL));
    refused(AMST_ERR_PATCH, amst_patches_add_faces(set, second, 3, NULL));
    int32_t entity;
    amst_id id, patch;
    must(amst_last_error_where(&entity, &id, &patch));
    assert_int_equal(entity, AMST_FACE);
    assert_int_equal(id, 5);
    assert_int_equal(patch, 0);
    assert_int_equal(n_patches(), 1);
}

static void repair_makes_disks(void **state) {
    (void)state;
    const amst_id frame[8] = {0, 1, 2, 10, 12, 20, 21, 22}; /* around face 11 */
    must(amst_patches_add_faces(set, frame, 8, NULL));
    assert_int_equal(n_faces(0), 9);
    assert_int_equal(defects_of(0), 0);
    const amst_id apart[3] = {55, 56, 99};
    must(amst_patches_add_faces(set, apart, 3, NULL));
    assert_int_equal(n_faces(1), 2);
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

static void bad_corners(void **state) {
    (void)state;
    add_square(set, 10, 2, 5);
    const amst_id inside[3] = {24, 27, 36}, turned[3] = {24, 57, 27}, twice[3] = {24, 24, 27};
    const amst_id none[3] = {24, 27, 121}, many[7] = {24, 25, 26, 27, 38, 49, 60};
    refused(AMST_ERR_RANGE, amst_patches_set_corners(set, 0, many, 2));
    refused(AMST_ERR_RANGE, amst_patches_set_corners(set, 0, many, 7));
    refused(AMST_ERR_RANGE, amst_patches_set_corners(set, 0, many, -3));
    refused(AMST_ERR_RANGE, amst_patches_set_corners(set, 1, many, 3));
    refused(AMST_ERR_RANGE, amst_patches_set_corners(set, 0, none, 3));
    assert_error_names(AMST_VERTEX, 121);
    assert_int_equal(defects_of(0), 0);
    must(amst_patches_set_corners(set, 0, inside, 3));
    assert_int_equal(defects_of(0), AMST_DEFECT_CORNERS);
    must(amst_patches_set_corners(set, 0, turned, 3));
    assert_int_equal(defects_of(0), AMST_DEFECT_CORNERS);
    must(amst_patches_set_corners(set, 0, twice, 3));
    assert_int_equal(defects_of(0), AMST_DEFECT_CORNERS);
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

static void decompositions_cover_the_rest(void **state) {
    (void)state;
    const int32_t methods[] = {AMST_DECOMPOSE_CLUSTERS, AMST_DECOMPOSE_PARTITION, AMST_DECOMPOSE_VORONOI};
    for (size_t k = 0; k < sizeof methods / sizeof *methods; ++k) {
        amst_options *options = NULL;
        int64_t added = -1, n = 0, covered = 0;
        amst_patches_destroy(set);
        must(amst_options_create(&options));
        must(amst_options_set_real(options, AMST_OPT_PATCH_FACES, 12));
        must(amst_patches_create(mesh, options, &set));
        amst_options_destroy(options);
        add_square(set, 10, 0, 3);
        must(amst_patches_decompose(set, methods[k], &added));
        assert_true(added >= 4);
        assert_int_equal(n_patches(), added + 1);
        char taken[100] = {0};
        for (amst_id patch = 0; patch <= added; ++patch) {
            amst_id faces[100];
            assert_int_equal(defects_of(patch) & ~AMST_DEFECT_NOT_CONVEX, 0);
            must(amst_patches_get_faces(set, patch, faces, 100, &n));
            for (int64_t i = 0; i < n; ++i) {
                assert_int_equal(taken[faces[i]], 0);
                taken[faces[i]] = 1;
                ++covered;
            }
        }
        assert_true(covered >= 80);
    }
    refused(AMST_ERR_ARGUMENT, amst_patches_decompose(set, AMST_DECOMPOSE_SINGULARITIES + 1, NULL));
    refused(AMST_ERR_ARGUMENT, amst_patches_decompose(set, AMST_DECOMPOSE_INVALID, NULL));
}

static void discs_lie_in_circles(void **state) {
    (void)state;
    amst_options *options = NULL;
    int64_t added = -1, n = 0;
    amst_id disc[100];
    must(amst_options_create(&options));
    must(amst_options_set_real(options, AMST_OPT_PATCH_FACES, 100));
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    mesh = new_grid(ctx, 0, 11, 11);
    must(amst_patches_create(mesh, options, &set));
    amst_options_destroy(options);
    must(amst_patches_decompose(set, AMST_DECOMPOSE_MEDIAL, &added));
    assert_int_equal(added, 1); /* in the corners there is no room for 25 faces */
    must(amst_patches_get_faces(set, 0, disc, 100, &n));
    for (amst_id face = 0, k = 0; face < 121; ++face) { /* centre (5.5, 5.5), radius 5.5 */
        const double x = abs((int)face % 11 - 5) + 0.5, y = abs((int)face / 11 - 5) + 0.5;
        if (x * x + y * y <= 5.5 * 5.5)
            assert_int_equal(disc[k++], face);
        else
            assert_true(k == n || disc[k] > face);
    }
    assert_int_equal(defects_of(0) & ~AMST_DEFECT_NOT_CONVEX, 0);
}

/* In a grid there are none: 0 patches and no error. */
static void singularities_have_patches(void **state) {
    (void)state;
    const double points[7][2] = {{0, 0}, {2, 0}, {1, 2}, {-1, 2}, {-2, 0}, {-1, -2}, {1, -2}};
    const int32_t quads[3][4] = {{0, 1, 2, 3}, {0, 3, 4, 5}, {0, 5, 6, 1}};
    int64_t added = -1;
    must(amst_patches_decompose(set, AMST_DECOMPOSE_SINGULARITIES, &added));
    assert_int_equal(added, 0);
    assert_int_equal(n_patches(), 0);

    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    must(amst_mesh_create(ctx, 2, points[0], 7, 0, 0, quads[0], 3, 0, 0, 4, NULL, &mesh));
    must(amst_patches_create(mesh, NULL, &set));
    must(amst_patches_decompose(set, AMST_DECOMPOSE_SINGULARITIES, &added));
    assert_int_equal(added, 1);
    assert_int_equal(n_faces(0), 3);
    assert_int_equal(defects_of(0) & ~AMST_DEFECT_NOT_CONVEX, 0);
}

static void bad_arguments_add_nothing(void **state) {
    (void)state;
    const amst_id bad[2] = {5, 100};
    const double center[3] = {1, 1, 0}, odd[3] = {1, NAN, 0}, far[3] = {5, 5, 500},
                 endless[3] = {0, 0, INFINITY};
    amst_id patch = 77;
    refused(AMST_ERR_RANGE, amst_patches_add_faces(set, bad, 2, &patch));
    assert_error_names(AMST_FACE, 100);
    refused(AMST_ERR_RANGE, amst_patches_add_faces(set, bad, -1, &patch));
    refused(AMST_ERR_RANGE, amst_patches_add_rings(set, 121, 1, &patch));
    assert_error_names(AMST_VERTEX, 121);
    refused(AMST_ERR_RANGE, amst_patches_add_rings(set, 0, 0, &patch));
    refused(AMST_ERR_NOT_FINITE, amst_patches_add_ball(set, odd, 1, &patch));
    refused(AMST_ERR_NOT_FINITE, amst_patches_add_ball(set, center, NAN, &patch));
    refused(AMST_ERR_ARGUMENT, amst_patches_add_ball(set, center, -1, &patch));
    refused(AMST_ERR_PATCH, amst_patches_add_ball(set, far, 1, &patch));
    refused(AMST_ERR_NOT_FINITE, amst_patches_add_box(set, center, endless, &patch));
    refused(AMST_ERR_ARGUMENT, amst_patches_add_box(set, far, center, &patch));
    refused(AMST_ERR_PATCH, amst_patches_add_box(set, far, far, &patch));
    assert_int_equal(patch, 77);
    assert_int_equal(n_patches(), 0);
    int64_t n;
    refused(AMST_ERR_RANGE, amst_patches_get_faces(set, 0, NULL, 0, &n));
    refused(AMST_ERR_RANGE, amst_patches_get_faces(set, -1, NULL, 0, &n));
    refused(AMST_ERR_RANGE, amst_patches_get_faces(set, AMST_ALL, NULL, 0, &n));
}

static void alpha_of_a_patch(void **state) {
    (void)state;
    add_square(set, 10, 2, 5);
    must(amst_patches_set_alpha(set, 0, 1.5));
    must(amst_patches_set_alpha(set, AMST_ALL, 0));
    refused(AMST_ERR_ARGUMENT, amst_patches_set_alpha(set, 0, -0.5));
    refused(AMST_ERR_NOT_FINITE, amst_patches_set_alpha(set, 0, NAN));
    refused(AMST_ERR_NOT_FINITE, amst_patches_set_alpha(set, AMST_ALL, INFINITY));
    refused(AMST_ERR_RANGE, amst_patches_set_alpha(set, 1, 1));
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
        cmocka_unit_test_setup_teardown(rings_ball_and_box, setup, teardown),
        cmocka_unit_test_setup_teardown(taken_and_fixed_faces_are_left_out, setup, teardown),
        cmocka_unit_test_setup_teardown(without_repair_overlap_is_refused, setup_plain, teardown),
        cmocka_unit_test_setup_teardown(repair_makes_disks, setup, teardown),
        cmocka_unit_test_setup_teardown(without_repair_defects_are_told, setup_plain, teardown),
        cmocka_unit_test_setup_teardown(features_inside_are_defects, setup, teardown),
        cmocka_unit_test_setup_teardown(boundary_starts_at_the_first_corner, setup, teardown),
        cmocka_unit_test_setup_teardown(bad_corners, setup, teardown),
        cmocka_unit_test_setup_teardown(convexity_is_a_remark, setup, teardown),
        cmocka_unit_test_setup_teardown(decompositions_cover_the_rest, setup, teardown),
        cmocka_unit_test_setup_teardown(discs_lie_in_circles, setup, teardown),
        cmocka_unit_test_setup_teardown(singularities_have_patches, setup, teardown),
        cmocka_unit_test_setup_teardown(bad_arguments_add_nothing, setup, teardown),
        cmocka_unit_test_setup_teardown(alpha_of_a_patch, setup, teardown),
        cmocka_unit_test_setup_teardown(prediction_needs_a_usable_alpha, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
