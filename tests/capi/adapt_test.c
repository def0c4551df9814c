/* amst_adapt: exact counts, nothing changed outside, the set moves along. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <unistd.h>

#include "grid.h"

static void counts_are_exact_and_the_outside_is_untouched(void **state) {
    (void)state;
    const double alphas[] = {1, 1.5, 2, 4};
    for (size_t k = 0; k < sizeof alphas / sizeof *alphas; ++k) {
        amst_context *ctx = new_context(0);
        amst_mesh *mesh = new_grid(ctx, 0, 10, 10);
        amst_patches *set = NULL;
        amst_report *report = NULL;
        must(amst_patches_create(mesh, NULL, &set));
        add_square(set, 10, 2, 8);
        const int64_t wanted = (int64_t)lround(36 * alphas[k]);
        int64_t predicted, predicted_singular;
        must(amst_patches_predict(set, 0, alphas[k], NULL, &predicted, &predicted_singular));
        assert_int_equal(predicted, wanted);
        snapshot before = take_snapshot(mesh);
        must(amst_adapt(mesh, set, alphas[k], NULL, &report));
        must(amst_mesh_check(mesh));
        assert_int_equal(count_of(mesh, AMST_FACE), 100 - 36 + wanted);
        assert_int_equal(result(report, 0, AMST_RESULT_STATUS), AMST_OK);
        assert_int_equal(result(report, 0, AMST_RESULT_FACES_BEFORE), 36);
        assert_int_equal(result(report, 0, AMST_RESULT_FACES_WANTED), wanted);
        assert_int_equal(result(report, 0, AMST_RESULT_FACES_AFTER), wanted);
        /* At alpha = 1 a regular grid has nothing to gain and comes back as it was. */
        assert_outside_same(&before, mesh, report, alphas[k] == 1 ? 0 : 36);
        assert_true(worst_scaled_jacobian(mesh) > 0);
        assert_int_equal(n_singular(mesh), predicted_singular);
        free_snapshot(&before);
        amst_report_destroy(report);
        amst_patches_destroy(set);
        amst_mesh_destroy(mesh);
        amst_context_destroy(ctx);
    }
}

/* Fewer faces than the boundary asks for may be impossible: then the patch stays. */
static void simplification_delivers_or_leaves(void **state) {
    (void)state;
    const double alphas[] = {0.5, 0.8};
    for (size_t k = 0; k < sizeof alphas / sizeof *alphas; ++k) {
        amst_context *ctx = new_context(0);
        amst_mesh *mesh = new_grid(ctx, 0, 12, 12);
        amst_patches *set = NULL;
        amst_report *report = NULL;
        must(amst_patches_create(mesh, NULL, &set));
        add_square(set, 12, 2, 10);
        const int64_t digest = checksum(mesh), wanted = (int64_t)lround(64 * alphas[k]);
        snapshot before = take_snapshot(mesh);
        const amst_status status = amst_adapt(mesh, set, alphas[k], NULL, &report);
        must(amst_mesh_check(mesh));
        assert_int_equal(result(report, 0, AMST_RESULT_FACES_WANTED), wanted);
        const int64_t after = result(report, 0, AMST_RESULT_FACES_AFTER);
        if (result(report, 0, AMST_RESULT_STATUS) < 0) {
            assert_int_equal(status, AMST_PARTIAL);
            assert_int_equal(after, 64);
            assert_true(checksum(mesh) == digest);
            assert_int_equal(revision(mesh), 0);
        } else {
            assert_int_equal(status, after == wanted ? AMST_OK : AMST_PARTIAL);
            assert_in_range(after, wanted - 2, wanted + 2);
            assert_int_equal(count_of(mesh, AMST_FACE), 144 - 64 + after);
            assert_outside_same(&before, mesh, report, 64);
        }
        free_snapshot(&before);
        amst_report_destroy(report);
        amst_patches_destroy(set);
        amst_mesh_destroy(mesh);
        amst_context_destroy(ctx);
    }
}

