/* Threads of the caller: each works on a clone of one mesh in a context of its own. */
#include <pthread.h>

#include "grid.h"

enum { n_threads = 4, n = 12 };

typedef struct worker {
    amst_context *ctx;
    amst_mesh *mesh;
    int64_t digest;
    amst_status status;
} worker;

static void *adapt(void *user) {
    worker *w = user;
    w->status = amst_adapt(w->mesh, NULL, 2, NULL, NULL);
    if (w->status >= AMST_OK)
        w->status = amst_mesh_get_checksum(w->mesh, &w->digest);
    return NULL;
}

static void clones_are_adapted_at_the_same_time(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, n, n);
    const int64_t before = checksum(mesh);
    const double size = 1;
    double *sizes = memory((n + 1) * (n + 1) * sizeof *sizes);
    for (int v = 0; v < (n + 1) * (n + 1); ++v)
        sizes[v] = size + 0.05 * (v % (n + 1));
    must(amst_mesh_set_field(mesh, AMST_VERTEX, "size", 1, AMST_CARRY_LINEAR, sizes, (n + 1) * (n + 1)));
    free(sizes);
    worker workers[n_threads];
    pthread_t threads[n_threads];
    for (int i = 0; i < n_threads; ++i) {
        workers[i].ctx = new_context(i % 2);
        must(amst_context_set_threads(workers[i].ctx, 1 + i / 2));
        must(amst_mesh_clone_into(mesh, workers[i].ctx, &workers[i].mesh));
    }
    for (int i = 0; i < n_threads; ++i)
        assert_int_equal(pthread_create(&threads[i], NULL, adapt, &workers[i]), 0);
    for (int i = 0; i < n_threads; ++i) {
        assert_int_equal(pthread_join(threads[i], NULL), 0);
        must(workers[i].status);
        assert_true(workers[i].digest == workers[0].digest);
        amst_context_destroy(workers[i].ctx);
        amst_mesh_destroy(workers[i].mesh);
    }
    assert_true(workers[0].digest != before);
    assert_true(checksum(mesh) == before);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void a_clone_has_all_but_savepoints_and_numbers_from_its_own_base(void **state) {
    (void)state;
    amst_context *zero = new_context(0), *one = new_context(1);
    amst_mesh *mesh = new_grid(zero, 0, 3, 3), *clone = NULL;
    const amst_id edges[] = {0, 1};
    int64_t revision, needed;
    int32_t markers[24];
    must(amst_mesh_set_markers(mesh, AMST_EDGE, edges, 2, 7));
    must(amst_mesh_mark(mesh, &revision));
    must(amst_mesh_clone_into(mesh, one, &clone));
    assert_true(checksum(clone) == checksum(mesh));
    amst_mesh_destroy(mesh);
    amst_context_destroy(zero); /* the clone has nothing of it */
    amst_id faces[36];
    must(amst_mesh_get_faces(clone, faces, 36, &needed));
    assert_int_equal(faces[0], 1);
    must(amst_mesh_get_markers(clone, AMST_EDGE, markers, 24, &needed));
    assert_int_equal(markers[0], 7);
    assert_int_equal(markers[2], 0);
    refused(AMST_ERR_NOT_FOUND, amst_mesh_rollback(clone, revision));
    amst_mesh_destroy(clone);
    amst_context_destroy(one);
}

static int32_t no_projection(void *user, int64_t count, const int32_t *marker, const double *points,
                             double *projected) {
    (void)count, (void)marker, (void)points, (void)projected;
    ++*(int *)user;
    return 1;
}

static void the_projection_stays_behind(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    amst_mesh *mesh = new_grid(ctx, 0, 4, 4), *clone = NULL;
    amst_options *options = NULL;
    int calls = 0;
    must(amst_options_create(&options));
    must(amst_options_set_int(options, AMST_OPT_EDIT_BOUNDARY, 1));
    must(amst_mesh_set_projection(mesh, no_projection, &calls));
    must(amst_mesh_clone_into(mesh, ctx, &clone));
    assert_true(amst_adapt(clone, NULL, 2, options, NULL) >= AMST_OK);
    assert_int_equal(calls, 0);
    amst_mesh_destroy(clone);
    must(amst_mesh_clone(mesh, &clone));
    refused(AMST_ERR_PROJECTION, amst_adapt(clone, NULL, 2, options, NULL));
    assert_int_equal(calls, 1);
    amst_options_destroy(options);
    amst_mesh_destroy(clone);
    amst_mesh_destroy(mesh);
    amst_context_destroy(ctx);
}

static void *change_flags(void *user) {
    worker *w = user;
    w->status = amst_mesh_set_flags(w->mesh, AMST_FACE, NULL, 0, AMST_FLAG_FIXED, AMST_FLAG_FIXED);
    assert_non_null(strstr(amst_last_error(), "on another thread"));
    assert_non_null(strstr(amst_last_error(), "amst_mesh_clone_into"));
    return NULL;
}

static int32_t start_another(void *user, double fraction, const char *stage) {
    (void)fraction, (void)stage;
    pthread_t thread;
    assert_int_equal(pthread_create(&thread, NULL, change_flags, user), 0);
    assert_int_equal(pthread_join(thread, NULL), 0);
    return 0;
}

static void who_shares_a_context_is_told(void **state) {
    (void)state;
    worker w = {.ctx = new_context(0)};
    w.mesh = new_grid(w.ctx, 0, 4, 4);
    must(amst_context_set_progress(w.ctx, start_another, &w));
    must(amst_smooth(w.mesh, NULL, NULL, NULL));
    assert_int_equal(w.status, AMST_ERR_STATE);
    amst_mesh_destroy(w.mesh);
    amst_context_destroy(w.ctx);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(clones_are_adapted_at_the_same_time),
        cmocka_unit_test(a_clone_has_all_but_savepoints_and_numbers_from_its_own_base),
        cmocka_unit_test(the_projection_stays_behind),
        cmocka_unit_test(who_shares_a_context_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
