/* Index base, threads, and what may happen while an operation runs. */
#define _POSIX_C_SOURCE 200809L
#include <pthread.h>

#include "grid.h"

typedef struct world {
    amst_context *ctx;
    amst_mesh *mesh;
    amst_patches *set;
    pthread_t caller;
    int calls, stop_at;
    double last;
    int64_t before;
} world;

static world new_world(void) {
    world w = {0};
    w.ctx = new_context(0);
    w.mesh = new_grid(w.ctx, 0, 10, 10);
    must(amst_patches_create(w.mesh, NULL, &w.set));
    add_square(w.set, 10, 1, 5);
    add_square(w.set, 10, 5, 9);
    w.before = checksum(w.mesh);
    w.caller = pthread_self();
    w.stop_at = -1;
    return w;
}

static void end_world(world *w) {
    amst_patches_destroy(w->set);
    amst_mesh_destroy(w->mesh);
    amst_context_destroy(w->ctx);
}

static void index_base_is_0_or_1(void **state) {
    (void)state;
    amst_context *ctx = NULL;
    refused(AMST_ERR_ARGUMENT, amst_context_create(2, &ctx));
    refused(AMST_ERR_ARGUMENT, amst_context_create(-1, &ctx));
    assert_null(ctx);
    refused(AMST_ERR_NULL, amst_context_create(0, NULL));
}

static void levels_and_threads_have_ranges(void **state) {
    (void)state;
    amst_context *ctx = new_context(0);
    must(amst_context_set_threads(ctx, 0));
    must(amst_context_set_threads(ctx, 8));
    refused(AMST_ERR_RANGE, amst_context_set_threads(ctx, -1));
    must(amst_context_set_log(ctx, AMST_LOG_OFF, NULL, NULL));
    must(amst_context_set_log(ctx, AMST_LOG_DEBUG, NULL, NULL));
    refused(AMST_ERR_ARGUMENT, amst_context_set_log(ctx, AMST_LOG_DEBUG + 1, NULL, NULL));
    refused(AMST_ERR_ARGUMENT, amst_context_set_log(ctx, AMST_LOG_OFF - 1, NULL, NULL));
    amst_context_destroy(ctx);
}

static int32_t watch(void *user, double fraction, const char *stage) {
    world *w = user;
    double polled = -1;
    assert_true(pthread_equal(pthread_self(), w->caller));
    assert_true(fraction >= 0 && fraction <= 1);
    assert_true(fraction >= w->last);
    assert_non_null(stage);
    assert_true(strlen(stage) > 0);
    must(amst_context_get_progress(w->ctx, &polled));
    assert_true(polled == fraction);
    w->last = fraction;
    return w->calls++ == w->stop_at;
}

static void progress_rises_on_the_calling_thread(void **state) {
    (void)state;
    world w = new_world();
    must(amst_context_set_threads(w.ctx, 2));
    must(amst_context_set_progress(w.ctx, watch, &w));
    assert_true(amst_adapt(w.mesh, w.set, 2, NULL, NULL) >= 0);
    assert_true(w.calls >= 2);
    assert_true(w.last == 1);
    const int calls = w.calls;
    must(amst_context_set_progress(w.ctx, NULL, NULL));
    assert_true(amst_adapt(w.mesh, w.set, 1, NULL, NULL) >= 0);
    assert_int_equal(w.calls, calls);
    end_world(&w);
}

static void cancelling_at_any_call_changes_nothing(void **state) {
    (void)state;
    world w = new_world();
    must(amst_context_set_progress(w.ctx, watch, &w));
    amst_status status = AMST_ERR_CANCELLED;
    int stops = 0;
    for (int n = 0; status == AMST_ERR_CANCELLED; ++n) {
        amst_report *report = NULL;
        w.calls = 0;
        w.last = 0;
        w.stop_at = n;
        status = amst_adapt(w.mesh, w.set, 2, NULL, &report);
        if (status == AMST_ERR_CANCELLED) {
            ++stops;
            assert_null(report);
            assert_true(checksum(w.mesh) == w.before);
            assert_int_equal(revision(w.mesh), 0);
            int64_t faces = 0;
            must(amst_patches_get_faces(w.set, 0, NULL, 0, &faces));
            assert_int_equal(faces, 16);
        }
        amst_report_destroy(report);
    }
    assert_true(status >= 0);
    assert_int_equal(stops, w.calls);
    assert_true(stops >= 2);
    end_world(&w);
}