static void each_patch_may_have_its_own_alpha(void **state) {
    (void)state;
    amst_context *ctx = new_context(1);
    amst_mesh *mesh = new_grid(ctx, 1, 12, 12);
    amst_patches *set = NULL;
    amst_report *report = NULL;
    const double low[3] = {1, 1, 0}, middle[3] = {5, 5, 0}, high[3] = {11, 11, 0};
    must(amst_patches_create(mesh, NULL, &set));
    must(amst_patches_add_box(set, low, middle, NULL));  /* 16 faces */
    must(amst_patches_add_box(set, middle, high, NULL)); /* 36 faces */
    must(amst_patches_set_alpha(set, 2, 1.5));
    must(amst_adapt(mesh, set, 2, NULL, &report));
    must(amst_mesh_check(mesh));
    assert_int_equal(result(report, 1, AMST_RESULT_FACES_AFTER), 32);
    assert_int_equal(result(report, 2, AMST_RESULT_FACES_AFTER), 54);
    assert_int_equal(result(report, AMST_ALL, AMST_RESULT_FACES_BEFORE), 52);
    assert_int_equal(result(report, AMST_ALL, AMST_RESULT_FACES_AFTER), 86);
    assert_int_equal(count_of(mesh, AMST_FACE), 144 - 52 + 86);
    amst_report_destroy(report);
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void the_set_moves_along(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 12, 12);
    amst_patches *set = NULL, *other = NULL;
    int64_t n, needed;
    must(amst_patches_create(mesh, NULL, &set));
    must(amst_patches_create(mesh, NULL, &other));
    add_square(set, 12, 1, 5);
    add_square(set, 12, 6, 11);
    must(amst_adapt(mesh, set, 2, NULL, NULL));
    assert_int_equal(revision(mesh), 1);
    for (amst_id patch = 0; patch < 2; ++patch) {
        int32_t defects = -1;
        must(amst_patches_get_faces(set, patch, NULL, 0, &n));
        assert_int_equal(n, patch == 0 ? 32 : 50);
        amst_id *faces = memory(sizeof(amst_id) * (size_t)n);
        must(amst_patches_get_faces(set, patch, faces, n, &needed));
        for (int64_t i = 1; i < n; ++i)
            assert_true(faces[i - 1] < faces[i]);
        assert_true(faces[n - 1] < count_of(mesh, AMST_FACE));
        free(faces);
        must(amst_patches_check(set, patch, &defects, NULL));
        assert_int_equal(defects, 0);
        must(amst_patches_get_boundary(set, patch, NULL, 0, &n));
        assert_int_equal(n, patch == 0 ? 16 : 20);
    }
    refused(AMST_ERR_STALE, amst_patches_add_rings(other, 0, 1, NULL));
    refused(AMST_ERR_STALE, amst_adapt(mesh, other, 2, NULL, NULL));
    must(amst_adapt(mesh, set, 0.5, NULL, NULL)); /* and back: 16 and 25 faces */
    assert_int_equal(count_of(mesh, AMST_FACE), 144);
    assert_int_equal(revision(mesh), 2);
    amst_patches_destroy(set);
    amst_patches_destroy(other);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void what_cannot_be_adapted_is_left(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 12, 12);
    amst_options *plain = NULL;
    amst_patches *set = NULL;
    amst_report *report = NULL;
    const amst_id apart[2] = {0, 2};
    must(amst_options_create(&plain));
    must(amst_options_set_int(plain, AMST_OPT_REPAIR_PATCHES, 0));
    must(amst_patches_create(mesh, plain, &set));
    must(amst_patches_add_faces(set, apart, 2, NULL));
    add_square(set, 12, 6, 10);
    assert_int_equal(amst_adapt(mesh, set, 2, NULL, &report), AMST_PARTIAL);
    assert_int_equal(result(report, AMST_ALL, AMST_RESULT_STATUS), AMST_PARTIAL);
    assert_int_equal(result(report, 0, AMST_RESULT_STATUS), AMST_ERR_PATCH);
    assert_int_equal(result(report, 0, AMST_RESULT_FACES_BEFORE), 2);
    assert_int_equal(result(report, 0, AMST_RESULT_FACES_AFTER), 2);
    assert_int_equal(result(report, 1, AMST_RESULT_STATUS), AMST_OK);
    assert_int_equal(result(report, 1, AMST_RESULT_FACES_AFTER), 32);
    assert_int_equal(count_of(mesh, AMST_FACE), 144 + 16);
    amst_report_destroy(report);
    amst_patches_destroy(set);
    amst_options_destroy(plain);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

/* Parts are filled after one another; what is wished stays that of the mesh at first. */
static void a_ring_with_wished_sizes_gets_its_count(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 20, 20);
    amst_patches *set = NULL;
    amst_id ring[400];
    double sizes[21 * 21];
    int64_t n = 0, faces = 0;
    for (amst_id f = 0; f < 400; ++f)
        if (f % 20 < 5 || f % 20 >= 15 || f / 20 < 5 || f / 20 >= 15)
            ring[n++] = f;
    for (int v = 0; v < 21 * 21; ++v)
        sizes[v] = 1;
    must(amst_mesh_set_field(mesh, AMST_VERTEX, "size", 1, AMST_CARRY_LINEAR, sizes, 21 * 21));
    must(amst_patches_create(mesh, NULL, &set));
    must(amst_patches_add_faces(set, ring, n, NULL));
    must(amst_patches_predict(set, 0, 1.5, NULL, &faces, NULL));
    assert_int_equal(faces, 450);
    must(amst_adapt(mesh, set, 1.5, NULL, NULL));
    assert_int_equal(count_of(mesh, AMST_FACE), 400 + 150);
    must(amst_mesh_get_field(mesh, AMST_VERTEX, "size", NULL, 0, &n));
    assert_int_equal(n, count_of(mesh, AMST_VERTEX));
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void unusable_corners_leave_the_patch(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 10, 10);
    amst_patches *set = NULL;
    amst_report *report = NULL;
    const amst_id inside[3] = {24, 27, 36};
    const int64_t before = checksum(mesh);
    must(amst_patches_create(mesh, NULL, &set));
    add_square(set, 10, 2, 5);
    must(amst_patches_set_corners(set, 0, inside, 3));
    assert_int_equal(amst_adapt(mesh, set, 2, NULL, &report), AMST_PARTIAL);
    assert_int_equal(result(report, 0, AMST_RESULT_STATUS), AMST_ERR_PATCH);
    assert_true(checksum(mesh) == before);
    amst_report_destroy(report);
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void given_corners_are_used(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 12, 12);
    amst_patches *set = NULL;
    const amst_id corners[4] = {2 * 13 + 2, 2 * 13 + 10, 10 * 13 + 10, 10 * 13 + 2};
    must(amst_patches_create(mesh, NULL, &set));
    add_square(set, 12, 2, 10);
    must(amst_patches_set_corners(set, 0, corners, 4));
    assert_true(amst_adapt(mesh, set, 2, NULL, NULL) >= 0);
    must(amst_mesh_check(mesh));
    amst_id kept[4];
    int64_t n;
    double *points = points_of(mesh);
    must(amst_patches_get_corners(set, 0, kept, 4, &n)); /* renumbered perhaps, but in place */
    assert_int_equal(n, 4);
    for (int i = 0; i < 4; ++i) {
        assert_true(points[2 * kept[i]] == corners[i] % 13);
        assert_true(points[2 * kept[i] + 1] == corners[i] / 13);
    }
    free(points);
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void bad_arguments_change_nothing(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 10, 10), *other = NULL;
    amst_patches *set = NULL, *of_other = NULL;
    amst_report *report = NULL;
    const int64_t before = checksum(mesh);
    must(amst_mesh_clone(mesh, &other));
    must(amst_patches_create(mesh, NULL, &set));
    must(amst_patches_create(other, NULL, &of_other));
    add_square(set, 10, 2, 5);
    add_square(of_other, 10, 2, 5);
    refused(AMST_ERR_ARGUMENT, amst_adapt(mesh, of_other, 2, NULL, &report));
    refused(AMST_ERR_ARGUMENT, amst_reduce_singularities(mesh, of_other, NULL, &report));
    refused(AMST_ERR_ARGUMENT, amst_smooth(mesh, of_other, NULL, &report));
    refused(AMST_ERR_ARGUMENT, amst_adapt(mesh, set, 0, NULL, &report));
    refused(AMST_ERR_ARGUMENT, amst_adapt(mesh, set, -1, NULL, &report));
    refused(AMST_ERR_NOT_FINITE, amst_adapt(mesh, set, NAN, NULL, &report));
    refused(AMST_ERR_NOT_FINITE, amst_adapt(mesh, set, INFINITY, NULL, &report));
    refused(AMST_ERR_ARGUMENT, amst_adapt(mesh, NULL, 0, NULL, &report));
    refused(AMST_ERR_NULL, amst_adapt(NULL, set, 2, NULL, &report));
    assert_null(report);
    assert_true(checksum(mesh) == before);
    assert_int_equal(revision(mesh), 0);
    amst_patches_destroy(set);
    amst_patches_destroy(of_other);
    amst_mesh_destroy(other);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void an_empty_set_is_no_change(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 10, 10);
    amst_patches *set = NULL;
    amst_report *report = NULL;
    const int64_t before = checksum(mesh);
    must(amst_patches_create(mesh, NULL, &set));
    must(amst_adapt(mesh, set, 2, NULL, &report));
    assert_true(checksum(mesh) == before);
    assert_int_equal(revision(mesh), 0);
    assert_int_equal(result(report, AMST_ALL, AMST_RESULT_FACES_AFTER), 0);
    assert_true(real_result(report, AMST_ALL, AMST_RESULT_ALPHA) == 1);
    amst_report_destroy(report);
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static int64_t adapted_digest(int32_t threads) {
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 20, 20);
    amst_options *options = NULL;
    amst_patches *set = NULL;
    must(amst_context_set_threads(ctx, threads));
    must(amst_options_create(&options));
    must(amst_options_set_real(options, AMST_OPT_PATCH_FACES, 40));
    must(amst_patches_create(mesh, options, &set));
    must(amst_patches_decompose(set, AMST_DECOMPOSE_CLUSTERS, NULL));
    assert_true(amst_adapt(mesh, set, 1.5, options, NULL) >= 0);
    must(amst_mesh_check(mesh));
    const int64_t digest = checksum(mesh);
    amst_patches_destroy(set);
    amst_options_destroy(options);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
    return digest;
}

