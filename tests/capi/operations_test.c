/* What the operations have in common: their names, whole mesh or patches, and their reports. */
#include "grid.h"

enum { n = 10 };

static amst_context *ctx;
static amst_mesh *mesh;
static amst_patches *set;
static char last_message[256];

static void keep_message(void *user, int32_t level, const char *message) {
    (void)user;
    if (level == AMST_LOG_INFO) {
        strncpy(last_message, message, sizeof last_message - 1);
        last_message[sizeof last_message - 1] = '\0';
    }
}

static int setup(void **state) {
    (void)state;
    ctx = new_context(0);
    mesh = new_grid(ctx, 0, n, n);
    must(amst_patches_create(mesh, NULL, &set));
    add_square(set, n, 1, 4);
    add_square(set, n, 5, 9);
    return 0;
}

static int teardown(void **state) {
    (void)state;
    amst_patches_destroy(set);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
    return 0;
}

static void assert_told(const char *start) { assert_memory_equal(last_message, start, strlen(start)); }

static void each_tells_its_name(void **state) {
    (void)state;
    must(amst_context_set_log(ctx, AMST_LOG_INFO, keep_message, NULL));
    must(amst_adapt(mesh, set, 1, NULL, NULL));
    assert_told("adapt: 25 faces before, 25 after");
    must(amst_reduce_singularities(mesh, set, NULL, NULL));
    assert_told("reduce_singularities: 25 faces before, 25 after");
    must(amst_smooth(mesh, set, NULL, NULL));
    assert_told("smooth: 25 faces before, 25 after");
    must(amst_clean(mesh, NULL, NULL));
    assert_told("clean: 100 faces before, 100 after");
}

/* A row of the report for each patch, and none for the whole mesh. */
static void patches_have_rows(void **state) {
    (void)state;
    amst_report *report = NULL;
    int64_t value;
    must(amst_adapt(mesh, set, 2, NULL, &report));
    assert_int_equal(result(report, 0, AMST_RESULT_FACES_WANTED), 18);
    assert_int_equal(result(report, 1, AMST_RESULT_FACES_WANTED), 32);
    assert_int_equal(result(report, AMST_ALL, AMST_RESULT_FACES_AFTER), 50);
    assert_int_equal(count_of(mesh, AMST_FACE), 125);
    amst_report_destroy(report);
    must(amst_reduce_singularities(mesh, set, NULL, &report));
    assert_int_equal(result(report, 1, AMST_RESULT_FACES_BEFORE), 32);
    assert_int_equal(result(report, 1, AMST_RESULT_SINGULAR_AFTER), 0);
    assert_int_equal(n_singular(mesh), 0);
    amst_report_destroy(report);
    must(amst_smooth(mesh, NULL, NULL, &report));
    assert_int_equal(result(report, AMST_ALL, AMST_RESULT_FACES_BEFORE), count_of(mesh, AMST_FACE));
    refused(AMST_ERR_RANGE, amst_report_get_int(report, 0, AMST_RESULT_STATUS, &value));
    amst_report_destroy(report);
}

/* By windows the whole mesh gets the wanted faces; whole chords alone make no vertex singular. */
static void the_strategy_is_for_whole_meshes(void **state) {
    (void)state;
    amst_options *options = NULL;
    amst_mesh *by_chords = NULL;
    must(amst_options_create(&options));
    must(amst_options_set_int(options, AMST_OPT_STRATEGY, 1));
    must(amst_options_set_int(options, AMST_OPT_EDIT_BOUNDARY, 1));
    must(amst_mesh_clone(mesh, &by_chords));
    must(amst_adapt(by_chords, NULL, 0.9, options, NULL));
    assert_int_equal(count_of(by_chords, AMST_FACE), 90);
    assert_int_equal(n_singular(by_chords), 0);
    must(amst_adapt(mesh, set, 2, options, NULL)); /* patches have no strategy */
    assert_int_equal(count_of(mesh, AMST_FACE), 125);
    amst_options_destroy(options);
    amst_mesh_destroy(by_chords);
}

/* Faces that are wanted are a promise of amst_adapt alone. */
static void a_patch_left_makes_the_result_partial(void **state) {
    (void)state;
    amst_report *report = NULL;
    const amst_id corners[3] = {1 * (n + 1) + 1, 1 * (n + 1) + 2, 1 * (n + 1) + 3};
    must(amst_patches_set_corners(set, 0, corners, 3));
    assert_int_equal(amst_adapt(mesh, set, 0.01, NULL, &report), AMST_PARTIAL);
    assert_true(result(report, AMST_ALL, AMST_RESULT_STATUS) == AMST_PARTIAL);
    assert_true(result(report, 0, AMST_RESULT_STATUS) != AMST_OK);
    amst_report_destroy(report);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(each_tells_its_name, setup, teardown),
        cmocka_unit_test_setup_teardown(patches_have_rows, setup, teardown),
        cmocka_unit_test_setup_teardown(the_strategy_is_for_whole_meshes, setup, teardown),
        cmocka_unit_test_setup_teardown(a_patch_left_makes_the_result_partial, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
