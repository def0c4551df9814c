/* Every long call tells its progress and can be stopped, also inside one patch; what could never end is
 * refused. Counted are calls of the progress function, not times. */
#include "grid.h"

enum { side = 48 };

typedef struct {
    amst_context *ctx;
    amst_mesh *mesh;
    amst_patches *set;
    int calls, last; /* the call that says stop, 0: none */
    int asks;        /* whether it asks the library something */
    double fraction;
} world;

static int32_t progress(void *user, double fraction, const char *stage) {
    world *w = user;
    assert_non_null(stage);
    assert_true(fraction >= w->fraction && fraction <= 1);
    w->fraction = fraction;
    if (w->asks) {
        amst_summary summary;
        int64_t needed = 0;
        must(amst_mesh_get_summary(w->mesh, AMST_METRIC_SHAPE, &summary));
        must(amst_mesh_get_chord_ids(w->mesh, NULL, NULL, 0, &needed));
    }
    return ++w->calls == w->last;
}

static int setup(void **state) {
    world *w = memory(sizeof *w);
    memset(w, 0, sizeof *w);
    w->ctx = new_context(0);
    w->mesh = new_grid(w->ctx, 0, side, side);
    must(amst_patches_create(w->mesh, NULL, &w->set));
    must(amst_context_set_progress(w->ctx, progress, w));
    *state = w;
    return 0;
}

static int teardown(void **state) {
    world *w = *state;
    amst_patches_destroy(w->set);
    amst_mesh_destroy(w->mesh);
    amst_context_destroy(w->ctx);
    free(w);
    return 0;
}

static void begin(world *w, int last) {
    w->calls = 0;
    w->last = last;
    w->fraction = 0;
}

static int64_t n_patches(const world *w) {
    int64_t count = 0;
    must(amst_patches_get_count(w->set, &count));
    return count;
}

static void decompositions_can_be_stopped(void **state) {
    world *w = *state;
    for (int32_t method = AMST_DECOMPOSE_CLUSTERS; method <= AMST_DECOMPOSE_MEDIAL; ++method) {
        begin(w, 0);
        must(amst_patches_decompose(w->set, method, NULL));
        const int calls = w->calls;
        assert_true(calls >= 8); /* of each 2,000 nodes that are reached, and of each patch */
        assert_true(w->fraction == 1);
        amst_patches_destroy(w->set);
        must(amst_patches_create(w->mesh, NULL, &w->set));
        for (int last = 1; last < calls; last += 1 + calls / 7) {
            begin(w, last);
            refused(AMST_ERR_CANCELLED, amst_patches_decompose(w->set, method, NULL));
            assert_int_equal(w->calls, last);
            assert_int_equal(n_patches(w), 0);
        }
    }
    begin(w, 0);
    must(amst_patches_decompose(w->set, AMST_DECOMPOSE_SINGULARITIES, NULL));
    assert_true(w->calls >= 2);
    must(amst_context_set_cancel(w->ctx, 1));
    begin(w, 0);
    refused(AMST_ERR_CANCELLED, amst_patches_decompose(w->set, AMST_DECOMPOSE_PARTITION, NULL));
    must(amst_context_set_cancel(w->ctx, 0));
}

static void the_cross_field_can_be_stopped(void **state) {
    world *w = *state;
    begin(w, 0);
    must(amst_mesh_compute_cross_field(w->mesh, NULL));
    const int calls = w->calls;
    assert_true(calls >= 20);
    must(amst_mesh_remove_field(w->mesh, AMST_FACE, "cross"));
    begin(w, calls / 2);
    refused(AMST_ERR_CANCELLED, amst_mesh_compute_cross_field(w->mesh, NULL));
    int64_t n = 0;
    refused(AMST_ERR_NOT_FOUND, amst_mesh_get_field(w->mesh, AMST_FACE, "cross", NULL, 0, &n));
}