static void equal_for_any_number_of_threads(void **state) {
    (void)state;
    const int64_t one = adapted_digest(1);
    assert_true(adapted_digest(1) == one);
    assert_true(adapted_digest(2) == one);
    assert_true(adapted_digest(8) == one);
    assert_true(adapted_digest(0) == one);
}

/* More threads than cores: the thread library would say so on stderr. */
static void nothing_is_printed(void **state) {
    (void)state;
    FILE *file = tmpfile();
    assert_non_null(file);
    fflush(stdout);
    fflush(stderr);
    const int out = dup(STDOUT_FILENO), err = dup(STDERR_FILENO);
    assert_true(dup2(fileno(file), STDOUT_FILENO) >= 0 && dup2(fileno(file), STDERR_FILENO) >= 0);
    adapted_digest(64);
    fflush(stdout);
    fflush(stderr);
    const off_t printed = lseek(fileno(file), 0, SEEK_END);
    assert_true(dup2(out, STDOUT_FILENO) >= 0 && dup2(err, STDERR_FILENO) >= 0);
    close(out);
    close(err);
    fclose(file);
    assert_int_equal(printed, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_is_printed), /* first: it is said once only */
        cmocka_unit_test(counts_are_exact_and_the_outside_is_untouched),
        cmocka_unit_test(simplification_delivers_or_leaves),
        cmocka_unit_test(each_patch_may_have_its_own_alpha),
        cmocka_unit_test(the_set_moves_along),
        cmocka_unit_test(what_cannot_be_adapted_is_left),
        cmocka_unit_test(a_ring_with_wished_sizes_gets_its_count),
        cmocka_unit_test(unusable_corners_leave_the_patch),
        cmocka_unit_test(given_corners_are_used),
        cmocka_unit_test(bad_arguments_change_nothing),
        cmocka_unit_test(an_empty_set_is_no_change),
        cmocka_unit_test(equal_for_any_number_of_threads),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