static void a_raised_flag_stops_until_lowered(void **state) {
    (void)state;
    world w = new_world();
    must(amst_context_set_cancel(w.ctx, 1));
    refused(AMST_ERR_CANCELLED, amst_adapt(w.mesh, w.set, 2, NULL, NULL));
    refused(AMST_ERR_CANCELLED, amst_reduce_singularities(w.mesh, w.set, NULL, NULL));
    refused(AMST_ERR_CANCELLED, amst_smooth(w.mesh, NULL, NULL, NULL));
    refused(AMST_ERR_CANCELLED, amst_clean(w.mesh, NULL, NULL));
    assert_true(checksum(w.mesh) == w.before);
    must(amst_context_set_cancel(w.ctx, 0));
    must(amst_smooth(w.mesh, NULL, NULL, NULL));
    end_world(&w);
}

static int32_t raise_flag(void *user, double fraction, const char *stage) {
    (void)fraction;
    (void)stage;
    must(amst_context_set_cancel(((world *)user)->ctx, 1));
    return 0;
}

static void the_flag_may_be_raised_in_a_callback(void **state) {
    (void)state;
    world w = new_world();
    must(amst_context_set_progress(w.ctx, raise_flag, &w));
    refused(AMST_ERR_CANCELLED, amst_smooth(w.mesh, NULL, NULL, NULL));
    assert_true(checksum(w.mesh) == w.before);
    end_world(&w);
}

static int32_t meddle(void *user, double fraction, const char *stage) {
    world *w = user;
    const double points[2] = {0, 0};
    const amst_id face = 0;
    int64_t number;
    (void)fraction;
    (void)stage;
    ++w->calls;
    refused(AMST_ERR_STATE, amst_adapt(w->mesh, w->set, 2, NULL, NULL));
    refused(AMST_ERR_STATE, amst_reduce_singularities(w->mesh, w->set, NULL, NULL));
    refused(AMST_ERR_STATE, amst_smooth(w->mesh, NULL, NULL, NULL));
    refused(AMST_ERR_STATE, amst_clean(w->mesh, NULL, NULL));
    refused(AMST_ERR_STATE, amst_mesh_set_points(w->mesh, points, 1));
    refused(AMST_ERR_STATE, amst_mesh_set_flags(w->mesh, AMST_FACE, NULL, 0, 1, 1));
    refused(AMST_ERR_STATE, amst_mesh_set_markers(w->mesh, AMST_FACE, NULL, 0, 1));
    refused(AMST_ERR_STATE, amst_mesh_set_marker_name(w->mesh, AMST_FACE, 1, "a"));
    refused(AMST_ERR_STATE, amst_mesh_detect_features(w->mesh, 30, NULL));
    refused(AMST_ERR_STATE, amst_mesh_compute_cross_field(w->mesh, NULL));
    refused(AMST_ERR_STATE, amst_mesh_set_surface(w->mesh, NULL, 0, NULL, 0));
    refused(AMST_ERR_STATE, amst_mesh_mark(w->mesh, &number));
    refused(AMST_ERR_STATE, amst_mesh_rollback(w->mesh, 0));
    refused(AMST_ERR_STATE, amst_mesh_forget(w->mesh, 0));
    refused(AMST_ERR_STATE, amst_patches_add_faces(w->set, &face, 1, NULL));
    refused(AMST_ERR_STATE, amst_patches_add_rings(w->set, 0, 1, NULL));
    refused(AMST_ERR_STATE, amst_patches_decompose(w->set, AMST_DECOMPOSE_CLUSTERS, NULL));
    refused(AMST_ERR_STATE, amst_patches_set_alpha(w->set, 0, 1));
    refused(AMST_ERR_STATE, amst_patches_set_corners(w->set, 0, NULL, 0));
    refused(AMST_ERR_STATE, amst_context_set_threads(w->ctx, 1));
    refused(AMST_ERR_STATE, amst_context_set_progress(w->ctx, NULL, NULL));
    refused(AMST_ERR_STATE, amst_context_set_log(w->ctx, AMST_LOG_OFF, NULL, NULL));
    must(amst_mesh_check(w->mesh)); /* asking is allowed, and sees the mesh as it was */
    assert_true(checksum(w->mesh) == w->before);
    must(amst_patches_get_count(w->set, &number));
    assert_int_equal(number, 2);
    amst_mesh *copy = NULL;
    must(amst_mesh_clone(w->mesh, &copy));
    amst_mesh_destroy(copy);
    return 0;
}