static void one_patch_can_be_stopped(void **state) {
    world *w = *state;
    const int64_t before = checksum(w->mesh);
    amst_options *options = NULL;
    must(amst_options_create(&options));
    must(amst_options_set_int(options, AMST_OPT_EDIT_BOUNDARY, 1));
    add_square(w->set, side, 20, 28);
    for (int32_t threads = 1; threads <= 2; ++threads) {
        must(amst_context_set_threads(w->ctx, threads));
        begin(w, 12);
        refused(AMST_ERR_CANCELLED, amst_adapt(w->mesh, w->set, 20, NULL, NULL));
        assert_int_equal(w->calls, 12);
        begin(w, 12);
        refused(AMST_ERR_CANCELLED, amst_insert_chords(w->mesh, w->set, 60, NULL, NULL));
        begin(w, 12);
        refused(AMST_ERR_CANCELLED, amst_split_chord(w->mesh, 0, 200, options, NULL));
        assert_int_equal(checksum(w->mesh), before);
    }
    amst_options_destroy(options);
}

static void questions_of_a_callback_are_not_stopped(void **state) {
    world *w = *state;
    add_square(w->set, side, 20, 28);
    w->asks = 1;
    begin(w, 0);
    must(amst_patches_decompose(w->set, AMST_DECOMPOSE_CLUSTERS, NULL));
    begin(w, 12);
    refused(AMST_ERR_CANCELLED, amst_adapt(w->mesh, w->set, 20, NULL, NULL));
}

static void what_could_not_end_is_refused(void **state) {
    world *w = *state;
    const int64_t before = checksum(w->mesh);
    const double alphas[] = {1e4, 1e9, 1e300};
    amst_id patch = -1;
    add_square(w->set, side, 2, 4);
    must(amst_patches_set_alpha(w->set, 0, 1));
    add_square(w->set, side, 20, 28);
    for (int k = 0; k < 3; ++k) {
        refused(AMST_ERR_RANGE, amst_adapt(w->mesh, w->set, alphas[k], NULL, NULL));
        must(amst_last_error_where(NULL, NULL, &patch));
        assert_int_equal(patch, 1);
        refused(AMST_ERR_RANGE, amst_patches_predict(w->set, 1, alphas[k], NULL, NULL, NULL));
    }
    refused(AMST_ERR_RANGE, amst_adapt(w->mesh, NULL, 1e6, NULL, NULL));
    refused(AMST_ERR_RANGE, amst_adapt(w->mesh, NULL, 1e300, NULL, NULL));
    refused(AMST_ERR_RANGE, amst_split_chord(w->mesh, 0, 1000000, NULL, NULL));
    refused(AMST_ERR_RANGE, amst_insert_chords(w->mesh, w->set, 100000, NULL, NULL));
    assert_int_equal(checksum(w->mesh), before);
}

static void starts_tell_and_can_be_stopped(void **state) {
    world *w = *state;
    const int64_t before = checksum(w->mesh);
    amst_options *options = NULL;
    amst_patches_destroy(w->set);
    w->set = NULL;
    must(amst_options_create(&options));
    must(amst_options_set_int(options, AMST_OPT_STARTS, 3));
    must(amst_options_set_real(options, AMST_OPT_EFFORT, 0.01));
    for (int threads = 1; threads <= 2; ++threads) {
        must(amst_context_set_threads(w->ctx, threads));
        for (int last = 1; last <= 40; last += 13) {
            begin(w, last);
            refused(AMST_ERR_CANCELLED, amst_adapt(w->mesh, NULL, 1.1, options, NULL));
            assert_int_equal(w->calls, last);
            assert_int_equal(checksum(w->mesh), before);
        }
    }
    amst_options_destroy(options);
}

#define test(name) cmocka_unit_test_setup_teardown(name, setup, teardown)

int main(void) {
    const struct CMUnitTest tests[] = {
        test(decompositions_can_be_stopped), test(the_cross_field_can_be_stopped),
        test(one_patch_can_be_stopped),      test(questions_of_a_callback_are_not_stopped),
        test(what_could_not_end_is_refused), test(starts_tell_and_can_be_stopped),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
