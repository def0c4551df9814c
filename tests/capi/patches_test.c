/* Choosing patches. */
#include <math.h>

#include "patches.h"

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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(rings_ball_and_box, setup, teardown),
        cmocka_unit_test_setup_teardown(taken_and_fixed_faces_are_left_out, setup, teardown),
        cmocka_unit_test_setup_teardown(without_repair_overlap_is_refused, setup_plain, teardown),
        cmocka_unit_test_setup_teardown(repair_makes_disks, setup, teardown),
        cmocka_unit_test_setup_teardown(bad_corners, setup, teardown),
        cmocka_unit_test_setup_teardown(decompositions_cover_the_rest, setup, teardown),
        cmocka_unit_test_setup_teardown(discs_lie_in_circles, setup, teardown),
        cmocka_unit_test_setup_teardown(singularities_have_patches, setup, teardown),
        cmocka_unit_test_setup_teardown(bad_arguments_add_nothing, setup, teardown),
        cmocka_unit_test_setup_teardown(alpha_of_a_patch, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