static void callbacks_may_ask_but_not_change(void **state) {
    (void)state;
    world w = new_world();
    must(amst_context_set_progress(w.ctx, meddle, &w));
    assert_true(amst_adapt(w.mesh, w.set, 2, NULL, NULL) >= 0);
    assert_true(w.calls > 0);
    must(amst_context_set_progress(w.ctx, NULL, NULL)); /* idle again */
    end_world(&w);
}

static int32_t destroy_all(void *user, double fraction, const char *stage) {
    world *w = user;
    (void)fraction;
    (void)stage;
    end_world(w);
    w->set = NULL;
    w->mesh = NULL;
    w->ctx = NULL;
    return 0;
}

static void handles_may_end_in_a_callback(void **state) {
    (void)state;
    world w = new_world();
    amst_report *report = NULL;
    must(amst_context_set_progress(w.ctx, destroy_all, &w));
    assert_true(amst_adapt(w.mesh, w.set, 2, NULL, &report) >= 0);
    assert_int_equal(result(report, 0, AMST_RESULT_FACES_BEFORE), 16);
    amst_report_destroy(report);
}

static void listen(void *user, int32_t level, const char *message) {
    world *w = user;
    assert_true(pthread_equal(pthread_self(), w->caller));
    assert_in_range(level, AMST_LOG_ERROR, AMST_LOG_INFO);
    assert_true(strlen(message) > 0);
    ++w->calls;
}

static void log_speaks_up_to_its_level(void **state) {
    (void)state;
    world w = new_world();
    must(amst_context_set_log(w.ctx, AMST_LOG_INFO, listen, &w));
    must(amst_smooth(w.mesh, NULL, NULL, NULL));
    const int calls = w.calls;
    assert_true(calls > 0);
    must(amst_context_set_log(w.ctx, AMST_LOG_OFF, listen, &w));
    must(amst_smooth(w.mesh, NULL, NULL, NULL));
    assert_int_equal(w.calls, calls);
    end_world(&w);
}

static void stop_at_a_message(void *user, int32_t level, const char *message) {
    (void)level;
    (void)message;
    must(amst_context_set_cancel(((world *)user)->ctx, 1));
}

static void a_log_function_may_cancel(void **state) {
    (void)state;
    world w = new_world();
    must(amst_context_set_log(w.ctx, AMST_LOG_DEBUG, stop_at_a_message, &w));
    refused(AMST_ERR_CANCELLED, amst_adapt(w.mesh, w.set, 2, NULL, NULL));
    assert_true(checksum(w.mesh) == w.before);
    end_world(&w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(index_base_is_0_or_1),
        cmocka_unit_test(levels_and_threads_have_ranges),
        cmocka_unit_test(progress_rises_on_the_calling_thread),
        cmocka_unit_test(cancelling_at_any_call_changes_nothing),
        cmocka_unit_test(a_raised_flag_stops_until_lowered),
        cmocka_unit_test(the_flag_may_be_raised_in_a_callback),
        cmocka_unit_test(callbacks_may_ask_but_not_change),
        cmocka_unit_test(handles_may_end_in_a_callback),
        cmocka_unit_test(log_speaks_up_to_its_level),
        cmocka_unit_test(a_log_function_may_cancel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
